package org.evoloop.loop;

import java.util.Objects;

/**
 * What a loop is made of. Each component that is part of a loop has a thread of its own, from the moment it becomes part
 * until it leaves or the loop ends; its methods are called on that thread only, so a component needs no locks for what
 * it keeps to itself.
 *
 * <p>A component may be part of one loop at a time.
 */
public abstract sealed class Component permits Monitor, Analyze, Plan, Execute {

    /** The four activities of the loop, in their order. */
    public enum Role {
        MONITOR,
        ANALYZE,
        PLAN,
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
