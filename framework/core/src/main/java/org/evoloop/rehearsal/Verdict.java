package org.evoloop.rehearsal;

import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Outcome;

/**
 * The result of an event.
 *
 * <p>Threading: immutable.
 *
 * @param before the states of device and evolved system before it
 * @param after their states after it
 * @param sent the events to be sent to the device, in order
 * @param why for people: the decision's kind and reason, or why the event had no effect
 * @since 0.1
 */
public record Verdict(Configuration before, Configuration after, Outcome outcome, List<String> sent, String why) {
    public Verdict {
        sent = List.copyOf(sent);
    }

    /** Whether both are the same, compared by the names of states. */
    public boolean isSame(Verdict other) {
        return outcome == other.outcome && sent.equals(other.sent) && after.equals(other.after);
    }

    /** For messages: {@code (On, On) -> (Spot, Spot), sends Spot}. */
    @Override
    public String toString() {
        String moved = before.equals(after) ? "stays in " + before : before + " -> " + after;
        return moved + (sent.isEmpty() ? "" : ", sends " + String.join(", ", sent)) + (why.isEmpty() ? "" : ": " + why);
    }
}
