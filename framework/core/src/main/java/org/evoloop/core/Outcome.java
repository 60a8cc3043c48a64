package org.evoloop.core;

/**
 * What can become of an occurrence.
 *
 * @since 0.1
 */
public enum Outcome {
    /** It had its effect. */
    HANDLED,
    /** The new model has no transition for it, or a component dismissed it. */
    IGNORED,
    /** It was raised in an earlier visit of a state, or overtaken by what was sent since, and came too late. */
    STALE,
    /** It could not be carried out, or not to its end. */
    FAILED,
    /** The queue was full. */
    DROPPED
}
