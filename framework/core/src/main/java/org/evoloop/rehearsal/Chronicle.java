package org.evoloop.rehearsal;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.evoloop.core.Output;
import org.evoloop.core.Outputs;
import org.evoloop.core.text.DecisionKind;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Receives a core's outputs, and reports how each event ended.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public class Chronicle implements Outputs {
    private final Consumer<Ending> endings;
    private List<String> sent = new ArrayList<>();
    private int took;
    private Set<String> guards = Set.of();

    /** The steps of the occurrence in progress that have failed, if it continues; null if none has. */
    private @Nullable BrokenPlan broken;

    /** The occurrence in progress; null if there is none, or if it began before this did. */
    private @Nullable Occurrence begun;

    /** Whether nothing has been decided about it. */
    private boolean undecided;

    private long visit;

    /**
     * Reports every event that ends.
     *
     * @param visit the visit in which the core begins
     */
    public Chronicle(long visit, Consumer<Ending> endings) {
        this.visit = visit;
        this.endings = endings;
    }

    @Override
    public void say(Output output) {
        if (output instanceof Output.Begin begin) {
            sent = new ArrayList<>();
            took = 0;
            undecided = true;
            begun = begin.pending().occurrence();
            broken = begin.pending().broken();
            guards = broken == null ? Set.of() : guards;
        } else if (output instanceof Output.Send send) {
            sent.add(send.step().trigger().name());
        } else if (output instanceof Output.Took) {
            took++;
        } else if (output instanceof Output.Decided decided) {
            undecided = false;
            guards = union(guards, guardsOf(decided.decision()));
        } else if (output instanceof Output.Enter enter) {
            visit = enter.visit();
        } else if (output instanceof Output.CarryOver carryOver) {
            visit = carryOver.visit();
        } else if (output instanceof Output.Ended ended) {
            end(ended);
        }
    }

    /** The guards that held for a decision; where a function asks for an event, they are the device's. */
    private static Set<String> guardsOf(Decision decision) {
        Transition transition = decision.transition();
        Set<String> held = new HashSet<>(
                transition == null ? List.of() : transition.event().guards());
        if (decision instanceof Decision.Sending) {
            decision.steps().forEach(step -> held.addAll(step.event().guards()));
        }
        return held;
    }

    private static Set<String> union(Set<String> one, Set<String> other) {
        Set<String> both = new HashSet<>(one);
        both.addAll(other);
        return both;
    }

    /** Doubts and violations are not events of the models; that the device was elsewhere than recorded is one. */
    private static Output.@Nullable Ended ofModels(Output.Ended ended) {
        if (ended.occurrence() instanceof Occurrence.InDoubt doubt) {
            State there = ended.after().original();
            return there.equals(ended.before().original())
                    ? null
                    : new Output.Ended(
                            new Occurrence.Found(there, doubt.observedNanos()),
                            ended.before(),
                            ended.after(),
                            ended.outcome(),
                            ended.decision(),
                            ended.detail());
        }
        return ended.occurrence() instanceof Occurrence.Violated ? null : ended;
    }

    private void end(Output.Ended output) {
        // An event that neither model knows ends at once, maybe while another is in progress.
        boolean atOnce = begun != null && output.occurrence() != begun;
        Output.Ended ended = ofModels(output);
        if (ended != null) {
            Decision decision = ended.decision();
            String why = decision == null ? ended.detail() : words(decision);
            List<String> steps = atOnce ? List.of() : sent;
            Verdict verdict = new Verdict(ended.before(), ended.after(), ended.outcome(), steps, why);
            endings.accept(
                    atOnce
                            ? new Ending(ended, verdict, 0, Set.of(), null, false)
                            : new Ending(ended, verdict, took, guards, broken, undecided));
        }
        if (!atOnce) {
            sent = new ArrayList<>();
            begun = null;
            undecided = false;
        }
    }

    private static String words(Decision decision) {
        String reason = DecisionKind.reasonOf(decision);
        return DecisionKind.of(decision).word() + (reason.isEmpty() ? "" : ", " + reason);
    }

    /** The number of the current visit. */
    public long visit() {
        return visit;
    }

    int took() {
        return took;
    }

    /** How many steps of the occurrence in progress have failed before. */
    int failed() {
        return broken == null ? 0 : broken.failed().size();
    }
}
