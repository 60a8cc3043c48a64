package org.evoloop.journal;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Output;
import org.evoloop.core.Pending;
import org.evoloop.core.Rules;
import org.evoloop.core.Snapshot;
import org.evoloop.core.Tally;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Tells another core what a converter was told. Each step and effect succeeds at once, unless it failed then; timers are due by
 * the other core's own deadlines; guards hold that held then.
 *
 * <p>Threading: not thread-safe.
 */
final class Rehearsal extends Chronicle {
    private final Map<EventKey, Ending> then;
    private final Consumer<Output.Ended> heard;
    private final Core core;
    private final Deque<Output.Directive> toDo = new ArrayDeque<>();
    private final Map<Event, Long> timers = new HashMap<>();
    private @Nullable Pending begun;
    private boolean planned;

    Rehearsal(Rules rules, Configuration from, long atNanos, Map<EventKey, Ending> then, Consumer<Output.Ended> heard) {
        this.then = then;
        this.heard = heard;
        this.core = new Core(rules, still(from, atNanos), this);
    }

    private static Snapshot still(Configuration at, long nowNanos) {
        return new Snapshot(
                false,
                at,
                null,
                0,
                nowNanos,
                new Snapshot.OpenVisit(0, true, null, Map.of()),
                List.of(),
                false,
                false,
                null,
                new Tally(0, 0, 0, 0, 0, 0, 0, 0, 0),
                nowNanos);
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
        }
        if (output instanceof Output.Ended ended) {
            heard.accept(ended);
        } else if (output instanceof Output.Directive directive) {
            toDo.add(directive);
        }
    }

    /** Where the other models stand. */
    Configuration at() {
        return core.at();
    }

    /** Another input; what is carried out in between the other core sees to by itself. */
    void follow(Input input, long atNanos) {
        fire(atNanos);
        if (input instanceof Input.Observed observed) {
            core.observed(observed.occurrence());
        } else if (input instanceof Input.Opened || input instanceof Input.Closing || input instanceof Input.Closed) {
            core.apply(input);
        } else if (input instanceof Input.Recovered) {
            core.closing();
            core.closed();
        }
        settle(atNanos);
    }

    /** An event that belongs to the current visit, if the other models are in the state of that; else there is none. */
    @Nullable
    Occurrence inThisVisit(Occurrence occurrence) {
        if (occurrence instanceof Occurrence.Heard heard) {
            return new Occurrence.Heard(
                    heard.event(),
                    heard.values(),
                    heard.source(),
                    heard.deviceActed(),
                    heard.holding(),
                    visit(),
                    heard.observedNanos());
        }
        return occurrence instanceof Occurrence.Asked asked
                ? new Occurrence.Asked(asked.event(), asked.values(), visit(), asked.observedNanos())
                : null;
    }

    /** Timers that are due by then, the earliest first. */
    private void fire(long atNanos) {
        while (true) {
            Map.Entry<Event, Long> next = null;
            for (Map.Entry<Event, Long> timer : timers.entrySet()) {
                boolean sooner = next == null || timer.getValue() < next.getValue();
                next = timer.getValue() <= atNanos && sooner ? timer : next;
            }
            if (next == null) {
                return;
            }
            Event event = next.getKey();
            long due = Math.max(next.getValue(), core.nowNanos());
            timers.remove(event);
            core.timerDue(visit(), event, due);
            settle(due);
        }
    }

    private void settle(long atNanos) {
        while (true) {
            Pending pending = begun;
            if (pending != null && core.isBusy() && !planned) {
                planned = true;
                plan(pending, then.get(keyOf(pending.occurrence())), atNanos);
            } else if (pending != null && core.isBusy()) {
                carryOut(pending, toDo.poll(), atNanos);
            } else if (core.hasNext()) {
                toDo.clear();
                core.ready();
            } else {
                return;
            }
        }
    }

    private void carryOut(Pending pending, Output.@Nullable Directive next, long atNanos) {
        long number = pending.number();
        Ending recorded = then.get(keyOf(pending.occurrence()));
        if (next instanceof Output.Send) {
            if (recorded != null && recorded.isBroken() && recorded.took() <= took()) {
                core.failed(number, recorded.verdict().why(), atNanos);
            } else {
                core.sending(number);
                core.sent(number, true, atNanos);
            }
        } else if (next instanceof Output.Run) {
            core.running(number);
            core.effectRun(number, "", atNanos);
        } else if (next instanceof Output.Locate) {
            core.located(number, core.at().original(), atNanos);
        }
    }

    private void plan(Pending pending, @Nullable Ending recorded, long atNanos) {
        Set<String> holding = new HashSet<>(recorded == null ? Set.of() : recorded.guards());
        if (pending.occurrence() instanceof Occurrence.Heard heard) {
            holding.addAll(heard.holding());
        }
        Decision decision = core.rules().decide(core.at(), core.steps(), pending, holding::contains);
        core.planned(pending.number(), decision, atNanos);
    }
}
