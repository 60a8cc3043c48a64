package org.evoloop.payload.report;

/**
 * Something that was sent, and that is waited for.
 *
 * <p>Threading: all methods may be called from any thread; when it is no longer waited for, they do nothing.
 *
 * @since 0.1
 */
public interface Pending {
    /** It is not known whether it has its effect, and nothing will tell. */
    void fail(String why);

    /** It was refused, so it has no effect. */
    void refuse(String why);
}
