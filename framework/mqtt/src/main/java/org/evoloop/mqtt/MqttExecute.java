package org.evoloop.mqtt;

import java.util.Map;
import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;

/**
 * Sends events to a device that takes its commands by MQTT:
 *
 * <pre>{@code
 * new MqttExecute("Lamp", broker, Map.of("switch", Message.command("zigbee2mqtt/lamp/set", "TOGGLE")));
 * }</pre>
 *
 * <p>While the broker cannot be reached a step fails; nothing is sent later.
 *
 * <p>Threading: as {@link EventExecute}; it does not wait for the broker.
 *
 * @since 0.1
 */
public class MqttExecute extends EventExecute {
    private final BrokerConnection connection;
    private final Map<String, Message> messages;

    /**
     * A component that sends these events.
     *
     * @param name its name in the console, unique within a converter
     * @param messages the messages to publish, by event
     */
    public MqttExecute(String name, BrokerConnection connection, Map<String, Message> messages) {
        super(name);
        this.connection = connection;
        this.messages = Map.copyOf(messages);
    }

    @Override
    protected final Set<String> sendableEvents() {
        return messages.keySet();
    }

    @Override
    protected void send(Step step) {
        Message message = messages.get(step.event().name());
        if (message == null) {
            throw new IllegalArgumentException(name() + " has no message for " + step.event());
        }
        if (!connection.isUp()) {
            throw new IllegalStateException(connection.describe() + "; so " + step.event() + " was not sent");
        }
        connection.publish(message);
    }
}
