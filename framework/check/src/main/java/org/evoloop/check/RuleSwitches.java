package org.evoloop.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;

/**
 * The rules that are switched off in a file of properties.
 *
 * <p>Threading: immutable.
 *
 * @param rest the rest of the file's text, with unchanged line numbers
 * @since 0.1
 */
public record RuleSwitches(String file, List<RuleSwitch> all, String rest) {
    public RuleSwitches {
        all = List.copyOf(all);
    }

    /** None. */
    public static RuleSwitches none() {
        return new RuleSwitches("", List.of(), "");
    }

    /**
     * Parses a file's text.
     *
     * @param file for messages
     * @throws ModelException naming file, line and remedy of everything that cannot be understood
     */
    public static RuleSwitches parse(String file, String text, ModelPair pair) {
        List<RuleSwitch> switches = new ArrayList<>();
        List<String> problems = new ArrayList<>();
        StringBuilder rest = new StringBuilder();
        List<String> lines = text.lines().toList();
        for (int first = 0; first < lines.size(); ) {
            int end = first + 1;
            while (end < lines.size() && continues(lines.get(end))) {
                end++;
            }
            List<String> together = lines.subList(first, end);
            try {
                Optional<RuleSwitch> found = RuleSwitch.parse(
                        String.join(" ", together).strip().replaceAll("\\s+", " "),
                        first + 1,
                        name -> isElement(name, pair));
                found.ifPresent(switches::add);
                together.forEach(
                        line -> rest.append(found.isPresent() ? "" : line).append('\n'));
            } catch (ModelException problem) {
                problems.add(file + ", line " + (first + 1) + ": " + problem.getMessage());
            }
            first = end;
        }
        if (!problems.isEmpty()) {
            throw new ModelException(String.join("\n", problems));
        }
        return new RuleSwitches(file, switches, rest.toString());
    }

    private static boolean continues(String line) {
        return !line.isBlank()
                && Character.isWhitespace(line.charAt(0))
                && !line.strip().startsWith("#");
    }

    private static boolean isElement(String name, ModelPair pair) {
        return has(pair.original(), name) || has(pair.evolved(), name);
    }

    private static boolean has(StateMachine machine, String name) {
        return machine.states().stream().anyMatch(state -> state.name().equals(name))
                || machine.events().stream()
                        .anyMatch(event -> event.toString().equals(name)
                                || event.trigger().toString().equals(name))
                || machine.transitions().stream()
                        .anyMatch(transition -> transition.toString().equals(name));
    }

    /** The findings that no switch matches. */
    public List<Finding> left(List<Finding> findings) {
        return findings.stream().filter(finding -> switchOf(finding).isEmpty()).toList();
    }

    /** The switched-off ones of {@code findings}. */
    public List<SwitchedOff> off(List<Finding> findings) {
        return findings.stream()
                .flatMap(finding ->
                        switchOf(finding)
                                .map(by -> new SwitchedOff(finding, by.reason(), file + ", line " + by.line()))
                                .stream())
                .toList();
    }

    private Optional<RuleSwitch> switchOf(Finding finding) {
        return all.stream().filter(each -> each.concerns(finding)).findFirst();
    }

    /** A message for each switch that matches none of {@code findings}. */
    public List<String> useless(List<Finding> findings) {
        return all.stream()
                .filter(each -> each.isAlwaysJudged() && findings.stream().noneMatch(each::concerns))
                .map(each -> file + ", line " + each.line() + ": " + each.rule().id() + " does not find anything at "
                        + each.element() + "; remove the line")
                .toList();
    }

    /**
     * A switched-off finding.
     *
     * @param where the place of the switch
     */
    public record SwitchedOff(Finding finding, String reason, String where) {}
}
