package org.evoloop.converter;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Inputs;
import org.evoloop.core.Output;
import org.evoloop.core.Pending;
import org.evoloop.core.Rules;
import org.evoloop.core.Snapshot;
import org.evoloop.core.Swap;
import org.evoloop.core.Tally;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.loop.Intake;
import org.evoloop.loop.QueueStatus;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Gives the core its inputs, one at a time, and passes its directives to the thread that carries the occurrence in
 * progress.
 *
 * <p>Threading: thread-safe. Its lock is held for as long as the core and its outputs take, which is short; no user
 * code runs under it. A thread that holds the loop's lock may take this one, never the other way round.
 */
final class CoreDriver implements Intake<Occurrence> {
    private static final long WAIT_MILLIS = 5;

    private final Core core;

    /** The core, or the journal that records inputs on their way to it. */
    private final Inputs inputs;

    private final Clock clock;
    private final CurrentKnowledge knowledge;
    private final CoreOutputs outputs;
    private final Books books;
    private final @Nullable ConverterJournal journal;
    private final Watchman watchman;

    private volatile Rules rules;

    /** The shadow, which gets the same inputs; null if there is none. */
    private @Nullable ShadowCore shadow;

    /** When an event last ended. */
    private long endedNanos;

    private long ends;

    /** @param leaving the progress of the function that is about to be left, in words; empty if there is none */
    CoreDriver(
            Rules rules,
            Clock clock,
            CurrentKnowledge knowledge,
            Books books,
            Supplier<String> leaving,
            @Nullable ConverterJournal journal,
            Watchman watchman) {
        this.rules = rules;
        this.clock = clock;
        this.knowledge = knowledge;
        this.books = books;
        Snapshot kept = journal == null
                ? null
                : journal.open(
                        rules,
                        clock,
                        new Replayed(
                                books.history(),
                                books.latency(),
                                rules.table().models().initial()));
        Configuration at = kept == null ? rules.table().models().initial() : kept.at();
        this.outputs = new CoreOutputs(at, knowledge, books, leaving, watchman);
        this.watchman = watchman;
        this.core = kept == null ? new Core(rules, outputs) : new Core(rules, kept, outputs);
        if (kept != null) {
            books.history().countOn(ended(kept.tally()));
            core.recovered(clock.nanoTime());
        }
        this.journal = journal;
        this.inputs = journal == null ? core : journal.keep(core, books::journalFailed);
    }

    // The loop's intake

    /** @throws IllegalArgumentException if its time is in the future: all timers would be late by as much */
    @Override
    public synchronized Admission offer(Occurrence occurrence) {
        long early = occurrence.observedNanos() - clock.nanoTime();
        if (early > 0) {
            throw new IllegalArgumentException(occurrence + " says that it was observed " + early / 1_000_000
                    + " ms in the future; give it a time of the converter's clock");
        }
        outputs.admission = Admission.TAKEN;
        if (core.isOpen() || occurrence.isFact()) {
            watchman.comes(occurrence, core.at());
        }
        if (occurrence.source() == Source.TIMER && occurrence instanceof Occurrence.Heard timer) {
            inputs.timerDue(timer.visit(), timer.event(), timer.observedNanos());
        } else {
            inputs.observed(occurrence);
            if (shadow != null && outputs.admission == Admission.TAKEN) {
                shadow.observed(occurrence);
            }
        }
        return outputs.admission;
    }

    @Override
    public synchronized boolean hasRoom(Occurrence occurrence) {
        return core.hasRoom(occurrence);
    }

    @Override
    public synchronized @Nullable Occurrence next() {
        outputs.begun = null;
        outputs.agenda.begin(Agenda.NOBODY);
        inputs.ready();
        Pending pending = outputs.begun;
        return pending == null ? null : pending.occurrence();
    }

    @Override
    public synchronized void ended() {
        Pending pending = outputs.begun;
        if (pending != null && core.isBusy()) {
            inputs.dismissed(pending.number(), clock.nanoTime());
        }
        endedNanos = clock.nanoTime();
        ends++;
        notifyAll();
    }

    /** Starts watching the models. */
    synchronized void watch() {
        watchman.begin(rules.table().models(), core.at());
    }

    @Override
    public synchronized void opened() {
        outputs.agenda.begin(Agenda.NOBODY);
        inputs.opened(clock.nanoTime());
        shadow(new Input.Opened(clock.nanoTime()));
    }

    @Override
    public synchronized void closed() {
        inputs.closing();
        shadow(new Input.Closing());
    }

    @Override
    public synchronized QueueStatus status() {
        Tally tally = core.tally();
        return new QueueStatus(
                core.waiting(),
                rules.queueCapacity(),
                tally.highest(),
                tally.queued(),
                tally.dropped(),
                tally.refused());
    }

    // Analyze

    /** The decision for {@code occurrence} now; null if it is no longer in progress. */
    @Nullable
    Decision decide(Occurrence occurrence) {
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
        if (resumed != null) {
            return resumed;
        }
        return rules.decide(now, steps, pending, knowledge.bindings().with(occurrence.values()));
    }

    // Execute

    /**
     * Begins a plan, unless it has begun.
     *
     * @return the directives of the plan
     * @throws IllegalStateException if it is a plan for another occurrence than that in progress, or leads to states
     *     that the models do not have
     */
    synchronized Agenda takeUp(ChangePlan plan) {
        Pending pending = outputs.begun;
        if (pending == null || pending.occurrence() != plan.occurrence()) {
            throw new IllegalStateException("the plan is for " + plan.occurrence() + ", which is not in the loop");
        }
        Agenda agenda = outputs.agenda;
        if (agenda.turn() != pending.number()) {
            requireStates(plan.decision());
            agenda.begin(pending.number());
            inputs.planned(pending.number(), plan.decision(), clock.nanoTime());
        }
        return agenda;
    }

    /** An analyze component may have made the decision: the record must not come to states that do not exist. */
    private void requireStates(Decision decision) {
        ModelPair models = rules.table().models();
        requireState(models.evolved(), decision.after().evolved(), "new");
        requireState(models.original(), decision.after().original(), "original");
        for (int index = 0; index < decision.steps().size(); index++) {
            requireState(models.original(), decision.steps().get(index).target(), "original");
        }
    }

    private static void requireState(StateMachine machine, State state, String which) {
        if (!machine.hasState(state)) {
            throw new IllegalStateException("the plan leads to " + state + ", which is not a state of the " + which
                    + " model" + Names.hint(state.name(), machine.states()));
        }
    }

    /** The next directive of {@code plan}; null if there is none. Called by the thread whose turn it is. */
    synchronized Output.@Nullable Directive toDo(ChangePlan plan) {
        Pending pending = outputs.begun;
        boolean hasTurn = pending != null
                && pending.occurrence() == plan.occurrence()
                && pending.number() == outputs.agenda.turn();
        return hasTurn ? outputs.agenda.peek() : null;
    }

    /** The directives for the thread that opens or closes the converter, or ends what another thread has begun. */
    synchronized Agenda agenda() {
        return outputs.agenda;
    }

    /**
     * Announces that {@code execute} is about to send a step; false if it must not, since the device has left the
     * step's source.
     */
    synchronized boolean announce(long number, EventExecute execute) {
        inputs.sending(number);
        boolean may = core.maySend(number);
        if (may) {
            execute.sending = number;
        }
        return may;
    }

    /**
     * The step that {@code execute} was sending has had its effect. Only the first call for a step counts; a second
     * call waits for the first, since the plan cannot continue before its consequences are known.
     *
     * @param inOrder see {@link Input.Sent}
     * @return whether it was given up before, and something is to be done about that
     */
    synchronized boolean tookEffect(EventExecute execute, boolean inOrder) {
        long number = execute.sending;
        execute.sending = 0;
        if (number == 0) {
            return false;
        }
        boolean late = !core.maySend(number);
        inputs.sent(number, inOrder, clock.nanoTime());
        return late && core.hasNext();
    }

    /** Announces that an effect is about to be run. */
    synchronized void announceEffect(long number) {
        inputs.running(number);
    }

    /** An effect was run; {@code failure} is empty if nothing went wrong. */
    synchronized void ran(long number, String failure) {
        inputs.effectRun(number, failure, clock.nanoTime());
    }

    /** The device was asked; {@code state} is null if it does not know. */
    synchronized void located(long number, @Nullable State state) {
        inputs.located(number, state, clock.nanoTime());
    }

    // Failures, and what happens outside the loop

    /**
     * The occurrence in progress has failed; the caller's turn carries out what follows.
     *
     * @param unknown whether it is uncertain if the step being sent had its effect
     * @return whether it has led out of the state all the same: the device had obeyed
     */
    synchronized boolean failed(String reason, boolean unknown) {
        Pending pending = outputs.begun;
        outputs.left = false;
        if (pending != null && core.isBusy()) {
            outputs.agenda.end();
            outputs.agenda = new Agenda();
            long now = clock.nanoTime();
            if (unknown) {
                inputs.givenUp(pending.number(), reason, now);
            } else {
                inputs.failed(pending.number(), reason, now);
            }
        }
        return outputs.left;
    }

    /** Nothing is in progress any more, and the converter is closed. */
    synchronized void release() {
        outputs.agenda.begin(Agenda.NOBODY);
        inputs.closed();
        shadow(new Input.Closed());
    }

    /** Models or components have changed. */
    synchronized void use(DecisionTable table) {
        rules = rules.with(table);
        inputs.changed(rules, clock.nanoTime());
    }

    /** Prepares the journal for other models; may take long. */
    void prepare(Rules next) {
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
        watchman.begin(rules.table().models(), core.at());
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
        shadow = begun;
        outputs.shadow = begun.hears();
    }

    private void shadow(Input input) {
        if (shadow != null) {
            shadow.follow(input);
        }
    }

    synchronized void endShadow() {
        shadow = null;
        outputs.shadow = null;
    }

    /** The shadow's report; null if there is none. */
    synchronized @Nullable ShadowReport shadowReport() {
        return shadow == null ? null : shadow.report();
    }

    /** The number of ended events in the history. */
    synchronized long recorded() {
        return books.history().number();
    }

    /** Waits until an event has ended, for at most {@code millis}. */
    synchronized void awaitEnded(long millis) throws InterruptedException {
        long before = ends;
        for (long waited = 0; ends == before && waited < millis; waited += WAIT_MILLIS) {
            wait(WAIT_MILLIS);
        }
    }

    /** The guards of the original model that hold now. */
    Set<String> holding() {
        return knowledge.bindings().holding(rules.table().models().original().guards());
    }

    Rules rules() {
        return rules;
    }

    synchronized Tally tally() {
        return core.tally();
    }

    synchronized List<HistoryEntry> history() {
        return books.history().entries();
    }

    /** The number of ended events in the history. */
    private static long ended(Tally tally) {
        return tally.handled() + tally.ignored() + tally.stale() + tally.failed() + tally.dropped();
    }

    /** The last {@code count} entries; those that are not in memory are read from the journal, while events are still handled. */
    List<HistoryEntry> history(int count) {
        ConverterJournal kept = journal;
        synchronized (this) {
            if (kept == null || books.history().reaches(count)) {
                List<HistoryEntry> entries = history();
                return entries.subList(Math.max(0, entries.size() - count), entries.size());
            }
        }
        History past = new History(clock, count);
        kept.replay(
                rules,
                new Replayed(past, new LatencyWindow(), rules.table().models().initial()));
        past.countOn(ended(tally()));
        return past.entries();
    }

    synchronized ConverterStatus.ConversionTime conversionTime() {
        return books.latency().summary();
    }

    /** Why the record may be wrong; empty if it is certain. */
    synchronized String doubt() {
        return core.doubt();
    }

    Configuration configuration() {
        return outputs.at();
    }
}
