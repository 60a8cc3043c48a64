package org.evoloop.loop;

import java.util.Objects;

/**
 * What a loop is made of. The methods of a component are called by one thread at a time, and what it did for one call it
 * sees in the next, so a component needs no locks for what it keeps to itself. Which thread that is says the loop's {@link
 * ThreadingModel}; with {@link ThreadingModel#SINGLE_CARRIER} it may be another one after some component was given up, so
 * nothing should be kept by thread.
 *
 * <p>A component may be part of one loop at a time.
 *
 * @since 0.1
 */
public abstract sealed class Component permits Monitor, Analyze, Plan, Execute {

    /** The four activities of the loop, in their order. */
    public enum Role {
        /** Notices events. */
        MONITOR,
        /** Decides what an event means. */
        ANALYZE,
        /** Makes the steps. */
        PLAN,
        /** Carries the steps out. */
        EXECUTE
    }

    private final String name;

    /** @param name unique within a loop; empty for the name of the class */
    Component(String name) {
        Objects.requireNonNull(name, "the name of a component is null");
        String ownName = getClass().getSimpleName();
        this.name = !name.isEmpty() ? name : ownName.isEmpty() ? "anonymous" : ownName;
    }

    /** What the console, the logs and the thread call this component; unique within a loop. */
    public final String name() {
        return name;
    }

    /** Which of the four activities this is. */
    public abstract Role role();
}
