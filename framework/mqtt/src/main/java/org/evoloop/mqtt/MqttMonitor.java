package org.evoloop.mqtt;

import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.evoloop.converter.PushMonitor;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A monitor of a controller or a device that tells by MQTT what happens:
 *
 * <pre>{@code
 * new MqttMonitor("WallSwitch", broker).controller("zigbee2mqtt/switch/action", Map.of("single", "switch"));
 * }</pre>
 *
 * <p>What the broker had retained is from another time, and ignored. So are other payloads than those named.
 *
 * <p>Lifecycle: say everything before the connection is opened.
 *
 * <p>Threading: as {@link PushMonitor}.
 *
 * @since 0.1
 */
public class MqttMonitor extends PushMonitor {
    private static final Logger LOG = LoggerFactory.getLogger(MqttMonitor.class);

    private final BrokerConnection connection;
    private final Set<String> devicesOwn = new LinkedHashSet<>();

    /** @param name what the console calls it, unique within a converter */
    public MqttMonitor(String name, BrokerConnection connection) {
        super(name);
        this.connection = connection;
    }

    /**
     * On this topic a controller tells of what was operated.
     *
     * @param events by payload
     */
    public final MqttMonitor controller(String topic, Map<String, String> events) {
        return on(topic, events, event -> push(fromController(event)));
    }

    /**
     * On this topic the device tells of what it has done by itself.
     *
     * @param events by payload
     */
    public final MqttMonitor device(String topic, Map<String, String> events) {
        devicesOwn.addAll(events.values());
        return on(topic, events, event -> push(fromDevice(event)));
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
