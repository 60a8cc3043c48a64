package org.evoloop.loop;

/**
 * Superclass of what the four components of a loop share.
 *
 * <p>Threading: knowledge is read and written from several threads and must be safe for that. Within one cycle the loop
 * orders the components strictly, so what one of them wrote the next one sees.
 *
 * @since 0.1
 */
public abstract class Knowledge {

    /** For subclasses. */
    protected Knowledge() {}

    /** What the console and the logs call it: the name of its class. */
    public String name() {
        return getClass().getSimpleName();
    }
}
