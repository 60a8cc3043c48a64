package org.evoloop.journal;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.evoloop.check.temporal.Property;
import org.evoloop.core.Input;
import org.evoloop.core.Rules;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.rehearsal.Comparison;
import org.evoloop.rehearsal.Difference;
import org.evoloop.rehearsal.Verdict;
import org.jspecify.annotations.Nullable;

/**
 * Finds out, event by event, what other models would have decided on a converter's inputs.
 *
 * <p>The events, the device's own actions and their times are those of the journal; what else the device might have
 * done is unknown. A step that failed fails again; others succeed. Timers are due by the other models. An event of a
 * new function happens again only if the other models are in the state of that function. A guard holds if it held then.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class DryRun {
    private static final long SAME_CLOCK_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final OtherRules rules;
    private final WatchedProperties properties;
    private final Comparison comparison;
    private final List<Difference> differences = new ArrayList<>();
    private long events;
    private @Nullable Head last;
    private long lastNanos;

    /**
     * A property of the other models that the recorded events violate.
     *
     * @param at the time
     * @param occurrence the event that violates it; null if it is violated where the journal begins
     * @param where the other models' states then
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
     * The result of a dry run.
     *
     * @param events how many were compared
     * @param differences the differences, in order
     * @param broken the violations, in the order of their events
     * @param open the properties that require something that had not come when the journal ended
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
        this.properties = new WatchedProperties(properties);
        this.comparison = new Comparison(this::compared, this.properties::see);
    }

    /**
     * Runs a journal through other models; the journal is only read.
     *
     * @param models a valid pair
     * @param properties the properties of these models to watch
     * @throws JournalException if the journal is damaged
     */
    public static Result of(JournalFiles journal, ModelPair models, List<Property> properties) {
        models.requireValid();
        DryRun run = new DryRun(models, properties);
        journal.each(SegmentHistory::of, run::add);
        run.comparison.rest(run.lastNanos);
        return new Result(run.events, run.differences, run.properties.broken(), run.properties.open());
    }

    private void add(SegmentHistory segment) {
        proceed(segment);
        for (SegmentHistory.Moment moment : segment.moments()) {
            if (moment.input() instanceof Input.Observed observed) {
                boolean current = observed.occurrence().visit() == moment.visit();
                comparison.observed(observed.occurrence(), current ? moment.state() : null, moment.atNanos());
            } else {
                comparison.follow(moment.input(), moment.atNanos());
            }
            moment.endings().forEach(ending -> comparison.ended(ending, moment.atNanos()));
            lastNanos = moment.atNanos();
        }
    }

    /** Continues where the previous segment ended; on another clock, as after a restart. */
    private void proceed(SegmentHistory segment) {
        Head before = last;
        Head head = segment.head();
        if (before != null && Math.abs(offset(head) - offset(before)) < SAME_CLOCK_NANOS) {
            last = head;
            return;
        }
        comparison.rest(lastNanos);
        last = head;
        Configuration at = before == null ? rules.placed(segment.from().at()) : comparison.at();
        Rules like = rules.like(head);
        properties.begin(like.table(), at, head);
        comparison.begin(like, Comparison.still(at, head.nowNanos()));
        if (segment.from().open()) {
            comparison.follow(new Input.Opened(head.nowNanos()), head.nowNanos());
        }
    }

    private static long offset(Head head) {
        return head.wallNanos() - head.nowNanos();
    }

    private void compared(Occurrence occurrence, @Nullable Verdict then, @Nullable Verdict now) {
        events++;
        Head head = last;
        if (head != null && (then == null || now == null || !then.isSame(now))) {
            Instant at = head.wallTime(occurrence.observedNanos());
            differences.add(new Difference(at, occurrence, then, now));
        }
    }
}
