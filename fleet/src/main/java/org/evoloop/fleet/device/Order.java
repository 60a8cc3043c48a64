package org.evoloop.fleet.device;

import org.evoloop.evolution.Values;

/**
 * A task to be carried out at the device, once.
 *
 * <p>Threading: immutable.
 *
 * @param sequence its number among the device's orders, from 1; an order must not be carried out twice
 * @param occurrence the number of its occurrence
 * @param what the event to send, or the effect to run; empty if the device is to report its state
 * @param values the occurrence's values
 * @param deadlineNanos the time after which it must not be carried out, in nanoseconds since 1970
 * @param visit the number of the evolved system's current visit to a state
 * @param function whether the function that runs in that visit, or has yet to be started, continues meanwhile
 * @param from the state of the device, as far as is known
 * @param to the state to which an event leads; else the same
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

    /** The kind of an order. */
    public enum Kind {
        /** An event is to be sent to the device. */
        SEND,
        /** An effect of the new model is to be run. */
        RUN,
        /** The device is to be asked for its state. */
        LOCATE
    }

    /** The part of an order that is needed to interpret its answer. */
    public record Open(long sequence, long occurrence, Kind kind, long deadlineNanos) {
        static Open of(Order order) {
            return new Open(order.sequence, order.occurrence, order.kind, order.deadlineNanos);
        }
    }
}
