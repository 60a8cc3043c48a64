package org.evoloop.journal;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.check.temporal.Property;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Swap;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.migration.Fate;
import org.evoloop.migration.Mapping;
import org.evoloop.rehearsal.Comparison;
import org.evoloop.rehearsal.Difference;
import org.evoloop.rehearsal.Verdict;
import org.jspecify.annotations.Nullable;

/**
 * Finds out, event by event, what other models would have decided on a converter's inputs.
 *
 * <p>The events, the device's own actions and their times are those of the journal; what else the device might have
 * done is unknown. See {@link Comparison} for what is assumed. The models that a journal was written with decide nothing
 * differently.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class DryRun {
    private final OtherRules rules;
    private final WatchedProperties properties;
    private final Comparison comparison;
    private final List<Difference> differences = new ArrayList<>();
    private final List<Note> notes = new ArrayList<>();
    private long events;
    private @Nullable Head last;

    /** The converter's core; null before the first segment. */
    private @Nullable Core recorded;

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
     * Why differences from here on may come from something else than the other models.
     *
     * @param at the time
     * @param why for people
     */
    public record Note(Instant at, String why) {
        /** For messages. */
        @Override
        public String toString() {
            return at + "  " + why;
        }
    }

    /**
     * The result of a dry run.
     *
     * @param events how many were compared
     * @param differences the differences, in order
     * @param broken the violations, in the order of their events
     * @param open the properties that require something that had not come when the journal ended
     * @param notes why differences may come from something else, in order; usually empty
     */
    public record Result(
            long events, List<Difference> differences, List<Broken> broken, List<Property> open, List<Note> notes) {
        public Result {
            differences = List.copyOf(differences);
            broken = List.copyOf(broken);
            open = List.copyOf(open);
            notes = List.copyOf(notes);
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
        run.comparison.end();
        return new Result(run.events, run.differences, run.properties.broken(), run.properties.open(), run.notes);
    }

    private void add(SegmentHistory segment) {
        Core core = proceed(segment);
        for (Input input : segment.inputs()) {
            if (!comparison.hasBegun()) {
                begin(core, segment);
            }
            core.apply(input);
            if (comparison.hasBegun()) {
                comparison.took(input);
            }
        }
    }

    /** Continues where the previous segment ended, in the same process or in another one. */
    private Core proceed(SegmentHistory segment) {
        Core before = recorded;
        Head ended = last;
        Core core = new Core(segment.rules(), segment.from(), comparison.hears());
        recorded = core;
        last = segment.head();
        if (before == null || ended == null || !comparison.hasBegun()) {
            begin(core, segment);
            return core;
        }
        boolean sameModels = segment.head().fingerprint().equals(ended.fingerprint());
        Rules like = rules.like(segment.head());
        Seam seam = Seam.between(before, segment);
        if (!sameModels) {
            note(
                    segment,
                    "the converter evolved to '"
                            + segment.head().models().evolved().name() + "'; from here on, that is what is compared");
        } else if (seam.isRestart()) {
            Core restarted = seam.restarted(comparison.hears());
            comparison.restarts(restarted, like, seam.nanos());
            Input.Recovered recovered = new Input.Recovered(segment.from().nowNanos());
            restarted.apply(recovered);
            comparison.took(recovered);
        } else if (seam.isGap()) {
            note(
                    segment,
                    "the journal lacks what came before, since it could not be written; the other models go on"
                            + " where the converter was");
            comparison.end();
            begin(core, segment);
            return core;
        } else if (!segment.head().hasRulesOf(ended)) {
            comparison.use(like, segment.from().nowNanos());
        }
        comparison.continues(core);
        properties.begin(like.table(), comparison.at(), segment.head());
        return core;
    }

    private void note(SegmentHistory segment, String why) {
        notes.add(new Note(segment.head().wallTime(segment.from().nowNanos()), why));
    }

    /** The other models begin where the converter is, as soon as no event is in progress there. */
    private void begin(Core core, SegmentHistory segment) {
        Rules like = rules.like(segment.head());
        Swap swap = Swap.of(core.rules(), like, Mapping.byName());
        String hindrance = core.hindrance(swap);
        Snapshot from = core.snapshot();
        if (hindrance.isEmpty()) {
            Core placed = new Core(core.rules(), from, output -> {});
            placed.evolved(swap, from.nowNanos());
            from = placed.snapshot();
        } else if (swap.succession().fate(from.at()) instanceof Fate.Stuck stuck
                && stuck.because().equals(hindrance)) {
            note(segment, hindrance + "; they begin elsewhere");
            from = rules.placed(from);
        } else {
            return;
        }
        comparison.begin(core, like, from);
        properties.begin(like.table(), comparison.at(), segment.head());
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
