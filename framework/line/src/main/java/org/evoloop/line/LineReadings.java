package org.evoloop.line;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.evolution.Values;
import org.evoloop.function.Reading;

/**
 * The readings in a device's lines.
 *
 * <p>Threading: thread-safe.
 */
final class LineReadings implements WireUser {
    private static final Pattern NUMBER = Pattern.compile("[+-]?[0-9]{1,15}(\\.[0-9]{1,15})?");
    private static final Pattern NAMED_GROUP = Pattern.compile("\\(\\?<([A-Za-z][A-Za-z0-9]*)>");

    private final List<Rule> rules = new ArrayList<>();
    private final Map<String, Reading> known = new TreeMap<>();

    private record Rule(String name, Pattern line, String unit) {}

    synchronized void add(String name, Pattern line, String unit) {
        if (line.matcher("").groupCount() == 0) {
            throw new IllegalArgumentException("the pattern '" + line + "' of the reading " + name
                    + " has no group; put the value in parentheses");
        }
        rules.add(new Rule(name, line, unit));
    }

    @Override
    public synchronized void heard(String line) {
        for (Rule rule : rules) {
            Matcher matcher = rule.line().matcher(line);
            String value = matcher.matches() ? matcher.group(1) : null;
            if (value != null) {
                boolean number = NUMBER.matcher(value).matches();
                known.put(
                        rule.name(),
                        number
                                ? Reading.of(rule.name(), Double.parseDouble(value), rule.unit())
                                : Reading.of(rule.name(), value));
            }
        }
    }

    @Override
    public synchronized void lost(String why) {
        known.clear();
    }

    synchronized List<Reading> known() {
        return List.copyOf(known.values());
    }

    /** The named groups of a match, as numbers if they look like numbers, else as texts. */
    static Values values(Matcher match) {
        Values values = Values.NONE;
        Matcher names = NAMED_GROUP.matcher(match.pattern().pattern());
        while (names.find()) {
            String value = match.group(names.group(1));
            if (value != null) {
                boolean number = NUMBER.matcher(value).matches();
                values = values.with(names.group(1), number ? Double.valueOf(value) : value);
            }
        }
        return values;
    }
}
