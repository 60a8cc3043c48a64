package org.evoloop.mqtt;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.Step;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Rest;
import org.evoloop.payload.Template;
import org.evoloop.payload.report.ConfirmedSending;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Sends events to a device that takes its commands by MQTT:
 *
 * <pre>{@code
 * Meanings states = Meanings.at("/state", Map.of("ON", "on", "OFF", "off"));
 * new MqttExecute("Lamp", lamp, Map.of("switch", Message.command("zigbee2mqtt/lamp/set", "TOGGLE")))
 *         .confirmedBy("zigbee2mqtt/lamp", states, Duration.ofSeconds(2))
 *         .asking(Message.command("zigbee2mqtt/lamp/get", "{\"state\":\"\"}"), "zigbee2mqtt/lamp", states,
 *                 Duration.ofSeconds(2));
 * }</pre>
 *
 * <p>A payload may contain the event's values, see {@link Template}. Without {@link #confirmedBy} a step has been
 * executed when it was published. While the device or the broker cannot be reached a step fails; nothing is sent later
 * or twice.
 *
 * <p>Lifecycle: configure it before the connection is opened.
 *
 * <p>Threading: as {@link EventExecute}.
 *
 * @since 0.1
 */
public class MqttExecute extends EventExecute {
    private final MqttDevice device;
    private final Map<String, Command> commands;
    private final ConfirmedSending sending;
    private @Nullable Question question;
    private Rest rest;

    private record Command(Message message, Template payload) {
        Command(Message message) {
            this(message, Template.of(message.payload()));
        }
    }

    private record Question(Message message, Duration limit) {}

    /**
     * A component that sends these events.
     *
     * @param name its name in the console, unique within a converter
     * @param messages the messages to publish, by event
     */
    public MqttExecute(String name, MqttDevice device, Map<String, Message> messages) {
        super(name);
        this.device = device;
        this.commands = messages.entrySet().stream()
                .collect(Collectors.toUnmodifiableMap(Map.Entry::getKey, entry -> new Command(entry.getValue())));
        this.sending = new ConfirmedSending(device.reporting());
        this.rest = new Rest(device.clock(), Duration.ZERO);
    }

    /**
     * Declares that a topic reports the device's state: a step has been executed when it reports the state to which the
     * step leads. Other reports are left to a monitor. If it does not within the limit, or the device is lost meanwhile,
     * whether the step had its effect is unknown; it still may have it within the limit again, but no later.
     *
     * @param states of the original model, by what the topic says
     * @param limit the time limit from publishing to the report
     */
    public final MqttExecute confirmedBy(String topic, Meanings states, Duration limit) {
        sending.confirmedBy(topic, states, limit);
        return this;
    }

    /**
     * Sets a question for the device's state, published when the converter is in doubt; if the device cannot be reached
     * then, when the broker can. The first state that is reported afterwards is the answer; what the broker has retained
     * is older, and is none. After a step that was not confirmed, another state than the one to which it leads is the
     * answer when it is too late for its effect.
     *
     * @param topic the topic of the answer
     * @param states of the original model, by what the topic says
     * @param limit the time limit for the answer
     */
    public final MqttExecute asking(Message question, String topic, Meanings states, Duration limit) {
        sending.answeredBy(topic, states);
        this.question = new Question(question, Clock.requireDelay(limit));
        return this;
    }

    /** Sets how long the device needs after each command before it takes the next one. */
    public final MqttExecute readyAfter(Duration pause) {
        rest = new Rest(device.clock(), pause);
        return this;
    }

    @Override
    protected final Set<String> sendableEvents() {
        return commands.keySet();
    }

    @Override
    protected void awaitReady(Step step) throws InterruptedException {
        rest.await();
    }

    @Override
    protected void send(Step step) throws IOException, InterruptedException {
        Command command = commands.get(step.event().name());
        if (command == null) {
            throw new IllegalArgumentException(name() + " has no message for " + step.event());
        }
        Message template = command.message();
        Message message = new Message(template.topic(), command.payload().with(values()), template.kind());
        sending.requireUp(step.event().toString());
        try {
            if (sending.isConfirmed()) {
                sending.send(step, to(message), sent -> device.connection().publish(message), this::tookEffect);
            } else {
                device.connection().publish(message);
            }
        } finally {
            rest.begin();
        }
    }

    private static String to(Message message) {
        return "the message to " + message.topic();
    }

    @Override
    protected Optional<String> locate() throws UnknownEffectException, InterruptedException {
        Question asked = question;
        if (asked == null) {
            return Optional.empty();
        }
        if (!device.isUp()) {
            // What the broker has retained meanwhile may be old, and is no answer.
            sending.isUnknown(asked.limit());
            device.connection()
                    .publish(Message.event(
                            asked.message().topic(), asked.message().payload()));
        }
        sending.requireUp("the question for its state");
        return Optional.of(
                sending.ask(to(asked.message()), sent -> device.connection().publish(asked.message()), asked.limit()));
    }
}
