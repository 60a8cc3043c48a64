package org.evoloop.rehearsal;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.engine.Core;
import org.evoloop.engine.Output;
import org.evoloop.engine.Outputs;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.codec.DecisionKind;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Receives a core's outputs, and knows how each event ended, which one is in progress, and which timers run.
 *
 * <p>Threading: not thread-safe.
 */
class Chronicle implements Outputs {
    private final Endings endings;
    private final Map<Event, Long> timers = new LinkedHashMap<>();
    private @Nullable Core core;
    private List<String> sent = new ArrayList<>();
    private int took;
    private Set<String> guards = Set.of();

    /** The steps of the occurrence in progress that have failed, if it continues; null if none has. */
    private @Nullable BrokenPlan broken;

    /** The occurrence in progress; null if there is none. */
    private @Nullable Pending begun;

    /** Whether nothing has been decided about it. */
    private boolean undecided;

    private boolean began;
    private boolean doubted;

    /** Receives how events end. */
    interface Endings {
        /**
         * An event has ended.
         *
         * @param number 0 if it never was in progress
         * @param ending null if it is no event of the models
         */
        void ended(long number, @Nullable Ending ending);
    }

    Chronicle(Endings endings) {
        this.endings = endings;
    }

    /** The outputs are those of {@code followed} from now on. */
    final void follow(Core followed) {
        core = followed;
        Snapshot now = followed.snapshot();
        timers.clear();
        timers.putAll(now.visit().over() ? Map.of() : now.visit().deadlines());
        now.waiting().stream()
                .map(Pending::occurrence)
                .filter(each -> each.source() == Source.TIMER
                        && each.visit() == now.visit().number())
                .forEach(each -> timers.remove(((Occurrence.Heard) each).event()));
        begun = now.work() == null ? null : now.work().pending();
    }

    @Override
    public void say(Output output) {
        if (output instanceof Output.Begin begin) {
            sent = new ArrayList<>();
            took = 0;
            undecided = true;
            began = true;
            begun = begin.pending();
            broken = begin.pending().broken();
            guards = broken == null ? Set.of() : guards;
        } else if (output instanceof Output.Send send) {
            sent.add(send.step().trigger().name());
        } else if (output instanceof Output.Took) {
            took++;
        } else if (output instanceof Output.Decided decided) {
            undecided = false;
            guards = union(guards, guardsOf(decided.decision()));
        } else if (output instanceof Output.Doubted doubt) {
            doubted |= !doubt.why().isEmpty();
        } else if (output instanceof Output.Leave) {
            timers.clear();
        } else if (output instanceof Output.Enter enter) {
            timers.clear();
            timers.putAll(enter.deadlines());
        } else if (output instanceof Output.CarryOver carryOver) {
            timers.clear();
            timers.putAll(carryOver.deadlines());
        } else if (output instanceof Output.Ended ended) {
            end(ended);
        }
    }

    /** The guards that held for a decision; where a function asks for an event, they are the device's. */
    static Set<String> guardsOf(Decision decision) {
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
        if (ended.occurrence() instanceof Occurrence.InDoubt) {
            State there = ended.after().original();
            return there.equals(ended.before().original()) ? null : asFound(ended);
        }
        return ended.occurrence() instanceof Occurrence.Violated ? null : ended;
    }

    /** The same, as if the device had been found where it is now. */
    static Output.Ended asFound(Output.Ended ended) {
        return new Output.Ended(
                new Occurrence.Found(
                        ended.after().original(), ended.occurrence().observedNanos()),
                ended.before(),
                ended.after(),
                ended.outcome(),
                ended.decision(),
                ended.detail());
    }

    private void end(Output.Ended output) {
        // An event that neither model knows ends at once, maybe while another is in progress.
        Pending ends = core != null && core.isBusy() ? null : begun;
        Output.Ended ended = ofModels(output);
        Ending ending = null;
        if (ended != null) {
            Decision decision = ended.decision();
            String why = decision == null ? ended.detail() : words(decision);
            List<String> steps = ends == null ? List.of() : sent;
            Verdict verdict = new Verdict(ended.before(), ended.after(), ended.outcome(), steps, why);
            ending = ends == null
                    ? new Ending(ended, verdict, 0, Set.of(), null, false)
                    : new Ending(ended, verdict, took, guards, broken, undecided);
        }
        if (ends != null) {
            sent = new ArrayList<>();
            begun = null;
            undecided = false;
        }
        endings.ended(ends == null ? 0 : ends.number(), ending);
    }

    private static String words(Decision decision) {
        String reason = DecisionKind.reasonOf(decision);
        return DecisionKind.of(decision).word() + (reason.isEmpty() ? "" : ", " + reason);
    }

    /** Forgets what {@link #began} and {@link #isInDoubtAnew} report, and an occurrence that has been put back. */
    final void look() {
        began = false;
        doubted = false;
        begun = core != null && core.isBusy() ? begun : null;
    }

    /** Whether an occurrence has begun since the last {@link #look}. */
    final boolean began() {
        return began;
    }

    /** Whether a doubt has come since the last {@link #look}. */
    final boolean isInDoubtAnew() {
        return doubted;
    }

    /** The occurrence in progress; null if there is none. */
    final @Nullable Pending begun() {
        return begun;
    }

    /** Whether nothing has been decided about the occurrence in progress. */
    final boolean isUndecided() {
        return undecided;
    }

    /** When the timers of the present visit are due; those that have fired are removed. */
    final Map<Event, Long> timers() {
        return timers;
    }

    final int took() {
        return took;
    }

    /** How many steps of the occurrence in progress have failed before. */
    final int failed() {
        return broken == null ? 0 : broken.failed().size();
    }
}
