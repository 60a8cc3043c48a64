package org.evoloop.testkit;

/**
 * A fault of a command on its way to a {@link SimulatedDevice}.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Incident {

    /**
     * It does not arrive, and has no effect. The sender notices that only if the device reports its effects; then no
     * answer arrives, and it is unknown whether it had its effect.
     */
    record Lost() implements Incident {}

    /** It has no effect, and sending fails. */
    record Refused() implements Incident {}

    /** It has its effect, but that is unknown to the sender: the answer was lost. */
    record Unanswered() implements Incident {}

    /** The device does {@code event} by itself just before it takes the command. */
    record Before(String event) implements Incident {}

    /** The device does {@code event} by itself after it has taken the command, before the sender knows that it did. */
    record After(String event) implements Incident {}

    /** See {@link Lost}. */
    static Incident lost() {
        return new Lost();
    }

    /** See {@link Refused}. */
    static Incident refused() {
        return new Refused();
    }

    /** See {@link Unanswered}. */
    static Incident unanswered() {
        return new Unanswered();
    }

    /** See {@link Before}. */
    static Incident before(String event) {
        return new Before(event);
    }

    /** See {@link After}. */
    static Incident after(String event) {
        return new After(event);
    }
}
