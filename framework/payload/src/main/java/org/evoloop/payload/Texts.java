package org.evoloop.payload;

import java.util.List;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.evolution.Values;
import org.jspecify.annotations.Nullable;

/**
 * The values in texts: numbers if they look like numbers, else the texts.
 *
 * @since 0.1
 */
public final class Texts {
    private static final Pattern NUMBER = Pattern.compile("[+-]?[0-9]{1,15}(\\.[0-9]{1,15})?");
    private static final Pattern NAMED_GROUP = Pattern.compile("\\(\\?<([A-Za-z][A-Za-z0-9]*)>");

    private Texts() {}

    /** A {@link Double} if the text looks like a number, else the text. */
    public static Object value(String text) {
        return NUMBER.matcher(text).matches() ? Double.valueOf(text) : text;
    }

    /** The named groups of a text that matches as a whole; null if it does not. */
    static Function<String, @Nullable Values> values(Pattern pattern) {
        List<String> names = NAMED_GROUP
                .matcher(pattern.pattern())
                .results()
                .map(group -> group.group(1))
                .toList();
        return text -> {
            Matcher match = pattern.matcher(text);
            return match.matches() ? values(match, names) : null;
        };
    }

    private static Values values(Matcher match, List<String> names) {
        Values values = Values.NONE;
        for (String name : names) {
            String text = match.group(name);
            if (text != null) {
                values = values.with(name, value(text));
            }
        }
        return values;
    }
}
