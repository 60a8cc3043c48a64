package org.evoloop.roomba.move.phase;

/**
 * What Move is doing.
 *
 * <pre>
 *   Look --seen--&gt; Approach --near enough--&gt; Check --as wanted--&gt; arrived
 *    | ^              |  '--lost--&gt; Look         '--not quite--&gt; Turn, Leg or Approach, and Check again
 *    | '-Turn         '--obstacle--&gt; Leg back, Turn away, Leg on, Look
 *    '--nowhere--&gt; Turn, Leg elsewhere, Look
 * </pre>
 *
 * <p>Threading: immutable; the methods are pure functions.
 */
public sealed interface Phase permits Look, Look.Around, Turn, Leg, Approach, Check {

    /** What to do now, and the phase for the next moment. */
    record Step(Phase phase, Maneuver maneuver) {}

    /** What is remembered of the way so far and of the target. */
    Memory memory();

    /** The phase to start with; may be of another kind. */
    Phase begun(Situation now);

    /** The next step, provided that the robot obeys and nothing is in its way. */
    Step next(Situation now);

    /** A short description for people. */
    String describe();

    /** Whether an obstacle ahead ends this phase. */
    boolean leadsForward();

    /** Move's first phase: look around. */
    static Phase first(Memory memory) {
        return new Look.Around(memory);
    }

    /** The next step in any situation. */
    static Step inAny(Phase phase, Situation now) {
        if (now.end().isDue()) {
            return new Step(phase, new Maneuver.GiveUp(now.end()));
        }
        if (!now.obeys() || now.sight().stale()) {
            return new Step(phase, Maneuver.STAND);
        }
        boolean retreats = phase instanceof Leg && !phase.leadsForward();
        if ((now.edge() && !retreats) || (now.obstacle() != Situation.Obstacle.NONE && phase.leadsForward())) {
            return standing(Detour.around(phase, now));
        }
        return phase.next(now);
    }

    /** Stands still, then continues with {@code phase}. */
    static Step standing(Phase phase) {
        return new Step(phase, Maneuver.STAND);
    }
}
