package org.evoloop.converter;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Output;
import org.evoloop.core.Pending;
import org.evoloop.core.Rules;
import org.evoloop.core.Tally;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.loop.Intake;
import org.evoloop.loop.QueueStatus;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Gives the core its inputs, one at a time, and hands out what it says: notices at once and in order, directives to whoever
 * carries the occurrence in progress.
 *
 * <p>Threading: thread-safe. Its lock is held for as long as the core and those who are told take, which is short; nothing
 * of a user runs under it. Whoever holds the loop's lock may take this one, never the other way round.
 */
final class CoreDriver implements Intake<Occurrence> {
    /** The turn of whoever opens or closes the converter, or ends what somebody else has begun. */
    static final long NOBODY = 0;

    /** Hears what the core says, under the driver's lock. */
    interface Listener {
        /** Called for each output, in order. */
        void heard(Output output);
    }

    private final Core core;
    private final Clock clock;
    private final Bindings bindings;
    private final EventNames names;
    private final Listener listener;
    private final List<Output> said = new ArrayList<>();
    private final ArrayDeque<Output.Directive> agenda = new ArrayDeque<>();
    private @Nullable Pending begun;
    private Admission admission = Admission.TAKEN;

    /** The number of the occurrence whose directives are on the agenda. */
    private long turn = NOBODY;

    private volatile Configuration at;

    CoreDriver(Rules rules, Clock clock, StateKnowledge knowledge, Listener listener) {
        this.core = new Core(rules);
        this.clock = clock;
        this.bindings = knowledge.bindings();
        this.names = knowledge.eventNames();
        this.listener = listener;
        this.at = core.at();
    }

    private synchronized void tell(Input input) {
        core.apply(input, said);
        // By index: an iterator would be garbage in every event.
        for (int index = 0; index < said.size(); index++) {
            Output output = said.get(index);
            if (output instanceof Output.Directive directive) {
                agenda.add(directive);
            } else if (output instanceof Output.Moved moved) {
                at = moved.after();
            } else if (output instanceof Output.Begin begin) {
                begun = begin.pending();
            } else if (output instanceof Output.Dropped dropped) {
                admission = dropped.first() ? Admission.FIRST_DROPPED : Admission.DROPPED;
            } else if (output instanceof Output.Refused) {
                admission = Admission.REFUSED;
            }
            listener.heard(output);
        }
        said.clear();
    }

    // The loop's intake

    @Override
    public synchronized Admission offer(Occurrence occurrence) {
        admission = Admission.TAKEN;
        tell(
                occurrence.source() == Source.TIMER && occurrence instanceof Occurrence.Heard timer
                        ? new Input.TimerDue(timer.visit(), timer.event(), timer.observedNanos())
                        : new Input.Observed(occurrence));
        return admission;
    }

    @Override
    public synchronized boolean hasRoom() {
        return core.hasRoom();
    }

    @Override
    public synchronized @Nullable Occurrence next() {
        begun = null;
        turn = NOBODY;
        tell(new Input.Ready(clock.nanoTime()));
        Pending pending = begun;
        return pending == null ? null : pending.occurrence();
    }

    @Override
    public synchronized void ended() {
        Pending pending = begun;
        if (pending != null) {
            tell(new Input.Dismissed(pending.number(), clock.nanoTime()));
        }
    }

    @Override
    public synchronized void opened() {
        turn = NOBODY;
        tell(new Input.Opened(clock.nanoTime()));
    }

    @Override
    public synchronized void closed() {
        tell(new Input.Closing());
    }

    @Override
    public synchronized QueueStatus status() {
        Tally tally = core.tally();
        return new QueueStatus(
                core.waiting(),
                core.rules().queueCapacity(),
                tally.highest(),
                tally.queued(),
                tally.dropped(),
                tally.refused());
    }

    // Analyze

    /** What {@code occurrence} means now; null if it is no longer in progress. */
    @Nullable
    Decision decide(Occurrence occurrence) {
        Pending pending;
        Configuration now;
        long steps;
        Rules rules;
        synchronized (this) {
            pending = begun;
            now = core.at();
            steps = core.steps();
            rules = core.rules();
        }
        if (pending == null || pending.occurrence() != occurrence) {
            return null;
        }
        return occurrence instanceof Occurrence.Heard heard && !names.knows(heard.event())
                ? new Decision.Refused(now, names.unknown(heard.event()))
                : rules.decide(now, steps, pending, bindings.with(occurrence.values()));
    }

    // Execute

    /**
     * Takes up a plan, if that was not done yet.
     *
     * @return the number of its occurrence, whose directives are on the agenda from now on
     * @throws IllegalStateException if it is a plan for another occurrence than that in progress
     */
    synchronized long takeUp(ChangePlan plan) {
        Pending pending = begun;
        if (pending == null || pending.occurrence() != plan.occurrence()) {
            throw new IllegalStateException("the plan is for " + plan.occurrence() + ", which is not in the loop");
        }
        if (turn != pending.number()) {
            turn = pending.number();
            tell(new Input.Planned(turn, plan.decision(), clock.nanoTime()));
        }
        return turn;
    }

    /** What has to be done next in this turn, which stays on the agenda; null if there is nothing, or the turn is over. */
    synchronized Output.@Nullable Directive next(long ofTurn) {
        return ofTurn == turn ? agenda.peek() : null;
    }

    /** The same for the turn of {@code plan}. */
    synchronized Output.@Nullable Directive next(ChangePlan plan) {
        Pending pending = begun;
        return pending != null && pending.occurrence() == plan.occurrence() ? next(pending.number()) : null;
    }

    /** Takes {@code directive}, which is being carried out, off the agenda. */
    synchronized void done(Output.Directive directive) {
        if (agenda.peek() == directive) {
            agenda.remove();
        }
    }

    /** Announces that a step is about to be sent; false if it must not be, since the device has left its place. */
    synchronized boolean announce(long number) {
        tell(new Input.Sending(number, clock.nanoTime()));
        return core.maySend(number);
    }

    /** The step has had its effect; for {@code inOrder} see {@link Input.Sent}. */
    void sent(long number, boolean inOrder) {
        tell(new Input.Sent(number, inOrder, clock.nanoTime()));
    }

    /** An effect was run; {@code failure} is empty if nothing went wrong. */
    void ran(long number, String failure) {
        tell(new Input.EffectRun(number, failure, clock.nanoTime()));
    }

    /** The device was asked; {@code state} is null if it could not tell. */
    void located(long number, @Nullable State state) {
        tell(new Input.Located(number, state, clock.nanoTime()));
    }

    // What goes wrong, and what goes on beside the loop

    /** The occurrence in progress has failed; what follows from that is the turn of whoever calls. */
    synchronized void failed(String reason, boolean givenUp) {
        Pending pending = begun;
        if (pending != null && core.isBusy()) {
            turn = NOBODY;
            agenda.clear();
            long now = clock.nanoTime();
            tell(
                    givenUp
                            ? new Input.GivenUp(pending.number(), reason, now)
                            : new Input.Failed(pending.number(), reason, now));
        }
    }

    /** Nothing is in progress any more, and the converter is closed. */
    synchronized void release() {
        turn = NOBODY;
        tell(new Input.Closed());
    }

    /** Models or components have changed. */
    synchronized void use(DecisionTable table) {
        tell(new Input.Changed(core.rules().with(table), clock.nanoTime()));
    }

    /** Which guards of the original model hold now. */
    Set<String> holding() {
        Set<String> drawn = rules().table().models().original().guards();
        if (drawn.isEmpty()) {
            return Set.of();
        }
        Set<String> holding = new TreeSet<>();
        for (String text : drawn) {
            if (bindings.test(text)) {
                holding.add(text);
            }
        }
        return holding;
    }

    synchronized Rules rules() {
        return core.rules();
    }

    synchronized Tally tally() {
        return core.tally();
    }

    /** Why the record may be wrong; empty if it is sure. */
    synchronized String doubt() {
        return core.doubt();
    }

    Configuration configuration() {
        return at;
    }
}
