package org.evoloop.payload;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.evoloop.evolution.Values;
import org.jspecify.annotations.Nullable;

/**
 * What a message must say for a rule to apply:
 *
 * <pre>{@code
 * Match.exactly("ON").at("/state")
 * Match.matching(Pattern.compile("turn to (?<degrees>[0-9]+)"))
 * Match.between(3, 100).at("/power").value("power", Part.at("/power"))
 * }</pre>
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Match {
    private final Part part;
    private final Function<String, @Nullable Values> test;
    private final Map<String, Part> more;

    private Match(Part part, Function<String, @Nullable Values> test, Map<String, Part> more) {
        this.part = part;
        this.test = test;
        this.more = more;
    }

    private static Match whole(Function<String, @Nullable Values> test) {
        return new Match(Part.WHOLE, test, Map.of());
    }

    /** Any message; with {@link #at}, any that has a value there. */
    public static Match any() {
        return whole(text -> Values.NONE);
    }

    /** This text; a number or boolean in JSON as it is written. */
    public static Match exactly(String wanted) {
        return whole(text -> text.equals(wanted) ? Values.NONE : null);
    }

    /** A text that matches as a whole; the pattern's named groups are the event's values. */
    public static Match matching(Pattern pattern) {
        return whole(Texts.values(pattern));
    }

    /** A number from {@code from}, and less than {@code below}; these may be infinite. */
    public static Match between(double from, double below) {
        return whole(text ->
                Texts.value(text) instanceof Double number && number >= from && number < below ? Values.NONE : null);
    }

    /** A copy that looks at the value at this JSON pointer; see {@link Part#at}. */
    public Match at(String pointer) {
        return in(Part.at(pointer));
    }

    /** A copy that looks at this part. */
    public Match in(Part other) {
        return new Match(other, test, more);
    }

    /** A copy with one more value for the event, if the message has that part: a number if it looks like one, or a text. */
    public Match value(String name, Part from) {
        Map<String, Part> all = new LinkedHashMap<>(more);
        all.put(name, from);
        return new Match(part, test, all);
    }

    Part part() {
        return part;
    }

    /** The event's values if the message says this; else empty. */
    public Optional<Values> of(String message) {
        return part.in(message).flatMap(text -> of(message, text));
    }

    /** @param text what the message says in this part */
    Optional<Values> of(String message, String text) {
        Values values = test.apply(text);
        if (values == null) {
            return Optional.empty();
        }
        for (Map.Entry<String, Part> each : more.entrySet()) {
            Optional<String> found = each.getValue().in(message);
            if (found.isPresent()) {
                values = values.with(each.getKey(), Texts.value(found.get()));
            }
        }
        return Optional.of(values);
    }
}
