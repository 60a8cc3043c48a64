package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * Superclass of monitors: they wait for something to occur and report it. A loop may have several; the reports of each
 * stay in order.
 *
 * <p>Threading: {@link #getEvent} is called again and again on the monitor's own thread, from when the loop is built.
 * It is also called while the loop is closed: its reports are then refused, so that they are not mistaken for news when
 * the loop opens.
 *
 * @param <O> an occurrence, the input of {@link Analyze}
 * @since 0.1
 */
public abstract non-sealed class Monitor<O> extends Component {

    /** A component named after its class. */
    protected Monitor() {
        this("");
    }

    /** @param name its name in the console, unique within a loop */
    protected Monitor(String name) {
        super(name);
    }

    @Override
    public final Role role() {
        return Role.MONITOR;
    }

    /**
     * Waits for the next occurrence.
     *
     * @return what occurred, or null if nothing did for now; a monitor that has nothing to report should wait rather
     *     than return null at once
     * @throws InterruptedException if the thread is interrupted while it waits; that is never an error
     * @throws Exception any failure: it is reported and counted, and the monitor is called again after a pause that
     *     grows from 0.1 s to 5 s while it keeps failing
     */
    protected abstract @Nullable O getEvent() throws Exception;
}
