package org.evoloop.statemachine;

import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * An event that may trigger transitions; its identity is its name, as drawn on the transition, and its guards.
 *
 * <p>A guarded trigger is an event of its own, which exists only while its conditions hold: so T stays a function of
 * states and events. What a monitor tells is the name alone; which of the guarded events it is, is decided when it comes.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Event implements Comparable<Event> {
    private final String name;
    private final List<String> guards;
    /** Kept, as that of a {@link State}. */
    private final int hash;

    /**
     * @param name as drawn, not blank; a name such as {@code tm(2s)} is a time trigger
     * @param guards the conditions that must all hold, as drawn; empty for an event that always counts
     * @throws ModelException if {@code name} is blank
     */
    public Event(String name, List<String> guards) {
        if (Objects.requireNonNull(name, "the name of an event is null").isBlank()) {
            throw new ModelException("an event has no name; give it one");
        }
        this.name = name;
        this.guards = List.copyOf(guards);
        this.hash = 31 * name.hashCode() + this.guards.hashCode();
    }

    /** An event without guards. */
    public Event(String name) {
        this(name, List.of());
    }

    /** As drawn, not blank. */
    public String name() {
        return name;
    }

    /** The conditions that must all hold, as drawn; empty for an event that always counts. */
    public List<String> guards() {
        return guards;
    }

    /** The same event without its guards: what a monitor tells and what can be sent. */
    public Event trigger() {
        return guards.isEmpty() ? this : new Event(name);
    }

    /**
     * How long a state must last before this event is raised by itself; empty for an event that somebody must raise.
     *
     * @throws ModelException if the name has the form of a time trigger but holds no duration, see {@link TimeTrigger}
     */
    public Optional<Duration> timeTrigger() {
        return TimeTrigger.parse(name);
    }

    /**
     * The name of a time trigger with a unit, where it has a number without one; any other name as it is.
     *
     * @param name of an event, such as {@code after 2}
     * @param unit milliseconds or seconds
     */
    public static String withTimeUnit(String name, ChronoUnit unit) {
        return TimeTrigger.withUnit(
                name,
                switch (unit) {
                    case MILLIS -> "ms";
                    case SECONDS -> "s";
                    default -> throw new IllegalArgumentException("the unit is " + unit + "; use MILLIS or SECONDS");
                });
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return this == other
                || (other instanceof Event event
                        && hash == event.hash
                        && name.equals(event.name)
                        && guards.equals(event.guards));
    }

    @Override
    public int hashCode() {
        return hash;
    }

    /** Orders by name, then by guards. */
    @Override
    public int compareTo(Event other) {
        int byName = name.compareTo(other.name);
        return byName != 0 ? byName : guards.toString().compareTo(other.guards.toString());
    }

    /** As on a diagram: {@code press [hot] [full]}. */
    @Override
    public String toString() {
        return guards.isEmpty() ? name : name + " [" + String.join("] [", guards) + "]";
    }
}
