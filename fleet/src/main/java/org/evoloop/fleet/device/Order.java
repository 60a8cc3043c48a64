package org.evoloop.fleet.device;

import org.evoloop.evolution.Values;

/**
 * What somebody at the device has to do, once.
 *
 * <p>Threading: immutable.
 *
 * @param sequence counts the orders to one device, from 1; whoever carries them out does nothing twice
 * @param occurrence the number of the occurrence for which it is
 * @param what the event to send, or the effect to run; empty if the device is to say where it is
 * @param values what the occurrence carries
 * @param deadlineNanos nobody carries it out later than this, in nanoseconds since 1970
 * @param visit the evolved system's stay in its state
 * @param function whether what runs in that visit goes on meanwhile
 * @param from the state in which the device is, by what is known
 * @param to where an event takes it; else the same
 * @since 0.1
 */
public record Order(
        long sequence,
        long occurrence,
        Kind kind,
        String what,
        Values values,
        long deadlineNanos,
        long visit,
        boolean function,
        String from,
        String to) {

    /** What is asked for. */
    public enum Kind {
        /** The device is to get an event. */
        SEND,
        /** An effect of the new model is to be run. */
        RUN,
        /** The device is to be asked in which state it is. */
        LOCATE
    }

    /** Of an order, what has to be known to understand its answer. */
    public record Open(long sequence, long occurrence, Kind kind, long deadlineNanos) {
        static Open of(Order order) {
            return new Open(order.sequence, order.occurrence, order.kind, order.deadlineNanos);
        }
    }
}
