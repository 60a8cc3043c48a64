package org.evoloop.journal;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.check.temporal.Property;
import org.evoloop.core.Input;
import org.evoloop.core.Rules;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.journal.Chronicle.Ending;
import org.jspecify.annotations.Nullable;

/**
 * What other models would have made of what a converter was told, event by event.
 *
 * <p>The events, the device's own acts and their times are those of the journal: what the device would have done otherwise
 * nobody knows. A step that failed fails again; others succeed. Timers are due when the other models have them. An event of a
 * new function happens again only where the other models are in the state of that function. Guards hold that held then.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class DryRun {
    private static final Duration SAME_TIMER = Duration.ofSeconds(1);

    private final Map<EventKey, Instant> events = new LinkedHashMap<>();
    private final EventKey.Sequence keys = new EventKey.Sequence();
    private final Map<EventKey, Ending> then = new HashMap<>();
    private final Map<EventKey, Ending> now = new HashMap<>();
    private final OtherRules rules;
    private final KeptProperties properties;
    private @Nullable Rehearsal rehearsal;
    private @Nullable Head last;

    /**
     * An event of which the other models make something else.
     *
     * @param recorded what became of it; null for a timer that only the other models have
     * @param other what would have; null if the event would not have happened
     */
    public record Difference(
            Instant at,
            Occurrence occurrence,
            @Nullable Verdict recorded,
            @Nullable Verdict other) {

        /** For messages: what became of it. */
        public String then() {
            return recorded == null ? "had no such timer" : recorded.toString();
        }

        /** For messages: what the other models make of it. */
        public String now() {
            return other == null ? "would not have happened" : other.toString();
        }

        @Override
        public String toString() {
            return at + "  " + occurrence + "\n    then  " + then() + "\n    now   " + now();
        }
    }

    /**
     * A property of the other models that the events break.
     *
     * @param at when
     * @param occurrence the event that breaks it; null if it is broken where the journal begins
     * @param where the other models stand then
     */
    public record Broken(
            Property property, Instant at, @Nullable Occurrence occurrence, Configuration where) {

        /** For messages: the event, or that there is none. */
        public String by() {
            return occurrence == null ? "where the journal begins" : "by " + occurrence;
        }

        @Override
        public String toString() {
            return "'" + property.name() + "' (line " + property.line() + ") at " + at + ", " + by() + ", in " + where;
        }
    }

    /**
     * What came of it.
     *
     * @param events how many were compared
     * @param differences in order
     * @param broken in order of their events
     * @param open the properties that ask for something that had not come when the journal ended
     */
    public record Result(long events, List<Difference> differences, List<Broken> broken, List<Property> open) {
        public Result {
            differences = List.copyOf(differences);
            broken = List.copyOf(broken);
            open = List.copyOf(open);
        }
    }

    private DryRun(ModelPair models, List<Property> properties) {
        this.rules = new OtherRules(models);
        this.properties = new KeptProperties(properties);
    }

    /**
     * Runs a journal through other models; the journal is only read.
     *
     * @param models a valid pair
     * @param properties of these models, that are watched meanwhile
     * @throws JournalException if the journal is damaged
     */
    public static Result of(JournalFiles journal, ModelPair models, List<Property> properties) {
        models.requireValid();
        DryRun run = new DryRun(models, properties);
        journal.each(Told::of, run::add);
        run.end();
        run.matchTimers();
        return new Result(run.events.size(), run.differences(), run.properties.broken(), run.properties.open());
    }

    private void add(Told told) {
        Head head = told.head();
        then.putAll(told.endings());
        Rehearsal running = continued(told);
        for (Told.Moment moment : told.moments()) {
            if (moment.input() instanceof Input.Observed observed) {
                Occurrence occurrence = observed.occurrence();
                events.put(keys.take(occurrence), head.wallTime(occurrence.observedNanos()));
                Occurrence here = occurrence.visit() == Occurrence.ANY_VISIT
                        ? occurrence
                        : isHere(moment, occurrence, running) ? running.inThisVisit(occurrence) : null;
                if (here != null) {
                    running.follow(new Input.Observed(here), moment.atNanos());
                }
            } else {
                running.follow(moment.input(), moment.atNanos());
            }
        }
        timers(told.endings(), head);
        last = head;
    }

    /** Whether the function that raised it runs in the other models, too. */
    private static boolean isHere(Told.Moment moment, Occurrence occurrence, Rehearsal running) {
        return occurrence.visit() == moment.visit() && running.at().evolved().equals(moment.state());
    }

    /** Goes on where the segment before has ended; on another clock as after a restart. */
    private Rehearsal continued(Told told) {
        Rehearsal before = rehearsal;
        Head head = told.head();
        if (before != null && last != null && Math.abs(offset(head) - offset(last)) < SAME_TIMER.toNanos()) {
            return before;
        }
        end();
        Configuration at = before == null ? rules.placed(told.from().at()) : before.at();
        Rules like = rules.like(head);
        properties.begin(like.table(), at, head);
        Rehearsal fresh = new Rehearsal(like, at, head.nowNanos(), then, properties::see);
        if (told.from().open()) {
            fresh.follow(new Input.Opened(head.nowNanos()), head.nowNanos());
        }
        rehearsal = fresh;
        return fresh;
    }

    private static long offset(Head head) {
        return head.wallNanos() - head.nowNanos();
    }

    private void end() {
        Rehearsal ended = rehearsal;
        Head head = last;
        if (ended != null && head != null) {
            now.putAll(ended.endings());
            timers(ended.endings(), head);
        }
    }

    private void timers(Map<EventKey, Ending> endings, Head head) {
        endings.keySet().stream()
                .filter(key -> key.source() == Source.TIMER)
                .forEach(key -> events.put(key, head.wallTime(key.observedNanos())));
    }

    private List<Difference> differences() {
        List<Difference> differences = new ArrayList<>();
        events.forEach((key, at) -> {
            Ending recorded = then.get(key);
            Ending other = now.get(key);
            boolean same =
                    recorded != null && other != null && recorded.verdict().isSame(other.verdict());
            if (recorded != null && !same) {
                differences.add(new Difference(at, recorded.occurrence(), recorded.verdict(), verdict(other)));
            } else if (recorded == null && other != null && key.source() == Source.TIMER) {
                differences.add(new Difference(at, other.occurrence(), null, other.verdict()));
            }
        });
        differences.sort(Comparator.comparing(Difference::at));
        return differences;
    }

    private static @Nullable Verdict verdict(@Nullable Ending ending) {
        return ending == null ? null : ending.verdict();
    }

    /** A timer is told a moment after it is due; here it is due to the nanosecond. */
    private void matchTimers() {
        for (EventKey here : List.copyOf(now.keySet())) {
            if (here.source() != Source.TIMER || then.containsKey(here)) {
                continue;
            }
            then.keySet().stream()
                    .filter(key -> key.source() == Source.TIMER
                            && key.label().equals(here.label())
                            && !now.containsKey(key)
                            && Math.abs(key.observedNanos() - here.observedNanos()) <= SAME_TIMER.toNanos())
                    .min(Comparator.comparingLong(key -> Math.abs(key.observedNanos() - here.observedNanos())))
                    .ifPresent(key -> {
                        now.put(key, now.remove(here));
                        events.remove(here);
                    });
        }
    }
}
