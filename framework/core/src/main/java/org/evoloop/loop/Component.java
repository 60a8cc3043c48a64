package org.evoloop.loop;

import java.util.Objects;

/**
 * A component of a loop. Its methods are called by one thread at a time, and each call sees the effects of the previous
 * one, so a component needs no locks for its private state. The loop's {@link ThreadingModel} determines the thread;
 * with {@link ThreadingModel#SINGLE_CARRIER} it may change after a component was given up, so do not use thread-local
 * state.
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
        /** Plans the steps. */
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

    /** The name of this component in the console, the logs and the thread's name; unique within a loop. */
    public final String name() {
        return name;
    }

    /** Which of the four activities this is. */
    public abstract Role role();
}
