package org.evoloop.mqtt;

import org.evoloop.payload.report.Report;

/**
 * A message to publish, or a received one.
 *
 * <p>Threading: immutable.
 *
 * @param topic its topic
 * @param payload its text, in UTF-8
 * @param kind how it is handled while there is no connection
 * @since 0.1
 */
public record Message(String topic, String payload, Kind kind) {

    /** How a message is handled while there is no connection. */
    public enum Kind {
        /**
         * The broker retains the newest of its topic, and so does the connection, which publishes it again after each
         * connect.
         */
        STATE,
        /** It is published when there is a connection again, unless too many wait. */
        EVENT,
        /** It is published now or never. */
        COMMAND
    }

    /** What it reports; what the broker has retained is old. */
    Report report() {
        return new Report(payload, kind == Kind.STATE);
    }

    /** The state of something: retained by the broker. */
    public static Message state(String topic, String payload) {
        return new Message(topic, payload, Kind.STATE);
    }

    /** A notice that something has happened. */
    public static Message event(String topic, String payload) {
        return new Message(topic, payload, Kind.EVENT);
    }

    /** A command to do something. */
    public static Message command(String topic, String payload) {
        return new Message(topic, payload, Kind.COMMAND);
    }
}
