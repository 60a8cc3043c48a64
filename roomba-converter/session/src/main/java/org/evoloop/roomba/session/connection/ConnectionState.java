package org.evoloop.roomba.session.connection;

/**
 * Where a connection stands, and what is wrong with it.
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
 *   close() --&gt; CLOSED, from wherever it is, for good
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
        /** The link is open, and the robot hears nothing until it is woken. */
        ASLEEP,
        /** The robot is told, at the alternate rate, to come back to the usual one; frames do not count. */
        CHANGING_RATE,
        DOWN,
        CLOSED
    }

    private volatile Phase phase = Phase.NEW;
    private volatile String trouble = "";

    Phase phase() {
        return phase;
    }

    /** What is wrong; empty if nothing is. */
    String trouble() {
        return trouble;
    }

    /** Goes on to a phase, with what is wrong in it; false if the connection has been closed, which is for good. */
    synchronized boolean enter(Phase next, String withTrouble) {
        boolean open = phase != Phase.CLOSED;
        if (open) {
            phase = next;
            trouble = withTrouble;
        }
        return open;
    }

    /** The same from one phase only; false if the connection is in another. */
    synchronized boolean enterFrom(Phase from, Phase next, String withTrouble) {
        return phase == from && enter(next, withTrouble);
    }
}
