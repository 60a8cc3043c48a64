package org.evoloop.statechart;

/** Thrown when flattening meets a construct without a meaning. */
final class Refused extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient Problem problem;

    Refused(Place place, String message, String remedy) {
        super(message, null, false, false);
        this.problem = new Problem(place, message, remedy);
    }

    Problem problem() {
        return problem;
    }
}
