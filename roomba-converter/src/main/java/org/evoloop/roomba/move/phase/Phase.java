package org.evoloop.roomba.move.phase;

/**
 * What Move is about.
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

    /** What to do now, and what to be about at the next moment. */
    record Step(Phase phase, Maneuver maneuver) {}

    /** What it needs to know of the way here, and of what is wanted. */
    Memory memory();

    /** The phase at its first moment, which may be one of another kind. */
    Phase begun(Situation now);

    /** The next step, while the robot obeys and nothing is in its way. */
    Step next(Situation now);

    /** What the robot is about, in a few words. */
    String describe();

    /** Whether an obstacle ahead must end it. */
    boolean leadsForward();

    /** Where Move begins: it looks around. */
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

    /** Stops; then {@code phase}. */
    static Step standing(Phase phase) {
        return new Step(phase, Maneuver.STAND);
    }
}
