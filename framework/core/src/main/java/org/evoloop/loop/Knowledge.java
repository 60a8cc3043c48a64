package org.evoloop.loop;

/**
 * Superclass of the knowledge shared by the four kinds of components of a loop.
 *
 * <p>Threading: knowledge is read and written by several threads and must be thread-safe. Within one cycle the loop
 * orders the components strictly, so each sees what the previous one wrote.
 *
 * @since 0.1
 */
public abstract class Knowledge {

    /** For subclasses. */
    protected Knowledge() {}

    /** Its name in the console and the logs: that of its class. */
    public String name() {
        return getClass().getSimpleName();
    }
}
