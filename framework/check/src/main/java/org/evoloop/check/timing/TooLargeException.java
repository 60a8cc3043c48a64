package org.evoloop.check.timing;

/** A model is too large to be decided in time. */
final class TooLargeException extends RuntimeException {
    private static final long serialVersionUID = 1;

    /** @param figure what is too large, and how large */
    TooLargeException(String figure) {
        super(figure);
    }
}
