package org.evoloop.statechart;

/**
 * A reason why a statechart has no flat machine.
 *
 * <p>Threading: immutable.
 *
 * @param place of the element in its file
 * @param message what is wrong, with kind and name of the element
 * @param remedy how to fix it
 * @since 0.1
 */
public record Problem(Place place, String message, String remedy) {
    /** The message, with the id if the message lacks it, and the remedy; without the line. */
    public String text() {
        String id = place.id();
        return message + (id.isEmpty() || message.contains("id " + id) ? "" : " (id '" + id + "')") + "; " + remedy;
    }

    /** For messages. */
    @Override
    public String toString() {
        Place where = new Place(place.file(), "", place.line());
        return where.equals(Place.NONE) ? text() : where + ": " + text();
    }
}
