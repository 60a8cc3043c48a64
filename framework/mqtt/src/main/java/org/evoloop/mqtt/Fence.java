package org.evoloop.mqtt;

/**
 * Divides what a client receives into what came before the others knew of it, and what came after: it says on a topic,
 * retained, that it is here, and waits to be told that itself. The broker tells each client everything in the order in
 * which it came, so all divide at the same message. When the client is gone, its will says so, and divides again.
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
     * Of a connection that is not open yet, and has no other will.
     *
     * @param then what is done each time that it is passed
     */
    Fence(BrokerConnection connection, String topic, Runnable then) {
        this.connection = connection;
        this.then = then;
        connection.will(Message.state(topic, GONE));
        connection.subscribe(topic, this::hear);
        connection.onLost(() -> passed = false);
        connection.publish(Message.state(topic, HERE));
    }

    /** What the one at another fence says: whether it is here. */
    static boolean isHere(Message message) {
        return message.payload().equals(HERE);
    }

    private void hear(Message message) {
        if (message.kind() == Message.Kind.STATE) {
            // The broker had kept it from before.
            return;
        }
        passed = isHere(message);
        if (passed) {
            then.run();
        } else {
            // The will of a connection before this one was late.
            connection.republish();
        }
    }

    /** Whether everybody knows that this client is here. */
    boolean isPassed() {
        return passed;
    }
}
