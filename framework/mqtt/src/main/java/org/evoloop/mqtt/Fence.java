package org.evoloop.mqtt;

/**
 * Divides the messages that a client receives into those before and those after the other clients knew of its
 * connection. The client publishes a retained message that it is connected, and waits until it receives that message
 * itself. The broker delivers everything in the same order to each client, so all divide at the same message. When the
 * client is gone, its will reports that, which divides the messages again.
 *
 * <p>Threading: thread-safe.
 */
final class Fence {
    private static final String HERE = "here";
    private static final String GONE = "gone";

    private final BrokerConnection connection;
    private final Runnable then;
    private volatile boolean passed;

    /**
     * A fence for a connection that is not open yet, and has no other will.
     *
     * @param then run each time that the fence is passed
     */
    Fence(BrokerConnection connection, String topic, Runnable then) {
        this.connection = connection;
        this.then = then;
        connection.will(Message.state(topic, GONE));
        connection.subscribe(topic, this::hear);
        connection.onLost(() -> passed = false);
        connection.publish(Message.state(topic, HERE));
    }

    /** Reads the message of another client's fence: whether that client is connected. */
    static boolean isHere(Message message) {
        return message.payload().equals(HERE);
    }

    private void hear(Message message) {
        if (message.kind() == Message.Kind.STATE) {
            // A retained message of an earlier connection.
            return;
        }
        passed = isHere(message);
        if (passed) {
            then.run();
        } else {
            // The will of an earlier connection arrived late.
            connection.republish();
        }
    }

    /** Whether all clients know that this one is connected. */
    boolean isPassed() {
        return passed;
    }
}
