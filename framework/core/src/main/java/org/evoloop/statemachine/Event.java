package org.evoloop.statemachine;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * An event that may trigger transitions; its identity is its name, as drawn on the transition, and its guards.
 *
 * <p>A guarded trigger is an event of its own, which exists only while its conditions hold, so that T remains a
 * function of states and events. A monitor reports only the name; which of the guarded events it is, is decided when it
 * comes.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Event implements Comparable<Event> {
    private final String name;
    private final List<String> guards;
    /** Cached, like that of a {@link State}. */
    private final int hash;

    /**
     * @param name as drawn, not blank; a name such as {@code tm(2s)} is a time trigger
     * @param guards the conditions that must all hold, as drawn; empty for an event without conditions
     * @throws NullPointerException if an argument or one of the guards is null; the message says which
     * @throws ModelException if {@code name} or one of the guards is blank
     */
    public Event(String name, List<String> guards) {
        if (requireNonNull(name, "the name of an event is null").isBlank()) {
            throw new ModelException("an event has no name; give it one");
        }
        Names.requireAll(guards, "the guards of an event are null, or one of them is; List.of() are none");
        this.name = name;
        this.guards = List.copyOf(guards);
        for (int index = 0; index < this.guards.size(); index++) {
            if (this.guards.get(index).isBlank()) {
                throw new ModelException("a guard of event " + name + " is blank; write its condition or leave it out");
            }
        }
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

    /** The conditions that must all hold, as drawn; empty for an event without conditions. */
    public List<String> guards() {
        return guards;
    }

    /** The event without its guards, as monitors report it and as it can be sent. */
    public Event trigger() {
        return guards.isEmpty() ? this : new Event(name);
    }

    /**
     * How long a state must last before this event is raised automatically; empty for any other event.
     *
     * @throws ModelException if the name has the form of a time trigger but holds no duration, see {@link TimeTrigger}
     */
    public Optional<Duration> timeTrigger() {
        return TimeTrigger.parse(name);
    }

    /**
     * The name of a time trigger with a unit added if its number has none; any other name unchanged.
     *
     * @param name the name of an event, such as {@code after 2}
     * @param unit milliseconds or seconds
     * @throws NullPointerException if an argument is null; the message says which
     * @throws IllegalArgumentException if {@code unit} is another one
     */
    public static String withTimeUnit(String name, ChronoUnit unit) {
        return TimeTrigger.withUnit(
                requireNonNull(name, "the name of an event is null"),
                switch (requireNonNull(unit, "the unit of a time trigger is null; use MILLIS or SECONDS")) {
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
