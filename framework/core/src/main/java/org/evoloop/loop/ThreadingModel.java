package org.evoloop.loop;

/**
 * The threads that call the analyze, plan and execute components of a loop. Each monitor has a thread of its own.
 *
 * @since 0.1
 */
public enum ThreadingModel {
    /**
     * One thread, the carrier, takes an occurrence through all of them. It is woken once for each occurrence, not once
     * for each component. If a component does not return in time, a new carrier takes the next occurrences; the thread
     * in which the component hangs ends when it returns.
     */
    SINGLE_CARRIER,
    /** Each component has a thread of its own, as in the paper, and an occurrence goes from thread to thread. */
    THREAD_PER_COMPONENT,
    /** No threads, not even for monitors: the caller of {@link MapeLoop#observe} and {@link MapeLoop#step}. */
    CALLER
}
