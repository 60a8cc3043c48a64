package org.evoloop.converter.running;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.evoloop.converter.ConverterJournal;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.Drift;
import org.evoloop.converter.EvolutionException;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Probation;
import org.evoloop.converter.ShadowReport;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.attachment.DecisionHost;
import org.evoloop.converter.binding.Bindings;
import org.evoloop.converter.recording.History;
import org.evoloop.converter.recording.LatencyWindow;
import org.evoloop.converter.recording.Records;
import org.evoloop.converter.recording.Replayed;
import org.evoloop.engine.Core;
import org.evoloop.engine.Output;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Swap;
import org.evoloop.engine.Tally;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The core of a running converter, with the lock that guards it. Inputs about occurrences come from {@link CoreIntake}
 * and {@link PlanExecutor}; those about the converter as a whole, such as other models, from here.
 *
 * <p>Threading: thread-safe. Its lock, which is this object's, is held for as long as the core and its outputs take,
 * which is short; no user code runs under it. A thread that holds the loop's lock may take this one, never the other
 * way round.
 */
public final class CoreDriver implements DecisionHost {
    private static final long WAIT_MILLIS = 5;

    final Core core;

    /** The core, behind the journal that records its inputs if there is one; a shadow hears of them, too. */
    final ShadowedInputs inputs;

    final CoreOutputs outputs;
    final Clock clock;
    private final CurrentKnowledge knowledge;
    private final Records records;
    private final @Nullable ConverterJournal journal;
    private final SentryFeed sentryFeed;

    // Written under the lock, and read without it: a reader may see the models of before a change, never half of both.
    private volatile Rules rules;

    private volatile @Nullable Decision decided;

    /** When an event last ended. */
    private long endedNanos;

    private long ends;

    /** @param leaving the progress of the function that is about to be left, in words; empty if there is none */
    CoreDriver(
            Rules rules,
            Clock clock,
            CurrentKnowledge knowledge,
            Records records,
            Supplier<String> leaving,
            @Nullable ConverterJournal journal,
            SentryFeed sentryFeed) {
        this.rules = rules;
        this.clock = clock;
        this.knowledge = knowledge;
        this.records = records;
        Snapshot kept = journal == null
                ? null
                : journal.open(
                        rules,
                        clock,
                        new Replayed(
                                records.history(),
                                records.latency(),
                                rules.table().models().initial()));
        Configuration at = kept == null ? rules.table().models().initial() : kept.at();
        this.outputs = new CoreOutputs(at, knowledge, records, leaving, sentryFeed);
        this.sentryFeed = sentryFeed;
        this.core = kept == null ? new Core(rules, outputs) : new Core(rules, kept, outputs);
        if (kept != null) {
            records.history().countOn(ended(kept.tally()));
            core.recovered(clock.nanoTime());
        }
        this.journal = journal;
        this.inputs = new ShadowedInputs(
                journal == null ? core : journal.keep(core, records::journalFailed, records::journalWorks));
    }

    /** Starts watching the models. */
    synchronized void watch() {
        sentryFeed.begin(rules.table().models(), core.at());
    }

    @Override
    public @Nullable Decision decide(Occurrence occurrence) {
        Pending pending;
        Configuration now;
        long steps;
        Decision resumed;
        synchronized (this) {
            pending = outputs.begun;
            now = core.at();
            steps = core.steps();
            resumed = core.resumed();
        }
        if (pending == null || pending.occurrence() != occurrence) {
            return null;
        }
        // Guards are user code, so they are asked outside the lock, about the record as it was under it.
        Decision made = resumed != null
                ? resumed
                : preferred(
                        rules.decide(now, steps, pending, knowledge.bindings().with(occurrence.values())), pending);
        decided = made;
        return made;
    }

    /** What is sent may depend on preferences; what the device has done, and what a failure is followed by, does not. */
    private Decision preferred(Decision usual, Pending pending) {
        Bindings bindings = knowledge.bindings();
        return bindings.prefers() && pending.from() == null && pending.broken() == null
                ? rules().table()
                        .prefer(usual, bindings.costs(pending.occurrence().values()))
                : usual;
    }

    @Override
    public synchronized boolean keepsRecord(Occurrence occurrence) {
        Pending pending = outputs.begun;
        return occurrence instanceof Occurrence.InDoubt
                || occurrence instanceof Occurrence.Evolved
                || (pending != null && pending.occurrence() == occurrence && pending.broken() != null);
    }

    /** The last decision by the rules, to tell it from those of an analyze component; null if there is none. */
    @Nullable
    Decision decided() {
        return decided;
    }

    /** The agenda of the plan for {@code occurrence}; null if it does not have the turn. */
    synchronized @Nullable Agenda agendaOf(Occurrence occurrence) {
        Pending pending = outputs.begun;
        boolean hasTurn =
                pending != null && pending.occurrence() == occurrence && pending.number() == outputs.agenda.turn();
        return hasTurn ? outputs.agenda : null;
    }

    /** Nothing is in progress any more, and the converter is closed. */
    synchronized void release() {
        outputs.agenda.begin(Agenda.NOBODY);
        inputs.closed();
    }

    /** Models or components have changed. */
    synchronized void use(DecisionTable table) {
        rules = rules.with(table);
        inputs.changed(rules, clock.nanoTime());
    }

    /** Prepares the journal for other models; may take long. */
    public void prepare(Rules next) {
        if (journal != null) {
            journal.prepare(next);
        }
    }

    /**
     * Lets other models take over while nothing is in the loop. What has to be done then is on the agenda.
     *
     * @param idle how long nothing must have happened before
     * @throws EvolutionException if that is not possible; nothing has changed
     */
    synchronized Output.Evolved evolve(Swap swap, StateKnowledge next, Duration idle) {
        // From here to the end under one hold of the lock: no event can begin between the check and the change.
        Duration quiet = Duration.ofNanos(clock.nanoTime() - endedNanos);
        if (!idle.isZero() && (core.waiting() > 0 || quiet.compareTo(idle) < 0)) {
            throw new EvolutionException("it has not been idle for " + idle.toSeconds() + " s");
        }
        requirePossible(swap);
        endShadow();
        outputs.agenda.begin(Agenda.NOBODY);
        inputs.evolved(swap, clock.nanoTime());
        rules = swap.rules();
        knowledge.become(next);
        sentryFeed.begin(rules.table().models(), core.at());
        return outputs.evolution();
    }

    private void requirePossible(Swap swap) {
        String hindrance = core.hindrance(swap);
        if (!hindrance.isEmpty()) {
            throw new EvolutionException(hindrance);
        }
    }

    // Shadow

    /**
     * Starts a shadow while nothing is in the loop.
     *
     * @throws EvolutionException if its models have no state for where the system is
     */
    synchronized void shadow(Swap swap, Probation.Watches watches) {
        requirePossible(swap);
        ShadowCore begun = new ShadowCore(core, swap, watches, clock);
        inputs.shadow = begun;
        outputs.shadow = begun.hears();
    }

    public synchronized void endShadow() {
        inputs.shadow = null;
        outputs.shadow = null;
    }

    /** The shadow's report; null if there is none. */
    public synchronized @Nullable ShadowReport shadowReport() {
        return inputs.shadow == null ? null : inputs.shadow.report();
    }

    /** The number of ended events in the history. */
    public synchronized long recorded() {
        return records.history().number();
    }

    /** An event has ended. The lock is held. */
    void eventEnded() {
        endedNanos = clock.nanoTime();
        ends++;
        notifyAll();
    }

    /** Waits until an event has ended, for at most {@code millis}. */
    public synchronized void awaitEnded(long millis) throws InterruptedException {
        // Counted, not a flag: an event may end, and the next begin, before this thread has the lock again.
        long before = ends;
        for (long waited = 0; ends == before && waited < millis; waited += WAIT_MILLIS) {
            wait(WAIT_MILLIS);
        }
    }

    /** The guards that the original model draws for {@code event} and that hold now, by its values. */
    Set<String> holding(Event event, Values values) {
        return knowledge.bindings().holding(event, values);
    }

    public Rules rules() {
        return rules;
    }

    synchronized Tally tally() {
        return core.tally();
    }

    synchronized ConverterStatus.EventCounts counts() {
        Tally tally = core.tally();
        return new ConverterStatus.EventCounts(
                tally.observed(),
                tally.handled(),
                tally.ignored(),
                tally.stale(),
                tally.failed(),
                tally.dropped(),
                tally.refused(),
                core.waiting(),
                core.isBusy() ? 1 : 0);
    }

    public synchronized List<HistoryEntry> history() {
        return records.history().entries();
    }

    /** The number of ended events in the history. */
    private static long ended(Tally tally) {
        return tally.handled() + tally.ignored() + tally.stale() + tally.failed() + tally.dropped();
    }

    /** The last {@code count} entries; those that are not in memory are read from the journal, while events are still handled. */
    public List<HistoryEntry> history(int count) {
        ConverterJournal kept = journal;
        synchronized (this) {
            if (kept == null || records.history().reaches(count)) {
                List<HistoryEntry> entries = history();
                return entries.subList(Math.max(0, entries.size() - count), entries.size());
            }
        }
        // Outside the lock: reading the files may take long, and events must not wait for it.
        History past = new History(clock, count);
        kept.replay(
                rules,
                new Replayed(past, new LatencyWindow(), rules.table().models().initial()));
        past.countOn(ended(tally()));
        return past.entries();
    }

    synchronized ConverterStatus.ConversionTime conversionTime() {
        return records.latency().summary();
    }

    synchronized Drift drift() {
        return assumesNothing(rules.table().models().original())
                ? Drift.NONE
                : records.drift().summary();
    }

    /** A model whose states no event leaves does not say what the device does. */
    private static boolean assumesNothing(StateMachine device) {
        return device.states().size() > 1
                && device.transitions().stream().allMatch(each -> each.source().equals(each.target()));
    }

    /** Why the record may be wrong; empty if it is certain. */
    public synchronized String doubt() {
        return core.doubt();
    }

    /** What a prospect begins with; the rest is computed outside the lock, for which events would have to wait. */
    synchronized Prospects prospects(StateKnowledge knowledge, Set<Event> ofControllers) {
        return new Prospects(rules.table(), core.at(), core.doubtfulStep(), knowledge, ofControllers);
    }

    /** When the timers that run are due. */
    synchronized Map<Event, Long> deadlines() {
        return core.deadlines();
    }

    @Override
    public Configuration configuration() {
        return outputs.at();
    }
}
