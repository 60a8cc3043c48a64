package org.evoloop.check.properties;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.FormulaParser;
import org.evoloop.check.temporal.Word;
import org.evoloop.check.timing.Assumption;
import org.evoloop.check.timing.Reaction;
import org.evoloop.check.timing.Span;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;

/**
 * Parses assumptions about time, and reactions to violations:
 *
 * <pre>
 * takes Spot 200 ms .. 1 s
 * at least 150 ms between presses         at least 1 s between Spot
 * endSpot comes 30 s .. 60 s after device Spot
 * queue 2
 * on violation of NAME raise EVENT
 * </pre>
 */
final class AssumptionParser {
    private static final int MOST_WAITING = 1000;
    private static final Pattern REACTION = Pattern.compile("on violation of (.+) raise (\\S+|\"[^\"]+\")");

    private final ModelPair pair;
    private final FormulaParser formulas;

    AssumptionParser(ModelPair pair, FormulaParser formulas) {
        this.pair = pair;
        this.formulas = formulas;
    }

    /** The assumption in {@code words}; empty if they are not one. */
    Optional<Assumption> assumption(List<Word> words) {
        boolean isGap =
                words.size() > 3 && words.get(0).is("at") && words.get(1).is("least");
        if (words.size() > 2 && words.get(0).is("takes")) {
            return Optional.of(takes(words));
        } else if (isGap) {
            return Optional.of(gap(words));
        } else if (words.size() > 3 && words.get(1).is("comes")) {
            return Optional.of(comes(words));
        } else if (words.size() == 2 && words.get(0).is("queue")) {
            return Optional.of(queue(words.get(1).text()));
        }
        return Optional.empty();
    }

    private Assumption takes(List<Word> words) {
        Set<String> sent = new TreeSet<>();
        pair.original().triggers().forEach(event -> sent.add(event.name()));
        String event = words.get(1).text();
        if (!sent.contains(event)) {
            throw new ModelException("there is no event of the original model named " + event
                    + ", and no others are sent; there are " + String.join(", ", sent));
        }
        return new Assumption.Takes(event, Span.parse(text(words, 2, words.size())));
    }

    private Assumption gap(List<Word> words) {
        int between = words.size() - 2;
        if (!words.get(between).is("between")) {
            throw new ModelException("write at least 150 ms between presses, or the name of one event for 'presses'");
        }
        long nanos = Span.nanos(text(words, 2, between));
        Word last = words.get(between + 1);
        return new Assumption.Gap(last.is("presses") ? null : event(last), nanos);
    }

    private Assumption comes(List<Word> words) {
        int after = 2;
        while (after < words.size() && !words.get(after).is("after")) {
            after++;
        }
        if (after == words.size()) {
            throw new ModelException("say after what: write endSpot comes 30 s .. 60 s after device Spot");
        }
        Formula during = formulas.parse(words.subList(after + 1, words.size()));
        if (!(during instanceof Formula.Atom atom) || atom.kind() == Formula.Kind.EVENT) {
            throw new ModelException("'" + text(words, after + 1, words.size())
                    + "' does not last; name one state, device state or function");
        }
        return new Assumption.Comes(event(words.get(0)), Span.parse(text(words, 2, after)), atom);
    }

    private static Assumption queue(String number) {
        if (!number.matches("\\d{1,4}") || Integer.parseInt(number) > MOST_WAITING) {
            throw new ModelException("'" + number + "' events cannot wait; write a number from 0 to " + MOST_WAITING);
        }
        return new Assumption.Queue(Integer.parseInt(number));
    }

    /** The reaction in {@code text}; empty if it is not one. */
    Optional<Reaction> reaction(String text) {
        if (!text.strip().startsWith("on violation ")) {
            return Optional.empty();
        }
        Matcher form = REACTION.matcher(text.strip());
        if (!form.matches()) {
            throw new ModelException("write on violation of NAME raise EVENT");
        }
        Event event = new Event(event(Word.of(form.group(2)).get(0)));
        boolean own = pair.original().spontaneous().contains(event)
                || pair.evolved().spontaneous().contains(event);
        if (own || event.timeTrigger().isPresent()) {
            throw new ModelException(event + " cannot be raised: it "
                    + (own ? "is the device's own" : "is a time trigger") + "; name another event of the new model");
        }
        return Optional.of(new Reaction(form.group(1), event));
    }

    private String event(Word word) {
        return formulas.known(Formula.Kind.EVENT, word.text()).name();
    }

    private static String text(List<Word> words, int from, int to) {
        return words.subList(from, to).stream().map(Word::text).collect(Collectors.joining(" "));
    }
}
