package org.evoloop.device.connection;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.payload.Match;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Part;
import org.jspecify.annotations.Nullable;

/**
 * Reads what messages mean: {@code {json: /state, values: {ON: Heating}}}, {@code {pattern: "turn (?<degrees>[0-9]+)", event:
 * turn}} or {@code {json: /power, ranges: {Heating: 100..}, steady: 2 s}}.
 */
final class MeaningReader {
    private static final Pattern RANGE =
            Pattern.compile("(-?[0-9]{1,15}(?:\\.[0-9]+)?)?\\.\\.(-?[0-9]{1,15}(?:\\.[0-9]+)?)?");
    private static final List<String> FORMS = List.of("values", "pattern", "ranges");

    private MeaningReader() {}

    /**
     * The meanings in {@code rule}, whose other keys are the connection's.
     *
     * @param one the key of a pattern's meaning, {@code event} or {@code state}
     * @param known checks an event or a state
     * @return nothing has a meaning if there is a mistake
     */
    static Meanings read(Section rule, String one, Function<Node.Text, String> known) {
        Part part = part(rule).orElse(Part.WHOLE);
        String form = rule.oneOf(FORMS).orElse("");
        Meanings meanings = Meanings.NONE;
        switch (form) {
            case "values" -> {
                for (Map.Entry<Node.Text, Node.Text> pair : rule.pairs("values").entrySet()) {
                    meanings =
                            meanings.with(Match.exactly(pair.getKey().value()).in(part), known.apply(pair.getValue()));
                }
            }
            case "pattern" -> {
                Pattern pattern = rule.pattern("pattern").orElse(null);
                String name = rule.need(one).map(known).orElse(null);
                if (pattern != null && name != null) {
                    meanings = meanings.with(Match.matching(pattern).in(part), name);
                }
            }
            case "ranges" -> {
                List<Range> ranges = new ArrayList<>();
                for (Map.Entry<Node.Text, Node.Text> pair : rule.pairs("ranges").entrySet()) {
                    Range range = range(rule, pair.getValue());
                    String name = known.apply(pair.getKey());
                    if (range != null) {
                        ranges.forEach(other -> requireApart(rule, other, range));
                        ranges.add(range);
                        meanings = meanings.with(
                                Match.between(range.from(), range.below()).in(part), name);
                    }
                }
            }
            default -> {}
        }
        return meanings.lasting(rule.period("steady").orElse(Duration.ZERO));
    }

    /** The value at a JSON pointer, if {@code rule} has one. */
    static Optional<Part> part(Section rule) {
        return rule.value("json", Part::at);
    }

    private record Range(Node.Text text, double from, double below) {}

    private static void requireApart(Section rule, Range one, Range other) {
        if (Math.max(one.from(), other.from()) < Math.min(one.below(), other.below())) {
            rule.problems()
                    .at(
                            other.text(),
                            "the ranges " + one.text() + " and " + other.text()
                                    + " overlap, so a number could mean both; a range ends before its second number");
        }
    }

    private static @Nullable Range range(Section rule, Node.Text text) {
        Matcher range = RANGE.matcher(text.value());
        if (!range.matches() || (range.group(1) == null && range.group(2) == null)) {
            rule.problems().at(text, "'" + text + "' is no range of numbers; write 3..100, ..3 or 100..");
            return null;
        }
        return new Range(
                text,
                number(range.group(1), Double.NEGATIVE_INFINITY),
                number(range.group(2), Double.POSITIVE_INFINITY));
    }

    private static double number(@Nullable String text, double otherwise) {
        return text == null ? otherwise : Double.parseDouble(text);
    }
}
