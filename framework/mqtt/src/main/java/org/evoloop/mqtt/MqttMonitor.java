package org.evoloop.mqtt;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.evoloop.converter.PushMonitor;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A monitor of a controller or a device that reports events by MQTT:
 *
 * <pre>{@code
 * new MqttMonitor("WallSwitch", broker).controller("zigbee2mqtt/switch/action", Map.of("single", "switch"));
 * }</pre>
 *
 * <p>With {@link #bypassed} the controller's events may reach the device while this converter is gone.
 *
 * <p>Retained messages are old and therefore ignored. So are payloads that are not listed.
 *
 * <p>Lifecycle: configure it before the connection is opened.
 *
 * <p>Threading: as {@link PushMonitor}.
 *
 * @since 0.1
 */
public class MqttMonitor extends PushMonitor {
    private static final Logger LOG = LoggerFactory.getLogger(MqttMonitor.class);

    private final BrokerConnection connection;
    private final Set<String> devicesOwn = new LinkedHashSet<>();
    private @Nullable Fence fence;

    /** How many of the events that a bypass has passed on have been reported to the converter. */
    private int received;

    /** @param name its name in the console, unique within a converter */
    public MqttMonitor(String name, BrokerConnection connection) {
        super(name);
        this.connection = connection;
    }

    /**
     * Sets the topic on which a controller reports operated controls.
     *
     * @param events the events by payload
     */
    public final MqttMonitor controller(String topic, Map<String, String> events) {
        return on(topic, events, event -> {
            if (fence == null || fence.isPassed()) {
                push(fromController(event));
            }
        });
    }

    /**
     * Sets the topic on which the device reports what it has done by itself.
     *
     * @param events the events by payload
     */
    public final MqttMonitor device(String topic, Map<String, String> events) {
        devicesOwn.addAll(events.values());
        return on(topic, events, event -> push(fromDevice(event)));
    }

    /**
     * Declares that an {@link MqttBypass} passes the controller's events on while this converter is gone. The
     * controller's events count once the bypass knows that the converter is here; the events passed on before come
     * first, as events on which the device has already acted.
     *
     * @param topic the prefix of the topics by which both exchange their status, such as {@code evoloop/lamp/bypass}
     */
    public final MqttMonitor bypassed(String topic) {
        BypassTopics topics = new BypassTopics(topic);
        connection.subscribe(topics.passed(), message -> {
            hearPassed(message);
            connection.publish(Message.event(topics.received(), Integer.toString(received)));
        });
        fence = new Fence(connection, topics.converter(), () -> {});
        return this;
    }

    private void hearPassed(Message message) {
        List<String> passed = BypassTopics.events(message);
        for (String event : passed.subList(Math.min(received, passed.size()), passed.size())) {
            push(fromPanel(event, true));
        }
        received = passed.size();
    }

    private MqttMonitor on(String topic, Map<String, String> events, Consumer<String> heard) {
        Map<String, String> known = Map.copyOf(events);
        connection.subscribe(topic, message -> {
            String event = known.get(message.payload());
            if (event == null || message.kind() == Message.Kind.STATE) {
                LOG.debug("{} ignores '{}' on {}", name(), message.payload(), topic);
            } else {
                heard.accept(event);
            }
        });
        return this;
    }

    @Override
    protected Set<String> spontaneousEvents() {
        return Set.copyOf(devicesOwn);
    }
}
