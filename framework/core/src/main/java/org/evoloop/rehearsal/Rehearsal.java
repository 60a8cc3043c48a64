package org.evoloop.rehearsal;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Outcome;
import org.evoloop.core.Output;
import org.evoloop.core.Pending;
import org.evoloop.core.Reframed;
import org.evoloop.core.Rules;
import org.evoloop.core.Snapshot;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Gives another core the inputs of a converter, as described in {@link Comparison}.
 *
 * <p>Threading: not thread-safe.
 */
final class Rehearsal extends Chronicle {
    /**
     * A tolerance: a timer of the converter is reported a moment after it is due, and the other core enters its states
     * a moment later.
     */
    private static final long SAME_TIMER_NANOS = Duration.ofSeconds(1).toNanos();

    private final Function<Occurrence, @Nullable Ending> then;
    private final Core core;
    private final Deque<Output.Directive> toDo = new ArrayDeque<>();
    private final Map<Event, Long> timers = new HashMap<>();
    /** Observed events that have not ended here, in order. */
    private final List<Occurrence> outstanding = new ArrayList<>();

    private @Nullable Pending begun;
    private boolean planned;

    /**
     * Begins.
     *
     * @param then says how an event ended in the converter; null if it did not come there, or has not ended
     * @param endings receives how each event ends here
     */
    Rehearsal(Rules rules, Snapshot from, Function<Occurrence, @Nullable Ending> then, Consumer<Ending> endings) {
        super(from.visit().number(), endings);
        this.then = then;
        this.timers.putAll(from.visit().deadlines());
        this.core = new Core(roomier(rules), from, this);
    }

    /**
     * An event that is in progress in the converter may still wait here, so there is a place for it. Which presses were
     * too old is known from the converter.
     */
    private static Rules roomier(Rules rules) {
        return new Rules(rules.table(), rules.timers(), rules.queueCapacity() + 1);
    }

    @Override
    public void say(Output output) {
        super.say(output);
        if (output instanceof Output.Begin begin) {
            begun = begin.pending();
            planned = false;
        } else if (output instanceof Output.Enter enter) {
            timers.clear();
            timers.putAll(enter.deadlines());
        } else if (output instanceof Output.Leave) {
            timers.clear();
        } else if (output instanceof Output.Ended ended) {
            isOut(ended.occurrence());
        } else if (output instanceof Output.Dropped dropped) {
            isOut(dropped.occurrence());
        } else if (output instanceof Output.Refused refused) {
            isOut(refused.occurrence());
        }
        if (output instanceof Output.Directive directive) {
            toDo.add(directive);
        }
    }

    private void isOut(Occurrence occurrence) {
        for (int index = 0; index < outstanding.size(); index++) {
            if (isSame(outstanding.get(index), occurrence)) {
                outstanding.remove(index);
                return;
            }
        }
    }

    /** Whether both are the same event, for whichever models. */
    static boolean isSame(Occurrence one, Occurrence other) {
        long apart = Math.abs(one.observedNanos() - other.observedNanos());
        return one.source() == other.source()
                && one.label().equals(other.label())
                && apart <= (one.source() == Source.TIMER ? SAME_TIMER_NANOS : 0);
    }

    /** The other models' states. */
    Configuration at() {
        return core.at();
    }

    /**
     * An event is observed; it has its {@link #turn} later. An event that belongs to a visit counts only if the other
     * models are in the state of that visit.
     *
     * @param raisedIn the current state of the converter, if the event belongs to its visit; null if it belongs to an
     *     older one
     */
    void hear(Occurrence occurrence, @Nullable State raisedIn, long atNanos) {
        fire(atNanos);
        Occurrence here = occurrence;
        if (occurrence.visit() != Occurrence.ANY_VISIT) {
            here = at().evolved().equals(raisedIn) ? Reframed.inVisit(occurrence, visit()) : null;
        }
        if (here != null) {
            observe(here);
        }
    }

    private void observe(Occurrence here) {
        long before = like(here);
        int waiting = core.waiting();
        outstanding.add(here);
        core.observed(here);
        if (!core.doubt().isEmpty()) {
            // The converter has asked the device, and what that has answered comes as a finding.
            core.restore(core.rules(), core.snapshot().withoutDoubt());
        }
        if (here instanceof Occurrence.Found && core.waiting() == waiting && like(here) > before) {
            // No news, so it never has its turn.
            isOut(here);
        }
    }

    /** The device is found before anything else has its turn. */
    void find(Occurrence found, long atNanos) {
        int before = core.waiting();
        hear(found, null, atNanos);
        if (core.waiting() > before) {
            core.restore(core.rules(), core.snapshot().lastFirst());
        } else if (core.snapshot().followOwed() && !core.rules().table().isFollowed(at())) {
            // The record is there already; the new model follows.
            convert(atNanos);
        }
    }

    /** An event has ended in the converter: here it has its turn, after those that came before it. */
    void turn(Occurrence occurrence, long atNanos) {
        fire(atNanos);
        if (occurrence.source() == Source.TIMER && like(occurrence) == 0) {
            timers.entrySet().stream()
                    .filter(timer -> timer.getKey().toString().equals(occurrence.label())
                            && timer.getValue() - atNanos <= SAME_TIMER_NANOS)
                    .map(Map.Entry::getKey)
                    .findFirst()
                    .ifPresent(timer -> due(timer, atNanos));
        }
        long before = like(occurrence);
        boolean continues = before > 0;
        while (continues && like(occurrence) == before) {
            continues = convert(atNanos);
        }
        settle(atNanos);
    }

    /** Whether an equal event was observed and has not ended here. */
    boolean awaits(Occurrence occurrence) {
        return like(occurrence) > 0;
    }

    /** How many equal events have not ended here; there may be two while a test's clock does not advance. */
    private long like(Occurrence occurrence) {
        return outstanding.stream().filter(each -> isSame(each, occurrence)).count();
    }

    /** The converter was opened or closed. */
    void follow(Input input, long atNanos) {
        fire(atNanos);
        if (input instanceof Input.Opened || input instanceof Input.Closing || input instanceof Input.Closed) {
            core.apply(input);
        } else if (input instanceof Input.Recovered) {
            core.closing();
            core.closed();
        }
        settle(atNanos);
    }

    /**
     * Fires the timers due by then, earliest first. A timer that the converter may also have waits for its turn there.
     */
    void fire(long atNanos) {
        expire(atNanos);
        while (true) {
            Map.Entry<Event, Long> next = null;
            for (Map.Entry<Event, Long> timer : timers.entrySet()) {
                boolean sooner = next == null || timer.getValue() < next.getValue();
                next = timer.getValue() <= atNanos && sooner ? timer : next;
            }
            if (next == null) {
                return;
            }
            due(next.getKey(), next.getValue());
            expire(atNanos);
        }
    }

    private void due(Event timer, long deadline) {
        long due = Math.max(deadline, core.nowNanos());
        timers.remove(timer);
        outstanding.add(new Occurrence.Heard(timer, Values.NONE, Source.TIMER, visit(), due));
        core.timerDue(visit(), timer, due);
    }

    /** Gives timers that the converter does not have their turns. */
    private void expire(long atNanos) {
        boolean continues = true;
        while (continues && !outstanding.isEmpty()) {
            Occurrence first = outstanding.get(0);
            boolean expired = atNanos - first.observedNanos() > SAME_TIMER_NANOS;
            continues = expired
                    && outstanding.stream().allMatch(each -> each.source() == Source.TIMER)
                    && convert(first.observedNanos());
        }
    }

    /** Carries out what follows; events that the converter has not handled yet wait. */
    private void settle(long atNanos) {
        boolean continues = true;
        while (continues && outstanding.isEmpty()) {
            continues = convert(atNanos);
        }
    }

    /** Gives waiting events their turns, since nothing more comes. */
    void rest(long atNanos) {
        boolean continues = true;
        while (continues) {
            continues = convert(atNanos);
        }
    }

    /** Gives one event its turn; false if there is none. */
    private boolean convert(long atNanos) {
        begun = null;
        if (core.hasNext()) {
            toDo.clear();
            core.ready();
        }
        Pending pending = begun;
        while (pending != null && core.isBusy()) {
            if (!planned) {
                planned = true;
                plan(pending, then.apply(pending.occurrence()), atNanos);
            } else {
                carryOut(pending, toDo.poll(), atNanos);
            }
        }
        return pending != null;
    }

    private void carryOut(Pending pending, Output.@Nullable Directive next, long atNanos) {
        long number = pending.number();
        Ending recorded = then.apply(pending.occurrence());
        if (next instanceof Output.Send send) {
            String failure = recorded == null ? "" : recorded.failure(send.step(), failed(), took());
            if (!failure.isEmpty()) {
                core.failed(number, failure, atNanos);
            } else {
                core.sending(number);
                core.sent(number, true, atNanos);
            }
        } else if (next instanceof Output.Run) {
            core.running(number);
            core.effectRun(number, recorded == null ? "" : recorded.effectFailure(), atNanos);
        } else if (next instanceof Output.Locate) {
            core.located(number, core.at().original(), atNanos);
        }
    }

    /** What a component did to the event before the models decided, or by a rule of its own, it does here, too. */
    private void plan(Pending pending, @Nullable Ending recorded, long atNanos) {
        long number = pending.number();
        if (recorded != null && recorded.isTooOld()) {
            core.dismissed(number, atNanos);
        } else if (recorded != null && recorded.ended().decision() instanceof Decision.Refused refused) {
            core.planned(number, new Decision.Refused(core.at(), refused.reason()), atNanos);
        } else if (recorded == null || !recorded.undecided()) {
            core.planned(number, decision(pending, recorded), atNanos);
        } else if (recorded.ended().outcome() == Outcome.FAILED) {
            core.failed(number, recorded.ended().detail(), atNanos);
        } else {
            core.dismissed(number, atNanos);
        }
    }

    private Decision decision(Pending pending, @Nullable Ending recorded) {
        Set<String> holding = new HashSet<>(recorded == null ? Set.of() : recorded.guards());
        if (pending.occurrence() instanceof Occurrence.Heard heard) {
            holding.addAll(heard.holding());
        }
        return core.rules().decide(core.at(), core.steps(), pending, holding::contains);
    }
}
