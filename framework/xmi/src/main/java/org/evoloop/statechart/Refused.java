package org.evoloop.statechart;

/** Thrown when flattening meets a construct without a meaning. */
final class Refused extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient Problem problem;
    /** Whether it does not matter in a state that the machine cannot reach. */
    private final boolean onlyWhenReached;

    Refused(Place place, String message, String remedy) {
        this(new Problem(place, message, remedy), false);
    }

    private Refused(Problem problem, boolean onlyWhenReached) {
        super(problem.message(), null, false, false);
        this.problem = problem;
        this.onlyWhenReached = onlyWhenReached;
    }

    /** Of something that does not matter in a state that the machine cannot reach. */
    static Refused whenReached(Place place, String message, String remedy) {
        return new Refused(new Problem(place, message, remedy), true);
    }

    static Refused endless(Link link) {
        return whenReached(
                link.arc.place(),
                "transitions without events lead in an endless circle through " + link.source,
                "give one of them an event");
    }

    Problem problem() {
        return problem;
    }

    boolean onlyWhenReached() {
        return onlyWhenReached;
    }
}
