package org.evoloop.mqtt;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Values;
import org.evoloop.payload.Inference;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.report.Aftermath;
import org.evoloop.payload.report.ReportRules;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * A monitor of a controller or a device that reports events by MQTT:
 *
 * <pre>{@code
 * new MqttMonitor("WallSwitch", broker).controller("zigbee2mqtt/switch/action", Map.of("single", "switch"));
 * }</pre>
 *
 * <p>With {@link #bypassed} the controller's events may reach the device while this converter is gone.
 *
 * <p>The first rule of a topic that applies to a payload is used; a payload without one is ignored. A retained message
 * is old: it is no event, but it is the device's state. What must {@linkplain Meanings#lasting(Duration) hold for a
 * time} is reported when it has; an event once, and not if it held from the beginning.
 *
 * <p>Lifecycle: configure it before the connection is opened.
 *
 * <p>Threading: as {@link PushMonitor}.
 *
 * @since 0.1
 */
public class MqttMonitor extends PushMonitor {
    private final BrokerConnection connection;
    private final ReportRules rules;
    private @Nullable Fence fence;
    private @Nullable Inference inference;
    private @Nullable String outcomes;

    /** How many of the events that a bypass has passed on have been reported to the converter. */
    private int received;

    /** @param name its name in the console, unique within a converter */
    public MqttMonitor(String name, BrokerConnection connection) {
        this(name, connection, null);
    }

    /** As {@link #MqttMonitor(String, BrokerConnection)}, with the clock of this device for what must hold for a time. */
    public MqttMonitor(String name, MqttDevice device) {
        this(name, device.connection(), device.clock());
    }

    private MqttMonitor(String name, BrokerConnection connection, @Nullable Clock clock) {
        super(name);
        this.connection = connection;
        this.rules = new ReportRules(
                clock,
                connection.turns(),
                (topic, heard) -> connection.subscribe(topic, message -> heard.accept(message.report())));
    }

    /**
     * Sets the topic on which a controller reports operated controls.
     *
     * @param events the events by payload
     */
    public final MqttMonitor controller(String topic, Map<String, String> events) {
        return controller(topic, Meanings.of(events));
    }

    /** As {@link #controller(String, Map)}, with JSON, patterns and values. */
    public final MqttMonitor controller(String topic, Meanings events) {
        controllerRaises(events.names());
        rules.add(topic, events, ReportRules.Use.EVENT, event -> {
            if (fence == null || fence.isPassed()) {
                hear(event.name(), event.values());
            }
        });
        return this;
    }

    /**
     * Publishes what becomes of each of the controller's events, when that is known: JSON with the keys {@code event},
     * {@code outcome}, which is the {@linkplain EventOutcome#kind() kind}, and {@code text}.
     */
    public final MqttMonitor outcomes(String topic) {
        outcomes = topic;
        return this;
    }

    private void hear(String event, Values values) {
        String topic = outcomes;
        if (topic == null) {
            push(fromController(event, values));
        } else {
            CompletableFuture<EventOutcome> unused = Told.submit(this, event, values, connection, topic);
        }
    }

    /**
     * Sets the topic on which the device reports what it has done by itself.
     *
     * @param events the events by payload
     */
    public final MqttMonitor device(String topic, Map<String, String> events) {
        return device(topic, Meanings.of(events));
    }

    /** As {@link #device(String, Map)}, with JSON, patterns and values. */
    public final MqttMonitor device(String topic, Meanings events) {
        deviceRaises(events.names());
        rules.add(topic, events, ReportRules.Use.EVENT, event -> push(fromDevice(event.name(), event.values())));
        return this;
    }

    /**
     * Sets the topic on which the device reports its state; what the broker has retained counts, too. After a command
     * that was {@linkplain MqttExecute#confirmedBy not confirmed} a report may be older than its effect, so a while only the
     * one that confirms it counts.
     *
     * @param states of the original model, by payload
     */
    public final MqttMonitor found(String topic, Map<String, String> states) {
        return found(topic, Meanings.of(states));
    }

    /** As {@link #found(String, Map)}, with JSON and patterns. */
    public final MqttMonitor found(String topic, Meanings states) {
        Aftermath aftermath = connection.aftermath(topic);
        Consumer<String> found = this::locate;
        rules.add(topic, states, ReportRules.Use.STATE, state -> aftermath.hear(state.name(), found));
        return this;
    }

    private void locate(String state) {
        Inference explains = inference;
        Optional<String> event = explains == null ? Optional.empty() : explains.eventTo(state);
        push(event.map(this::fromDevice).orElseGet(() -> foundIn(state)));
    }

    /**
     * Declares that a changed state is the device's own event if exactly one leads there from the state in which the
     * converter believes the device to be, and no event is being handled. Other changes remain findings.
     *
     * @param converter the converter to which this monitor will be added
     * @param more events that the device takes by itself, such as those of its own buttons, beside those that its model
     *     declares to be its own
     */
    public final MqttMonitor inferring(SystemEventConverter converter, String... more) {
        deviceRaises(List.of(more));
        inference = new Inference(converter, this::spontaneousEvents);
        return this;
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
}
