package org.evoloop.converter;

/**
 * Other models could not take over; the converter continues with the present ones.
 *
 * @since 0.1
 */
public class EvolutionException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** @param message what prevented it */
    public EvolutionException(String message) {
        super(message);
    }
}
