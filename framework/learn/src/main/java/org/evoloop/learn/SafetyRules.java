package org.evoloop.learn;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What must not be pressed. Each rule is a line: {@code never EVENT}, {@code never EVENT in CLASS}, or
 * {@code at most N presses an hour}, in which a reset counts as a press.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class SafetyRules {
    /** Nothing is forbidden. */
    public static final SafetyRules NONE = new SafetyRules(List.of(), 0);

    private static final Pattern AT_MOST = Pattern.compile("at most (\\d{1,6}) presse?s? an hour");
    private static final String FORMS = "write 'never EVENT', 'never EVENT in CLASS' or 'at most N presses an hour'";

    private final List<Never> nevers;
    /** 0 if any number may be pressed. */
    private final int mostAnHour;

    /** @param shown where it is forbidden; empty if everywhere */
    private record Never(String input, String shown) {
        boolean forbids(String pressed, String shows) {
            return input.equals(pressed) && (shown.isEmpty() || shown.equals(shows));
        }

        @Override
        public String toString() {
            return "never " + input + (shown.isEmpty() ? "" : " in " + shown);
        }
    }

    private SafetyRules(List<Never> nevers, int mostAnHour) {
        this.nevers = nevers;
        this.mostAnHour = mostAnHour;
    }

    /**
     * The rules in these lines, for a device with these inputs.
     *
     * @throws LearnException if a line is no rule, or names no input; the message has the number of the line
     */
    public static SafetyRules parse(List<String> lines, Set<String> inputs) {
        List<Never> nevers = new ArrayList<>();
        int most = 0;
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i).strip();
            String place = "safety rule " + (i + 1) + ", '" + line + "', ";
            Matcher atMost = AT_MOST.matcher(line);
            if (line.startsWith("never ")) {
                nevers.add(never(line.substring("never ".length()).strip(), inputs, place));
            } else if (atMost.matches()) {
                int number = Integer.parseInt(atMost.group(1));
                if (number == 0) {
                    throw new LearnException(place + "allows nothing; the number must be at least 1");
                }
                most = most == 0 ? number : Math.min(most, number);
            } else {
                throw new LearnException(place + "is no rule; " + FORMS);
            }
        }
        return new SafetyRules(List.copyOf(nevers), most);
    }

    private static Never never(String rest, Set<String> inputs, String place) {
        // An input's name may itself contain "in".
        if (inputs.contains(rest)) {
            return new Never(rest, "");
        }
        int in = rest.indexOf(" in ");
        while (in > 0) {
            String input = rest.substring(0, in).strip();
            if (inputs.contains(input)) {
                return new Never(input, rest.substring(in + " in ".length()).strip());
            }
            in = rest.indexOf(" in ", in + 1);
        }
        throw new LearnException(place + "names no input; the inputs are "
                + String.join(", ", inputs.stream().sorted().toList()) + "; " + FORMS);
    }

    /** The rule that forbids pressing an input while the device shows this; empty if it may be pressed. */
    public Optional<String> forbids(String input, String shows) {
        return nevers.stream()
                .filter(never -> never.forbids(input, shows))
                .map(Never::toString)
                .findFirst();
    }

    /** How many presses, resets included, an hour may have; empty if any number. */
    public OptionalInt mostAnHour() {
        return mostAnHour == 0 ? OptionalInt.empty() : OptionalInt.of(mostAnHour);
    }
}
