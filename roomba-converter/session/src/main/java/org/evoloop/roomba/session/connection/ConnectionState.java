package org.evoloop.roomba.session.connection;

/**
 * The phase of a connection, and its problem.
 *
 * <pre>
 *   NEW --&gt; ASKING --frame--&gt; UP --silence--&gt; ASKING
 *            |  ^  \             \
 *  no answer |  |   '--lost--------+--lost--&gt; DOWN --link opens--&gt; ASKING
 *            v  | at 115200
 *           CHANGING_RATE
 *
 *   UP --silence of a robot that may sleep--&gt; ASLEEP --woken--&gt; ASKING
 *
 *   close() --&gt; CLOSED, from every phase, permanently
 * </pre>
 *
 * <p>Threading: thread-safe.
 */
final class ConnectionState {
    /** A stage of the connection. */
    enum Phase {
        NEW,
        ASKING,
        UP,
        /** The link is open, and the robot ignores commands until it is woken. */
        ASLEEP,
        /** At the alternate rate, the robot is sent the command to return to the usual one; frames are ignored. */
        CHANGING_RATE,
        DOWN,
        CLOSED
    }

    private volatile Phase phase = Phase.NEW;
    private volatile String trouble = "";

    Phase phase() {
        return phase;
    }

    /** The problem; empty if there is none. */
    String trouble() {
        return trouble;
    }

    /** Enters a phase, with its problem; returns false if the connection is closed, which is permanent. */
    synchronized boolean enter(Phase next, String withTrouble) {
        boolean open = phase != Phase.CLOSED;
        if (open) {
            phase = next;
            trouble = withTrouble;
        }
        return open;
    }

    /** Enters a phase from {@code from} only; returns false if the connection is in another phase. */
    synchronized boolean enterFrom(Phase from, Phase next, String withTrouble) {
        return phase == from && enter(next, withTrouble);
    }
}
