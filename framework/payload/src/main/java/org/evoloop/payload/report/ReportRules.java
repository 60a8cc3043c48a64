package org.evoloop.payload.report;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Steady;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * What the reports from some sources mean: the first rule of a source that applies to a report is used.
 *
 * <p>Threading: rules are added by one thread, before the connection is opened; reports come one at a time.
 *
 * @since 0.1
 */
public final class ReportRules {
    private final @Nullable Clock clock;
    private final Turns turns;
    private final BiConsumer<String, Consumer<Report>> subscribe;
    private final Map<String, List<Rule>> rules = new HashMap<>();
    private final List<Held> states = new CopyOnWriteArrayList<>();

    /** Which reports a rule is for. */
    public enum Use {
        /** Those of an event; old ones are none any more. */
        EVENT,
        /** All of the state. */
        STATE,
        /** Those of the state as it is just now. */
        NEWS
    }

    /**
     * No rules so far.
     *
     * @param clock null if no meaning has to hold for a time
     * @param turns those of the reports
     * @param subscribe is called once for each source, with what hears its reports
     */
    public ReportRules(@Nullable Clock clock, Turns turns, BiConsumer<String, Consumer<Report>> subscribe) {
        this.clock = clock;
        this.turns = turns;
        this.subscribe = subscribe;
    }

    /**
     * Adds a rule, after the others of its source.
     *
     * @throws IllegalArgumentException if a meaning has to hold for a time, and there is no clock
     */
    public void add(String source, Meanings meanings, Use use, Consumer<Meanings.Meaning> heard) {
        Consumer<Meanings.Meaning> told = use == Use.EVENT ? heard : endingOthers(heard);
        Rule rule = meanings.lasting().isZero()
                ? new Rule(meanings, use, now -> now.ifPresent(told))
                : new Rule(meanings, use, held(source, meanings, use, told)::hear);
        rules.computeIfAbsent(source, first -> {
                    List<Rule> ofSource = new CopyOnWriteArrayList<>();
                    subscribe.accept(source, report -> hear(ofSource, report));
                    return ofSource;
                })
                .add(rule);
    }

    private Held held(String source, Meanings meanings, Use use, Consumer<Meanings.Meaning> told) {
        Held held = new Held(requireClock(source), turns, meanings, use, told);
        if (use != Use.EVENT) {
            states.add(held);
        }
        return held;
    }

    /** What one source says of the state ends what another one has said before, and what has not held for long enough yet. */
    private Consumer<Meanings.Meaning> endingOthers(Consumer<Meanings.Meaning> heard) {
        return state -> {
            states.forEach(held -> held.endUnless(state));
            heard.accept(state);
        };
    }

    private Clock requireClock(String source) {
        if (clock == null) {
            throw new IllegalArgumentException("what " + source
                    + " says must hold for a time; give the monitor the device, whose clock measures that");
        }
        return clock;
    }

    private static void hear(List<Rule> ofSource, Report report) {
        boolean taken = false;
        for (Rule rule : ofSource) {
            if (rule.use() == Use.STATE || !report.old()) {
                // A rule that does not apply ends what it had heard before.
                Optional<Meanings.Meaning> meaning =
                        taken ? Optional.empty() : rule.meanings().of(report.text());
                taken |= meaning.isPresent();
                rule.then().accept(meaning);
            }
        }
    }

    private record Rule(Meanings meanings, Use use, Consumer<Optional<Meanings.Meaning>> then) {}

    /** Passes on what has held for a time: a state whenever it is reported, an event once, when that has begun. */
    private static final class Held {
        private final Clock clock;
        private final Turns turns;
        private final Steady steady;
        private final Use use;
        private final Consumer<Meanings.Meaning> then;
        private @Nullable String last;
        private Clock.@Nullable Timer timer;

        Held(Clock clock, Turns turns, Meanings meanings, Use use, Consumer<Meanings.Meaning> then) {
            this.clock = clock;
            this.turns = turns;
            this.steady = new Steady(clock, meanings.lasting());
            this.use = use;
            this.then = then;
        }

        void hear(Optional<Meanings.Meaning> now) {
            // Outside of the lock: what is told may wait.
            noted(now).ifPresent(this::settle);
        }

        /** Another source says that the device is in this state. */
        synchronized void endUnless(Meanings.Meaning state) {
            if (steady.isOther(state)) {
                noted(Optional.empty());
            }
        }

        /** The meaning if it has held for long enough; else a timer looks again. */
        private synchronized Optional<Meanings.Meaning> noted(Optional<Meanings.Meaning> now) {
            steady.see(now);
            if (timer != null) {
                timer.cancel();
            }
            String name = now.map(Meanings.Meaning::name).orElse("");
            if (name.isEmpty() || last == null) {
                // What holds from the beginning has not begun now.
                last = name;
            }
            if (steady.left().isZero()) {
                return now;
            }
            now.ifPresent(meaning -> timer = clock.schedule(steady.left(), () -> turns.take(() -> settle(meaning))));
            return Optional.empty();
        }

        private void settle(Meanings.Meaning meaning) {
            if (isNews(meaning)) {
                then.accept(meaning);
            }
        }

        private synchronized boolean isNews(Meanings.Meaning meaning) {
            boolean news = steady.counts(meaning)
                    && !(use == Use.EVENT && meaning.name().equals(last));
            last = steady.counts(meaning) ? meaning.name() : last;
            return news;
        }
    }
}
