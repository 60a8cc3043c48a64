package org.evoloop.check;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.evoloop.statemachine.ModelException;

/**
 * A rule that its author has switched off for one element: {@code off trap-state Warm: it is unplugged there}.
 *
 * <p>Threading: immutable.
 *
 * @param element the element's name in findings
 * @param line its line in the file, from 1
 * @since 0.1
 */
public record RuleSwitch(Rule rule, String element, String reason, int line) {
    private static final Pattern FORM =
            Pattern.compile("off\\s+(\\S+?)(?:\\s+(?:\"([^\"]*)\"|([^:]*?)))?\\s*(?::(.*))?");

    /**
     * Parses one line, including its continuation lines.
     *
     * @param isElement whether a model has an element of this name
     * @return empty if it is not a switch
     * @throws ModelException if it is a switch that cannot be understood
     */
    static Optional<RuleSwitch> parse(String text, int line, Predicate<String> isElement) {
        Matcher form = FORM.matcher(text);
        if (!form.matches()) {
            return Optional.empty();
        }
        String id = form.group(1);
        Optional<Rule> rule = Arrays.stream(Rule.values())
                .filter(each -> each.id().equals(id))
                .findFirst();
        if (rule.isEmpty() && !id.contains("-")) {
            return Optional.empty();
        }
        String element = form.group(2) != null ? form.group(2) : form.group(3) == null ? "" : form.group(3);
        String reason = form.group(4) == null ? "" : form.group(4).strip();
        if (rule.isEmpty()) {
            throw new ModelException("there is no rule " + id + "; choose from: "
                    + Arrays.stream(Rule.values()).map(Rule::id).collect(Collectors.joining(", ")));
        }
        if (rule.get() == Rule.PROPERTY) {
            throw new ModelException("a property is switched off by removing it");
        }
        if (!isElement.test(element)) {
            throw new ModelException("no model has "
                    + (element.isEmpty() ? "an element without a name" : "'" + element + "'")
                    + "; write the state, event or transition as check prints it, such as On --press--> Off");
        }
        if (reason.isEmpty()) {
            throw new ModelException("say why " + id + " does not matter for " + element + ", after a colon: off " + id
                    + " " + element + ": REASON");
        }
        return Optional.of(new RuleSwitch(rule.get(), element, reason, line));
    }

    boolean concerns(Finding finding) {
        return finding.rule() == rule && finding.element().toString().equals(element);
    }

    /** Whether it is certainly useless if it matches no finding. It is not for rules that may not have been checked. */
    boolean isAlwaysJudged() {
        return switch (rule) {
            case NO_FUNCTION, UNRAISED_EVENT, UNBOUND_GUARD, UNBOUND_EFFECT -> false;
            default -> true;
        };
    }
}
