package org.evoloop.rehearsal;

import java.util.List;
import org.evoloop.core.Outcome;
import org.evoloop.evolution.Configuration;

/**
 * What became of an event.
 *
 * <p>Threading: immutable.
 *
 * @param before where device and evolved system stood
 * @param after where they stood then
 * @param sent what the device was to be sent, in order
 * @param why for people: the decision's kind and reason, or why it came to nothing
 * @since 0.1
 */
public record Verdict(Configuration before, Configuration after, Outcome outcome, List<String> sent, String why) {
    public Verdict {
        sent = List.copyOf(sent);
    }

    /** Whether the same was decided, wherever the names of states have come from. */
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
