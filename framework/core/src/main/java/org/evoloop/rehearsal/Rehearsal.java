package org.evoloop.rehearsal;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.evoloop.engine.Core;
import org.evoloop.engine.Output;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * The core of other models, and how it carries out plans of its own: each step and effect succeeds, unless one for the
 * same event failed in the converter.
 *
 * <p>Threading: not thread-safe.
 */
final class Rehearsal extends Chronicle {
    /** What the converter takes has room here, whatever else waits. */
    private static final int ROOMY = 1 << 20;

    private static final Event NO_TIMER = new Event("-");

    final Core core;
    private final Function<Long, @Nullable Ending> then;
    private boolean observing;

    /** What is to be done next for the occurrence in progress. */
    private Output.@Nullable Directive next;

    /**
     * Begins.
     *
     * @param then how an occurrence of this core ended in the converter; null if it has not, or did not come there
     * @param endings receives how each event ends here
     */
    Rehearsal(Rules rules, Snapshot from, Function<Long, @Nullable Ending> then, Endings endings) {
        super(endings);
        this.then = then;
        this.core = new Core(withRoom(rules, ROOMY), from, this);
        follow(core);
    }

    private static Rules withRoom(Rules rules, int capacity) {
        return new Rules(rules.table(), rules.timers(), capacity, rules.pressAge());
    }

    @Override
    public void say(Output output) {
        super.say(output);
        if (output instanceof Output.Begin) {
            next = null;
        } else if (output instanceof Output.Send || output instanceof Output.Run || output instanceof Output.Locate) {
            next = (Output.Directive) output;
        }
    }

    Configuration at() {
        return core.at();
    }

    /** Whether an event is being observed: what ends now ends at once. */
    boolean isObserving() {
        return observing;
    }

    /** How many occurrences it has counted: the number of the last. */
    long observed() {
        return core.tally().observed();
    }

    /**
     * Observes an event.
     *
     * @param lost whether there is no room for it
     * @return its number; 0 if it is no news
     */
    long observe(Occurrence occurrence, boolean lost) {
        return counted(lost, () -> core.observed(occurrence));
    }

    /** A timer of the present visit fires; as {@link #observe}. */
    long fires(Event timer, boolean lost, long atNanos) {
        timers().remove(timer);
        return counted(lost, () -> core.timerDue(core.visit(), timer, atNanos));
    }

    private long counted(boolean lost, Runnable input) {
        long before = observed();
        Rules rules = core.rules();
        if (lost) {
            core.restore(withRoom(rules, Rules.NO_ROOM), core.snapshot());
        }
        observing = true;
        input.run();
        observing = false;
        if (lost) {
            core.restore(rules, core.snapshot());
        }
        // A doubt that it raises is counted after it.
        return observed() > before ? before + 1 : 0;
    }

    /** Tells the time: a timer of no visit does nothing else. */
    void isAt(long atNanos) {
        core.timerDue(Occurrence.ANY_VISIT, NO_TIMER, atNanos);
    }

    /** From now on decides by these rules. */
    void use(Rules rules, long atNanos) {
        core.changed(withRoom(rules, ROOMY), atNanos);
    }

    /** Another process continues, by these rules, on a clock that is {@code nanos} ahead. */
    void restart(Rules rules, long nanos) {
        core.restore(withRoom(rules, ROOMY), core.snapshot().later(nanos));
        Map<Event, Long> shifted = new HashMap<>(timers());
        shifted.forEach((timer, due) -> timers().put(timer, due + nanos));
    }

    /** The device is found before anything else has its turn; returns the number, 0 if it is no news. */
    long find(Occurrence found) {
        int before = core.waiting();
        long number = observe(found, false);
        if (core.waiting() > before) {
            core.restore(core.rules(), core.snapshot().lastFirst());
        }
        return number;
    }

    /** Whether it has not ended. */
    boolean isOpen(long number) {
        return Pairs.open(core).contains(number);
    }

    /** Whether an occurrence is in progress, and does not wait until the converter is opened. */
    boolean isUnderWay() {
        return core.isBusy() && !core.isInterrupted();
    }

    /** Begins what is upcoming; null if nothing has begun. */
    @Nullable
    Pending begin() {
        core.ready();
        return core.isBusy() ? begun() : null;
    }

    /** Goes on with the occurrence in progress until it has ended, or has to be begun again. */
    void run(long atNanos) {
        boolean continues = true;
        while (continues && isUnderWay()) {
            continues = advance(atNanos);
        }
        look();
    }

    /** Takes the next step of a plan of its own; false if there is none. */
    private boolean advance(long atNanos) {
        Pending pending = begun();
        if (pending == null) {
            return false;
        }
        long number = pending.number();
        Ending recorded = then.apply(number);
        Decision resumed = core.resumed();
        if (resumed != null) {
            core.planned(number, resumed, atNanos);
        } else if (isUndecided()) {
            plan(pending, recorded, atNanos);
        } else if (next instanceof Output.Send send) {
            String failure = recorded == null ? "" : recorded.failure(send.step(), failed(), took());
            if (!failure.isEmpty()) {
                core.failed(number, failure, atNanos);
            } else {
                core.sending(number);
                if (core.maySend(number)) {
                    core.sent(number, true, atNanos);
                }
            }
        } else if (next instanceof Output.Run) {
            core.running(number);
            core.effectRun(number, recorded == null ? "" : recorded.effectFailure(), atNanos);
        } else if (next instanceof Output.Locate) {
            core.located(number, core.at().original(), atNanos);
        } else {
            return false;
        }
        return true;
    }

    /** What a component did to the event before the models decided, or by a rule of its own, it does here, too. */
    private void plan(Pending pending, @Nullable Ending recorded, long atNanos) {
        long number = pending.number();
        if (recorded != null && recorded.ended().decision() instanceof Decision.Refused refused) {
            core.planned(number, new Decision.Refused(core.at(), refused.reason()), atNanos);
        } else if (recorded == null || !recorded.undecided()) {
            core.planned(number, decide(pending, recorded == null ? Set.of() : recorded.guards()), atNanos);
        } else if (recorded.ended().outcome().isIncomplete()) {
            core.failed(number, recorded.ended().detail(), atNanos);
        } else {
            core.dismissed(number, atNanos);
        }
    }

    /** Its decision, if these guards hold. */
    Decision decide(Pending pending, Set<String> guards) {
        return decide(core.rules(), core.at(), core.steps(), pending, guards);
    }

    static Decision decide(Rules rules, Configuration at, long steps, Pending pending, Set<String> guards) {
        Set<String> holding = new HashSet<>(guards);
        if (pending.occurrence() instanceof Occurrence.Heard heard) {
            holding.addAll(heard.holding());
        }
        return rules.decide(at, steps, pending, holding::contains);
    }
}
