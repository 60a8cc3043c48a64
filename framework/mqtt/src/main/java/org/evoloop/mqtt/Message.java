package org.evoloop.mqtt;

/**
 * What is published, or was received.
 *
 * <p>Threading: immutable.
 *
 * @param topic where
 * @param payload text in UTF-8
 * @param kind what becomes of it while there is no connection
 * @since 0.1
 */
public record Message(String topic, String payload, Kind kind) {

    /** What becomes of a message while there is no connection. */
    public enum Kind {
        /**
         * The broker keeps the newest of its topic, and so does the connection: it is published again after each
         * connect.
         */
        STATE,
        /** It is published when there is a connection again, unless too many wait. */
        EVENT,
        /** It is for the moment: it is published now or never. */
        COMMAND
    }

    /** How something is: retained by the broker. */
    public static Message state(String topic, String payload) {
        return new Message(topic, payload, Kind.STATE);
    }

    /** That something has happened. */
    public static Message event(String topic, String payload) {
        return new Message(topic, payload, Kind.EVENT);
    }

    /** That something is to be done. */
    public static Message command(String topic, String payload) {
        return new Message(topic, payload, Kind.COMMAND);
    }
}
