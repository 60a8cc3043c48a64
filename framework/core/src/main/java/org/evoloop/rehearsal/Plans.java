package org.evoloop.rehearsal;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Rules;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** Other models follow the converter's plan for an occurrence as long as theirs is the same. */
final class Plans {
    private Plans() {}

    /** Its number; 0 if there is none. */
    static long numberOf(@Nullable Pending pending) {
        return pending == null ? 0 : pending.number();
    }

    /** The occurrence that an input is about; 0 if it is about none. */
    static long numberOf(Input input) {
        if (input instanceof Input.Planned planned) {
            return planned.number();
        } else if (input instanceof Input.Dismissed dismissed) {
            return dismissed.number();
        } else if (input instanceof Input.Sending sending) {
            return sending.number();
        } else if (input instanceof Input.Sent sent) {
            return sent.number();
        } else if (input instanceof Input.Running running) {
            return running.number();
        } else if (input instanceof Input.EffectRun run) {
            return run.number();
        } else if (input instanceof Input.Located located) {
            return located.number();
        } else if (input instanceof Input.Failed failed) {
            return failed.number();
        }
        return input instanceof Input.GivenUp givenUp ? givenUp.number() : 0;
    }

    /**
     * Gives an input about the occurrence in progress to the other models.
     *
     * @param earlier the converter before it
     * @param rules the converter's
     * @param number what the other models have for the occurrence
     * @return whether they are still in step; else they have not got it
     */
    static boolean follow(Input input, Earlier earlier, Rules rules, Rehearsal other, long number) {
        Core core = other.core;
        if (input instanceof Input.Planned planned) {
            return plan(planned, earlier, rules, other, number);
        } else if (input instanceof Input.Dismissed dismissed) {
            core.dismissed(number, dismissed.atNanos());
        } else if (input instanceof Input.Sending) {
            core.sending(number);
        } else if (input instanceof Input.Sent sent) {
            core.sent(number, sent.inOrder(), sent.atNanos());
        } else if (input instanceof Input.Running) {
            core.running(number);
        } else if (input instanceof Input.EffectRun run) {
            core.effectRun(number, run.failure(), run.atNanos());
        } else if (input instanceof Input.Located located) {
            core.located(number, located.state(), located.atNanos());
        } else if (input instanceof Input.Failed failed) {
            core.failed(number, failed.reason(), failed.atNanos());
        } else if (input instanceof Input.GivenUp givenUp) {
            core.givenUp(number, givenUp.reason(), givenUp.atNanos());
        }
        return true;
    }

    private static boolean plan(Input.Planned planned, Earlier earlier, Rules rules, Rehearsal other, long number) {
        Core core = other.core;
        Pending pending = earlier.current();
        Decision resumed = core.resumed();
        if (earlier.resumed() || resumed != null) {
            if (earlier.resumed() && resumed != null) {
                core.planned(number, resumed, planned.atNanos());
                return true;
            }
            return false;
        }
        Pending others = other.begun();
        if (!earlier.undecided() || pending == null || others == null) {
            return earlier.undecided() == other.isUndecided();
        }
        Decision decision = planned.decision();
        Decision own = own(decision, earlier, pending, rules, other, others);
        boolean overtaken = !decision.startsIn(earlier.at());
        if (overtaken ? own.startsIn(other.at()) : !isSame(decision, own)) {
            return false;
        }
        core.planned(number, own, planned.atNanos());
        return true;
    }

    /** What the other models decide; with a rule of a component that refused or refined it, that rule's result. */
    private static Decision own(
            Decision decision, Earlier earlier, Pending pending, Rules rules, Rehearsal other, Pending others) {
        if (!decision.startsIn(earlier.at()) && !decision.startsIn(other.at())) {
            return decision;
        }
        if (decision instanceof Decision.Refused refused) {
            return new Decision.Refused(other.at(), refused.reason());
        }
        Set<String> guards = new HashSet<>(Chronicle.guardsOf(decision));
        boolean refined = !Rehearsal.decide(rules, earlier.at(), earlier.steps(), pending, guards)
                .equals(decision);
        return refined && isPossible(decision, other) ? decision : other.decide(others, guards);
    }

    /** Whether the other models draw what the decision takes, and are where it begins. */
    private static boolean isPossible(Decision decision, Rehearsal other) {
        ModelPair models = other.core.rules().table().models();
        Transition taken = decision.transition();
        return decision.startsIn(other.at())
                && (taken == null || models.evolved().transitions().contains(taken))
                && models.evolved().hasState(decision.after().evolved())
                && decision.steps().stream()
                        .allMatch(step -> models.original().transitions().contains(step.transition()));
    }

    /** Whether both have the same sent and run. */
    private static boolean isSame(Decision one, Decision another) {
        return (one instanceof Decision.Inquiry) == (another instanceof Decision.Inquiry)
                && one.effects().equals(another.effects())
                && names(one.steps()).equals(names(another.steps()));
    }

    private static List<String> names(List<Step> steps) {
        return steps.stream()
                .map(step -> step.source() + " " + step.trigger() + " " + step.target() + " " + step.byDevice())
                .toList();
    }
}
