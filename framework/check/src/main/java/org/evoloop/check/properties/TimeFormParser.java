package org.evoloop.check.properties;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.FormulaParser;
import org.evoloop.check.temporal.Word;
import org.evoloop.check.timing.Span;
import org.evoloop.check.timing.TimeForm;
import org.evoloop.statemachine.ModelException;

/**
 * Parses time properties:
 *
 * <pre>
 * after F, G within 3 s            after F, G within 1 s .. 3 s
 * F never longer than 10 min       F never shorter than 2 s
 * F only after 30 s of G           F at most 3 times in 10 s
 * </pre>
 */
final class TimeFormParser {
    private static final String ALONE = "a property with a time in it must be alone on its line, in one of the forms "
            + "'after F, G within 3 s', 'F never longer than 3 s', 'F never shorter than 3 s', 'F only after 3 s of "
            + "G', 'F at most 3 times in 10 s'; F and G are of one moment: names, 'not', 'and', 'or' and brackets";

    private final FormulaParser formulas;

    TimeFormParser(FormulaParser formulas) {
        this.formulas = formulas;
    }

    /**
     * The form of {@code words}.
     *
     * @return empty if they do not mention time
     * @throws ModelException if they mention time and cannot be understood or expressed
     */
    Optional<TimeForm> parse(List<Word> words) {
        Optional<TimeForm> form = response(words)
                .or(() -> stay(words, "longer", nanos -> new Span(0, nanos)))
                .or(() -> stay(words, "shorter", nanos -> new Span(nanos, Span.FOR_EVER)))
                .or(() -> before(words))
                .or(() -> count(words));
        if (form.isEmpty() && words.stream().anyMatch(TimeFormParser::isTime) && !isUntimed(words)) {
            throw new ModelException(ALONE);
        }
        return form;
    }

    /** A state may be called 3. */
    private boolean isUntimed(List<Word> words) {
        try {
            formulas.parse(words);
            return true;
        } catch (ModelException itIsAboutTime) {
            return false;
        }
    }

    private static boolean isTime(Word word) {
        return word.is("within") || (!word.quoted() && word.text().matches("\\d+(\\.\\d+)?(ms|s|min|h)?"));
    }

    private Optional<TimeForm> response(List<Word> words) {
        int within = last(words, "within");
        if (words.isEmpty() || !words.get(0).is("after") || within < 0) {
            return Optional.empty();
        }
        for (int index = 1; index < within; index++) {
            Word word = words.get(index);
            if (!word.quoted() && word.text().endsWith(",")) {
                List<Word> subject = new ArrayList<>(words.subList(1, index));
                String name = word.text().substring(0, word.text().length() - 1);
                if (!name.isEmpty()) {
                    subject.add(new Word(name, false));
                }
                Span span = span(words, within + 1, text -> text.contains("..") ? Span.parse(text) : upTo(text));
                return Optional.of(
                        new TimeForm.Response(moment(subject), moment(words.subList(index + 1, within)), span));
            }
        }
        throw new ModelException(
                "there is no comma between what happens and what follows; write after F, G within 3 s");
    }

    private static Span upTo(String text) {
        return new Span(0, Span.nanos(text));
    }

    private Optional<TimeForm> stay(List<Word> words, String than, Function<Long, Span> span) {
        int never = at(words, "never", than, "than");
        if (never < 0) {
            return Optional.empty();
        }
        long nanos = span(words, never + 3, Span::nanos);
        if (nanos == 0) {
            throw new ModelException("everything lasts at least 0 s; name a longer time");
        }
        Formula subject = moment(words.subList(0, never));
        lasts(subject);
        return Optional.of(new TimeForm.Stay(subject, span.apply(nanos)));
    }

    private Optional<TimeForm> before(List<Word> words) {
        int only = at(words, "only", "after");
        int of = last(words, "of");
        if (only < 0 || of < only || !isTime(words.get(only + 2))) {
            return Optional.empty();
        }
        long nanos = span(words.subList(0, of), only + 2, Span::nanos);
        Formula other = moment(words.subList(of + 1, words.size()));
        lasts(other);
        return Optional.of(new TimeForm.Before(moment(words.subList(0, only)), other, nanos));
    }

    private Optional<TimeForm> count(List<Word> words) {
        int at = at(words, "at", "most");
        if (at < 0 || at + 4 >= words.size()) {
            return Optional.empty();
        }
        String number = words.get(at + 2).text();
        if (!number.matches("[1-9]\\d{0,2}")
                || !words.get(at + 3).text().matches("times?")
                || !words.get(at + 4).is("in")) {
            throw new ModelException("'" + text(words.subList(at, words.size()))
                    + "' cannot be understood; write at most 3 times in 10 s, with a number from 1 to 999");
        }
        long nanos = span(words, at + 5, Span::nanos);
        return Optional.of(new TimeForm.Count(moment(words.subList(0, at)), Integer.parseInt(number), nanos));
    }

    /** A formula about one moment. */
    private Formula moment(List<Word> words) {
        Formula formula = formulas.parse(words);
        if (!formula.isPlain()) {
            throw new ModelException(
                    "'" + text(words) + "' is about more than one moment, which cannot be timed; " + ALONE);
        }
        return formula;
    }

    private static void lasts(Formula formula) {
        if (formula.names(Formula.Kind.EVENT)) {
            throw new ModelException(
                    "an event takes no time, so it cannot last; name the state, device state or function "
                            + "that it leads to");
        }
    }

    private static <T> T span(List<Word> words, int from, Function<String, T> reader) {
        return reader.apply(text(words.subList(Math.min(from, words.size()), words.size())));
    }

    private static String text(List<Word> words) {
        return words.stream().map(Word::text).collect(Collectors.joining(" "));
    }

    /** The position of these consecutive keywords; -1 if there is none. */
    private static int at(List<Word> words, String... keywords) {
        for (int start = 0; start + keywords.length < words.size(); start++) {
            boolean found = true;
            for (int index = 0; index < keywords.length; index++) {
                found &= words.get(start + index).is(keywords[index]);
            }
            if (found) {
                return start;
            }
        }
        return -1;
    }

    private static int last(List<Word> words, String keyword) {
        int last = -1;
        for (int index = 0; index < words.size(); index++) {
            last = words.get(index).is(keyword) ? index : last;
        }
        return last;
    }
}
