package org.evoloop.mqtt;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.converter.EventExecute;
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
 * <p>What is sent by another way, such as infrared, can be confirmed by what a meter reports, see {@link #through}.
 *
 * <p>Lifecycle: configure it before the connection is opened.
 *
 * <p>Threading: as {@link EventExecute}.
 *
 * @since 0.1
 */
public class MqttExecute extends EventExecute {
    private final MqttDevice device;
    private final Map<String, Command> commands = new LinkedHashMap<>();
    private final ConfirmedSending sending;
    private @Nullable Question question;
    private Rest rest;

    /**
     * How an event is sent.
     *
     * @param what for messages
     */
    private record Command(String what, HowToSend how) {}

    /** Sends an event. */
    private interface HowToSend {
        void send(Step step) throws Exception;
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
        messages.forEach((event, message) -> {
            Template payload = Template.of(message.payload());
            commands.put(
                    event,
                    new Command(
                            to(message),
                            step -> device.connection()
                                    .publish(new Message(message.topic(), payload.with(values()), message.kind()))));
        });
        this.sending = new ConfirmedSending(device.reporting());
        this.rest = new Rest(device.clock(), Duration.ZERO);
    }

    /**
     * Declares that a topic reports the device's state: a step has been executed when it reports the state to which the
     * step leads. Other reports are left to a monitor. If it does not within the limit, or the device is lost meanwhile,
     * whether the step had its effect is unknown; it still may have it within the limit again, but no later. No report tells
     * whether a step that leaves the state as it is had an effect, so that is executed when it was published.
     *
     * @param states of the original model, by what the topic says
     * @param limit the time limit from publishing to the report
     */
    public final MqttExecute confirmedBy(String topic, Meanings states, Duration limit) {
        sending.confirmedBy(topic, states, limit);
        return this;
    }

    /**
     * Sends further events by another component, which must not be added to the converter: this one finds out what becomes
     * of them, as of its own.
     */
    public final MqttExecute through(EventExecute sender) {
        sender.sendsFor().forEach(event -> commands.put(event, new Command(event, step -> sender.sendFor(this, step))));
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
        return Set.copyOf(commands.keySet());
    }

    @Override
    protected void awaitReady(Step step) throws InterruptedException {
        rest.await();
    }

    @Override
    protected void send(Step step) throws Exception {
        Command command = commands.get(step.event().name());
        if (command == null) {
            throw new IllegalArgumentException(name() + " has no message for " + step.event());
        }
        sending.requireUp(step.event().toString());
        try {
            if (sending.isConfirmed(step)) {
                sending.send(step, command.what(), pending -> command.how().send(step), this::tookEffect);
            } else {
                command.how().send(step);
            }
        } finally {
            rest.begin();
        }
    }

    private static String to(Message message) {
        return "the message to " + message.topic();
    }

    @Override
    protected Optional<String> locate() throws Exception {
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
        Message question = asked.message();
        return Optional.of(
                sending.ask(to(question), pending -> device.connection().publish(question), asked.limit()));
    }
}
