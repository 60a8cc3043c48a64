package org.evoloop.converter;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.evoloop.converter.HistoryEntry.Outcome;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.loop.Execute;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * What the components of a converter do together: decide, plan, carry out, and keep the books.
 *
 * <p>Threading: the loop calls it for one event at a time; a full queue is told by whoever found it full.
 */
final class ConverterCore implements LoopListener<Occurrence> {
    private final LoopConfig config;
    private final Transcript transcript = new Transcript();
    private final FailureLog failures = new FailureLog();
    final StateKnowledge knowledge;
    final History history;
    final LatencyWindow latency = new LatencyWindow();
    final MapeLoop<Occurrence, Decision, Conversion> loop;
    final Visits visits;
    private volatile List<EventExecute> executes = List.of();
    private volatile @Nullable Occurrence observed;
    private volatile @Nullable Conversion active;
    private volatile boolean sent;

    /** What came last, if neither model knows it. */
    private volatile @Nullable Event unknown;

    private volatile long sentNanos;

    ConverterCore(LoopConfig config, StateKnowledge knowledge) {
        this.config = config;
        this.knowledge = knowledge;
        this.history = new History(config.clock());
        this.loop = new MapeLoop<>(config, this, this::dispatch, ConverterCore::isFact);
        this.visits = new Visits(config, knowledge, loop, transcript, failures);
    }

    /**
     * What has happened already must not be lost to a full queue; it comes no faster than devices and timers act and
     * functions finish.
     */
    private static boolean isFact(Occurrence occurrence) {
        return occurrence.deviceActed()
                || occurrence.source() == Source.TIMER
                || occurrence.source() == Source.FUNCTION;
    }

    /** From the next event on, decides by {@code table}. */
    void use(DecisionTable table, List<EventExecute> present) {
        knowledge.use(table);
        executes = List.copyOf(present);
    }

    /** Opens the loop, after every execute component has seen to what the device needs in the current state. */
    void start() {
        for (EventExecute execute : executes) {
            try {
                execute.settled(knowledge.configuration());
            } catch (Exception cause) {
                failed(execute, "settled", cause);
            }
        }
        loop.start(visits::enterAgain);
    }

    /** Whether the caller is a component, a function or the clock, for which nobody must wait who was called by them. */
    boolean ownsCurrentThread() {
        return loop.ownsCurrentThread()
                || visits.ownsCurrentThread()
                || config.clock().ownsCurrentThread();
    }

    /** Ends the current visit and lets go of the device; the loop is closed. */
    void release() {
        visits.leave();
        for (EventExecute execute : executes) {
            try {
                execute.released();
            } catch (Exception cause) {
                failed(execute, "released", cause);
            }
        }
    }

    /** Outside of the loop, on the thread of whoever opens or closes it. */
    private void failed(EventExecute execute, String phase, Exception cause) {
        if (cause instanceof InterruptedException) {
            Thread.currentThread().interrupt();
        } else {
            failures.log(new Failure<>(execute.name(), phase, 0, null, cause));
        }
    }

    // Analyze

    @Nullable
    Decision decide(Occurrence occurrence) {
        Configuration before = knowledge.configuration();
        if (visits.isStale(occurrence)) {
            history.record(occurrence, before, before, Outcome.STALE, null, "the state that raised it has been left");
            return null;
        }
        State found = occurrence.found();
        if (found != null && isNoNews(found, before)) {
            return null;
        }
        if (found != null && sent && occurrence.observedNanos() < sentNanos) {
            history.record(occurrence, before, before, Outcome.STALE, null, "the device has been sent an event since");
            return null;
        }
        if (found == null && isUnknown(occurrence, before)) {
            return null;
        }
        if (occurrence.source() == Source.TIMER) {
            visits.heard(occurrence.event());
        }
        observed = occurrence;
        active = null;
        transcript.observed(occurrence);
        Decision decision = found != null
                ? knowledge.table().find(before, found)
                : knowledge
                        .table()
                        .decide(before, knowledge.resolve(before, occurrence.event()), occurrence.deviceActed());
        transcript.analyzed(decision);
        return decision;
    }

    /** An event that neither model knows is told once a burst: until another one comes. */
    private boolean isUnknown(Occurrence occurrence, Configuration before) {
        Event event = occurrence.event();
        if (knowledge.eventNames().knows(event)) {
            unknown = null;
            return false;
        }
        String text = knowledge.eventNames().unknown(event);
        history.record(occurrence, before, before, Outcome.IGNORED, null, text);
        if (!event.equals(unknown)) {
            unknown = event;
            failures.warn(text + " (" + occurrence.source().name().toLowerCase(Locale.ROOT) + ")");
        }
        return true;
    }

    private boolean isNoNews(State found, Configuration before) {
        if (!knowledge.models().original().hasState(found)) {
            failures.warn("the device was found in " + found + ", which is not a state of its model"
                    + Names.hint(found.name(), knowledge.models().original().states()));
            return true;
        }
        return found.equals(before.original());
    }

    // Plan

    @Nullable
    Conversion plan(Decision decision) {
        Occurrence occurrence = observed;
        if (occurrence == null) {
            return null;
        }
        Conversion conversion = new Conversion(this, occurrence, decision);
        active = conversion;
        transcript.planned(decision instanceof Decision.ExistingFunction
                && !decision.steps().isEmpty());
        return conversion;
    }

    // Execute

    private @Nullable Execute<Conversion> dispatch(
            Conversion conversion, List<Execute<Conversion>> inOrder, @Nullable Execute<Conversion> last) {
        if (conversion.isOver()) {
            return null;
        }
        Event next = conversion.nextToSend();
        for (int index = 0; index < inOrder.size(); index++) {
            Execute<Conversion> execute = inOrder.get(index);
            if (next != null
                    && execute instanceof EventExecute sender
                    && sender.events().contains(next)) {
                return execute;
            }
        }
        return inOrder.get(0);
    }

    boolean dispatchable(Event event) {
        for (EventExecute execute : executes) {
            if (execute.events().contains(event)) {
                return true;
            }
        }
        return false;
    }

    void begins(Conversion conversion) {
        latency.record(config.clock().nanoTime() - conversion.occurrence().observedNanos());
        if (conversion.decision().leavesState()) {
            // Before the first command leaves: a function that still moved the device would contradict it.
            visits.endFunction();
        }
    }

    /** @throws IllegalStateException if a guard of the original model leads the step elsewhere now */
    void requireOpen(Step step) {
        if (!knowledge.isOpen(step)) {
            throw new IllegalStateException("the guards of the original model do not let " + step + " be taken now");
        }
    }

    void effectFailed(Failure<Occurrence> failure) {
        failures.log(failure);
    }

    void transcribe(Decision decision, Step step) {
        if (decision instanceof Decision.ExistingFunction) {
            transcript.step(step.trigger());
        }
    }

    void took(Step step) {
        if (!step.byDevice()) {
            transcript.command(step.trigger());
            sent = true;
            sentNanos = config.clock().nanoTime();
        }
        knowledge.move(knowledge.configuration().withOriginal(step.target()));
    }

    /** All steps are taken: the evolved system enters its next state. Returns the visit, null if it stays. */
    @Nullable
    Visit arrives(Conversion conversion) {
        Decision decision = conversion.decision();
        Configuration after = decision.after();
        knowledge.move(after);
        Visit entered = null;
        if (decision.leavesState()) {
            Transition transition = decision.transition();
            entered = visits.enter(
                    after.evolved(),
                    transition == null ? NewFunction.none() : knowledge.action(transition),
                    transition == null ? Set.of() : transition.keeps());
            if (decision instanceof Decision.NewFunction) {
                transcript.starts(after.evolved());
            }
        }
        transcript.executed(after);
        record(conversion, after);
        if (decision instanceof Decision.Impossible) {
            // Its timers start anew: what was impossible now may be possible the next time.
            visits.enterAgain();
        }
        return entered;
    }

    private void record(Conversion conversion, Configuration after) {
        Decision decision = conversion.decision();
        if (decision instanceof Decision.Impossible impossible) {
            failures.warn(conversion.occurrence() + " in " + decision.before() + ": " + impossible.reason());
        }
        boolean failed = decision instanceof Decision.Impossible
                || !conversion.failedEffects().isEmpty();
        Outcome outcome = decision instanceof Decision.NotAcceptable
                ? Outcome.IGNORED
                : failed ? Outcome.FAILED : Outcome.HANDLED;
        history.record(
                conversion.occurrence(), decision.before(), after, outcome, decision, conversion.failedEffects());
    }

    // LoopListener

    @Override
    public void failed(Failure<Occurrence> failure) {
        failures.log(failure);
        Occurrence occurrence = failure.occurrence();
        if (occurrence == null) {
            return;
        }
        Configuration now = knowledge.configuration();
        Conversion conversion = active;
        if (conversion == null || !conversion.occurrence().equals(occurrence)) {
            endInFailure(occurrence, now, now, failure);
        } else if (conversion.giveUp()) {
            endInFailure(occurrence, conversion.decision().before(), now, failure);
            if (conversion.hasLeftState()) {
                visits.enterAgain();
            }
        }
    }

    private void endInFailure(
            Occurrence occurrence, Configuration before, Configuration now, Failure<Occurrence> failure) {
        history.record(occurrence, before, now, Outcome.FAILED, null, failure.toString());
        transcript.brokenOff(now);
    }

    @Override
    public void dropped(Occurrence occurrence, boolean first) {
        Configuration now = knowledge.configuration();
        history.record(occurrence, now, now, Outcome.DROPPED, null, "the queue was full");
        if (first) {
            failures.warn("the queue of " + config.queueCapacity()
                    + " events is full, and events are lost; status counts them, history names them");
        }
    }
}
