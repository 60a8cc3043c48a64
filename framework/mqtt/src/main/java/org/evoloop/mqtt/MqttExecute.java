package org.evoloop.mqtt;

import java.io.IOException;
import java.time.Duration;
import java.util.LinkedHashSet;
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
    private final Reports confirmations;
    private final Reports answers;
    private final Set<Aftermath> aftermaths = new LinkedHashSet<>();

    /** The state to which the last step leads, if it was not confirmed; else empty. */
    private volatile String awaited = "";

    /** Until when it may still have its effect. */
    private volatile long untilNanos;

    private @Nullable Duration confirmed;
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
        this.confirmations = new Reports(device);
        this.answers = new Reports(device);
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
        aftermaths.add(device.connection().aftermath(topic));
        confirmations.subscribe(topic, states);
        confirmed = Clock.requireDelay(limit);
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
        aftermaths.add(device.connection().aftermath(topic));
        answers.subscribe(topic, states);
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
        requireUp(step.event().toString());
        Duration limit = confirmed;
        try {
            if (limit == null) {
                device.connection().publish(message);
                return;
            }
            sendConfirmed(step, message, limit);
        } finally {
            rest.begin();
        }
    }

    private void sendConfirmed(Step step, Message message, Duration limit) throws IOException, InterruptedException {
        awaited = step.target().name();
        aftermaths.forEach(each -> each.sends(step.source().name(), awaited));
        try {
            confirmations.await(message, awaited, limit, this::isConfirmed);
        } finally {
            if (!awaited.isEmpty()) {
                leaveUnknown(limit);
            }
        }
    }

    private void leaveUnknown(Duration limit) {
        untilNanos = device.clock().nanoTime() + limit.toNanos();
        aftermaths.forEach(each -> each.isUnknown(awaited, device.clock(), limit));
    }

    private void isConfirmed() {
        settle();
        tookEffect();
    }

    private void settle() {
        awaited = "";
        aftermaths.forEach(Aftermath::settled);
    }

    private void requireUp(String what) {
        if (!device.isUp()) {
            throw new IllegalStateException(device.describe() + "; so " + what + " was not sent");
        }
    }

    @Override
    protected Optional<String> locate() throws UnknownEffectException, InterruptedException {
        Question asked = question;
        if (asked == null) {
            return Optional.empty();
        }
        if (!device.isUp()) {
            // What the broker has retained meanwhile may be old, and is no answer.
            leaveUnknown(asked.limit());
            device.connection()
                    .publish(Message.event(
                            asked.message().topic(), asked.message().payload()));
        }
        requireUp("the question for its state");
        long left =
                awaited.isEmpty() ? 0 : Math.max(0, untilNanos - device.clock().nanoTime());
        return Optional.of(answers.ask(asked.message(), awaited, Duration.ofNanos(left), asked.limit(), this::settle));
    }
}
