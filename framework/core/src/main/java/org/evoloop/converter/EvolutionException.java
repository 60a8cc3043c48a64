package org.evoloop.converter;

/**
 * Other models could not take over; the converter goes on with those that it has.
 *
 * @since 0.1
 */
public class EvolutionException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** @param message what was in the way */
    public EvolutionException(String message) {
        super(message);
    }
}
