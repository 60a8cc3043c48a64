package org.evoloop.statechart;

/**
 * Why a statechart has no flat machine.
 *
 * <p>Threading: immutable.
 *
 * @param place of the element in its file
 * @param message what is wrong, with kind and name of the element
 * @param mend what its author can do
 */
public record Problem(Place place, String message, String mend) {
    /** {@code message; mend}, without the place. */
    public String text() {
        return message + "; " + mend;
    }

    /** For messages. */
    @Override
    public String toString() {
        return place.equals(Place.NONE) ? text() : place + ": " + text();
    }
}
