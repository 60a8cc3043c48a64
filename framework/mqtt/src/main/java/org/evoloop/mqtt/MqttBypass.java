package org.evoloop.mqtt;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Passes a controller's events on to the device unchanged while the converter between them is gone: in a process of its
 * own, with the maps of the converter's {@link MqttMonitor} and {@link MqttExecute}.
 *
 * <pre>{@code
 * new MqttBypass(broker, "evoloop/lamp/bypass", Map.of("switch", Message.command("zigbee2mqtt/lamp/set", "TOGGLE")))
 *         .controller("zigbee2mqtt/switch/action", Map.of("single", "switch"))
 *         .open();
 * }</pre>
 *
 * <p>No event is both converted and passed on, as long as the broker delivers everything to each of its clients in the
 * order of arrival, as Mosquitto does. Events on their way to the converter when it ends may be lost.
 *
 * <p>Lifecycle: configure it, then {@link #open}; {@link #close}, after which nothing is passed on.
 *
 * <p>Threading: as {@link BrokerConnection}.
 *
 * @see MqttMonitor#bypassed
 * @since 0.1
 */
public final class MqttBypass implements AutoCloseable {
    /** How many events of one outage are reported to the converter. */
    static final int MOST_TOLD = 1_000;

    private static final Logger LOG = LoggerFactory.getLogger(MqttBypass.class);

    private final BrokerConnection connection;
    private final BypassTopics topics;
    private final Map<String, Message> messages;
    private final Fence fence;
    private final List<String> passed = new ArrayList<>();
    private boolean converterHere;

    /**
     * A bypass of one converter.
     *
     * @param connection a connection of its own, not open yet
     * @param topic as for {@link MqttMonitor#bypassed}
     * @param messages the messages to publish, by event
     */
    public MqttBypass(BrokerConnection connection, String topic, Map<String, Message> messages) {
        this.connection = connection;
        this.topics = new BypassTopics(topic);
        this.messages = Map.copyOf(messages);
        connection.onLost(this::lost);
        connection.subscribe(topics.converter(), this::hearOfConverter);
        connection.subscribe(topics.passed(), this::resume);
        connection.subscribe(topics.received(), this::hearReceived);
        this.fence = new Fence(connection, topics.own(), this::say);
    }

    /**
     * Sets the topic on which a controller reports operated controls.
     *
     * @param events the events by payload
     */
    public MqttBypass controller(String topic, Map<String, String> events) {
        Map<String, String> known = Map.copyOf(events);
        connection.subscribe(topic, message -> {
            String event = known.get(message.payload());
            if (event != null && message.kind() != Message.Kind.STATE) {
                pass(event);
            }
        });
        return this;
    }

    /** Starts connecting; does not wait for the broker. */
    public MqttBypass open() {
        connection.open();
        return this;
    }

    /** Whether events are passed on now. */
    public synchronized boolean isPassing() {
        return fence.isPassed() && !converterHere;
    }

    private synchronized void pass(String event) {
        Message message = messages.get(event);
        if (!isPassing() || message == null) {
            return;
        }
        connection.publish(message);
        if (passed.size() >= MOST_TOLD) {
            LOG.warn("more than {} events are passed on; the converter will not learn of {}", MOST_TOLD, event);
            return;
        }
        passed.add(event);
        connection.publish(Message.state(topics.passed(), String.join("\n", passed)));
    }

    private synchronized void hearOfConverter(Message message) {
        boolean here = Fence.isHere(message);
        if (here != converterHere) {
            converterHere = here;
            say();
        }
    }

    private synchronized void hearReceived(Message message) {
        if (!passed.isEmpty() && message.payload().equals(Integer.toString(passed.size()))) {
            passed.clear();
            connection.publish(Message.state(topics.passed(), ""));
        }
    }

    private synchronized void say() {
        if (fence.isPassed()) {
            LOG.info("{}", converterHere ? "the converter is here" : "the converter is gone; events are passed on");
        }
    }

    /** Continues after a bypass that ended while the converter was gone. */
    private synchronized void resume(Message message) {
        if (message.kind() == Message.Kind.STATE && passed.isEmpty()) {
            passed.addAll(BypassTopics.events(message));
        }
    }

    private synchronized void lost() {
        converterHere = false;
    }

    @Override
    public void close() {
        connection.close();
    }
}
