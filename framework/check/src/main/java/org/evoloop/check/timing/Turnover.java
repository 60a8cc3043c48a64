package org.evoloop.check.timing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.evoloop.check.timing.Situation.Sight;
import org.evoloop.engine.Core;
import org.evoloop.engine.Output;
import org.evoloop.engine.Outputs;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** Gives a core one input, and carries out everything that follows in the same instant. */
final class Turnover implements Outputs {
    private final Rules rules;
    private final Core core;
    private final Set<String> slow;
    private final Chooser chooser;
    private final long visitBefore;
    private final List<Sight> sights = new ArrayList<>();
    private final ArrayDeque<Output> toDo = new ArrayDeque<>();
    private @Nullable Pending begun;
    private boolean sent;

    Turnover(Rules rules, Snapshot from, Set<String> slow, Chooser chooser) {
        this.rules = rules;
        this.slow = slow;
        this.chooser = chooser;
        this.visitBefore = from.visit().number();
        this.core = new Core(rules, from, this);
        this.begun = from.work() == null ? null : from.work().pending();
    }

    @Override
    public void say(Output output) {
        if (output instanceof Output.Begin begin) {
            begun = begin.pending();
            toDo.add(output);
        } else if (output instanceof Output.Send || output instanceof Output.Run || output instanceof Output.Locate) {
            toDo.add(output);
        } else if (output instanceof Output.Moved moved) {
            sights.add(new Sight(moved.after(), null));
        }
    }

    Turnover open() {
        sights.add(new Sight(core.at(), null));
        core.opened(0);
        return settle();
    }

    Turnover take(Stimulus stimulus) {
        if (stimulus.kind() == Stimulus.Kind.LANDS) {
            core.sent(number(), true, 0);
            return settle();
        }
        Event event = Objects.requireNonNull(stimulus.event());
        sights.add(new Sight(core.at(), event));
        if (stimulus.kind() == Stimulus.Kind.TIMER) {
            core.timerDue(visitBefore, event, 0);
        } else {
            core.observed(occurrence(stimulus, event));
        }
        return settle();
    }

    private Occurrence occurrence(Stimulus stimulus, Event event) {
        Source source = switch (stimulus.kind()) {
            case ACT -> Source.DEVICE;
            case RAISE -> Source.FUNCTION;
            case REACT -> Source.PROPERTY;
            default -> Source.CONTROLLER;
        };
        boolean acts = source == Source.DEVICE;
        long visit = source == Source.FUNCTION ? visitBefore : Occurrence.ANY_VISIT;
        return new Occurrence.Heard(event, Values.NONE, source, acts, stimulus.holding(), visit, 0);
    }

    private long number() {
        return Objects.requireNonNull(begun).number();
    }

    /** Continues until only waiting is left. */
    private Turnover settle() {
        boolean continues = true;
        while (continues) {
            Output next = toDo.poll();
            if (next != null) {
                continues = carryOut(next);
            } else {
                boolean mayBegin = !core.isBusy() && core.hasNext();
                core.ready();
                continues = mayBegin && !toDo.isEmpty();
            }
        }
        return this;
    }

    private boolean carryOut(Output output) {
        if (output instanceof Output.Begin) {
            chooser.anew();
            core.planned(
                    number(), rules.decide(core.at(), core.steps(), Objects.requireNonNull(begun), chooser::choose), 0);
        } else if (output instanceof Output.Send send) {
            core.sending(number());
            if (core.maySend(number())) {
                sent = slow.contains(send.step().trigger().name());
                if (sent) {
                    return false;
                }
                core.sent(number(), true, 0);
            }
        } else if (output instanceof Output.Run) {
            core.running(number());
            core.effectRun(number(), "", 0);
        } else {
            core.located(number(), null, 0);
        }
        return true;
    }

    Snapshot snapshot() {
        return core.snapshot();
    }

    long visitBefore() {
        return visitBefore;
    }

    List<Sight> sights() {
        return List.copyOf(sights);
    }

    /** Whether a step has been sent that is on its way. */
    boolean hasSent() {
        return sent;
    }
}
