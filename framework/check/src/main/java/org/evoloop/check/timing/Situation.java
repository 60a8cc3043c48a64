package org.evoloop.check.timing;

import java.util.List;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Work;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** The state of a core at one moment without times: the timers' remaining times are kept separately. */
final class Situation {
    final int number;
    final Snapshot snapshot;

    /** The timers of the visit; which of them have already raised their events, which wait in the queue. */
    final List<Event> timers;

    final boolean[] heard;

    /**
     * What can follow.
     *
     * @param sights what is to be seen on the way, in order
     * @param timers for each timer of the target how long it runs, or {@code -1 - place} of the same timer before
     * @param sends whether another step has been sent
     * @param enters whether another visit has begun
     */
    record Branch(Situation target, List<Sight> sights, List<Long> timers, boolean sends, boolean enters) {}

    /** The states of both models, and the event that comes then; null if there is none. */
    record Sight(Configuration at, @Nullable Event event) {}

    Situation(int number, Snapshot snapshot, List<Event> timers, boolean[] heard) {
        this.number = number;
        this.snapshot = snapshot;
        this.timers = timers;
        this.heard = heard;
    }

    Configuration at() {
        return snapshot.at();
    }

    /** The step on its way to the device; null if none is. */
    @Nullable
    Step sending() {
        Work work = snapshot.work();
        Decision decision = work == null ? null : work.decision();
        return work == null || decision == null || !work.sending()
                ? null
                : decision.steps().get(work.taken());
    }

    /** Whether the visit is being left: the events of its timers are ignored. */
    boolean isLeaving() {
        return snapshot.visit().over();
    }

    /** Whether this timer keeps running, wherever the step in progress leads. */
    boolean outlasts(int timer) {
        Work work = snapshot.work();
        Decision decision = work == null ? null : work.decision();
        Transition transition = decision == null ? null : decision.transition();
        return !isLeaving()
                || (transition != null
                        && transition.keeps().contains(timers.get(timer).name()));
    }
}
