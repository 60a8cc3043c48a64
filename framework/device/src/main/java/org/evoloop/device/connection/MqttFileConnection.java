package org.evoloop.device.connection;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Function;
import org.evoloop.config.Secret;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.Connection;
import org.evoloop.device.FileModels;
import org.evoloop.device.Outward;
import org.evoloop.device.Parts;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.function.NewFunction;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Message;
import org.evoloop.mqtt.MqttDevice;
import org.evoloop.mqtt.MqttExecute;
import org.evoloop.mqtt.MqttFunctions;
import org.evoloop.mqtt.MqttMonitor;
import org.evoloop.payload.Match;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Part;
import org.evoloop.payload.RemoteFunction;
import org.evoloop.payload.Template;
import org.jspecify.annotations.Nullable;

/** A device or a controller behind an MQTT broker, made of a {@link MqttMonitor} and a {@link MqttExecute}. */
final class MqttFileConnection extends Connection {
    private final FileModels models;
    private final @Nullable BrokerAddress address;
    private final @Nullable String commandTopic;
    private final @Nullable String stateTopic;
    private final List<Consumer<MqttDevice>> settings = new ArrayList<>();
    private final List<Consumer<MqttMonitor>> rules = new ArrayList<>();
    private final List<Consumer<MqttExecute>> duties = new ArrayList<>();
    private final Map<String, Message> messages = new LinkedHashMap<>();
    private final List<StateRule> states = new ArrayList<>();
    private final Map<String, RemoteFunction> functions = new ConcurrentHashMap<>();
    private final Map<String, String> functionTopics = new LinkedHashMap<>();
    private boolean sends;
    private boolean confirmsAll;
    private volatile @Nullable MqttExecute execute;
    private boolean infers;
    private volatile @Nullable BrokerConnection opened;

    private record StateRule(String topic, Meanings states) {}

    private MqttFileConnection(
            String name,
            @Nullable BrokerAddress address,
            @Nullable String commandTopic,
            @Nullable String stateTopic,
            FileModels models) {
        super(name, "mqtt");
        this.address = address;
        this.commandTopic = commandTopic;
        this.stateTopic = stateTopic;
        this.models = models;
    }

    static MqttFileConnection read(String name, Section section, FileModels models) {
        BrokerAddress address = section.value("mqtt", BrokerAddress::parse).orElse(null);
        BrokerAddress given = address;
        if (given != null) {
            // The address may name no user.
            address = section.value(
                            "password-file",
                            file -> given.withPassword(
                                    Secret.read(section.problems().file().resolveSibling(file))))
                    .orElse(given);
        }
        MqttFileConnection connection = new MqttFileConnection(
                name, address, topic(section, "command-topic"), topic(section, "state-topic"), models);
        section.section("availability").ifPresent(availability -> {
            availability.require("topic");
            String topic = topic(availability, "topic");
            Part part = MeaningReader.part(availability).orElse(Part.WHOLE);
            String online = availability.text("online").map(Node.Text::value).orElse("online");
            availability.done();
            if (topic != null) {
                connection.settings.add(device ->
                        device.availability(topic, Match.exactly(online).in(part)));
            }
        });
        return connection;
    }

    /** A topic; null if there is none. One that is refused is returned all the same, so that nothing else is missing. */
    private static @Nullable String topic(Section section, String key) {
        section.value(key, MqttFileConnection::exactTopic);
        return section.text(key).map(Node.Text::value).orElse(null);
    }

    private static String exactTopic(String text) {
        if (text.isEmpty() || text.matches(".*[#+\\u0000].*")) {
            throw new IllegalArgumentException("'" + text + "' is no topic; wildcards (+ and #) are not supported");
        }
        return text;
    }

    @Override
    public String shortSend() {
        return "payload";
    }

    @Override
    public void send(Node.Text event, Section how) {
        sends = true;
        message(how).ifPresent(message -> messages.put(event.value(), message));
    }

    private Optional<Message> message(Section how) {
        String topic = how.has("topic") ? topic(how, "topic") : commandTopic;
        if (topic == null && !how.has("topic")) {
            how.problem(how.name() + " needs topic; or give the connection " + name() + " a command-topic");
        }
        how.require("payload");
        Optional<String> payload =
                how.value("payload", text -> Template.of(text).toString());
        return topic == null ? Optional.empty() : payload.map(text -> Message.command(topic, text));
    }

    /** The topic of a rule, else that of the connection's state. */
    private @Nullable String topicOf(Section rule) {
        if (rule.has("topic")) {
            return topic(rule, "topic");
        }
        if (stateTopic == null) {
            rule.problem(rule.name() + " needs topic; or give the connection " + name() + " a state-topic");
        }
        return stateTopic;
    }

    @Override
    public void state(Section rule) {
        String topic = topicOf(rule);
        Meanings meanings = MeaningReader.read(rule, "state", models::deviceState);
        infers |= rule.flag("infer-events").orElse(false);
        if (topic != null) {
            states.add(new StateRule(topic, meanings));
            rules.add(monitor -> monitor.found(topic, meanings));
        }
    }

    @Override
    public void does(Section rule) {
        events(rule, models::devicesOwn, MqttMonitor::device);
    }

    @Override
    public void press(Section rule) {
        events(rule, models::pressed, MqttMonitor::controller);
    }

    /** Adds a rule to a monitor. */
    private interface Adding {
        MqttMonitor to(MqttMonitor monitor, String topic, Meanings events);
    }

    private void events(Section rule, Function<Node.Text, String> known, Adding adding) {
        String topic = topicOf(rule);
        Meanings meanings = MeaningReader.read(rule, "event", known);
        if (topic != null) {
            rules.add(monitor -> adding.to(monitor, topic, meanings));
        }
    }

    @Override
    public void reading(Node.Text reading, Section rule) {
        String topic = topicOf(rule);
        Part part = MeaningReader.part(rule).orElse(Part.WHOLE);
        String unit = rule.text("unit").map(Node.Text::value).orElse("");
        if (topic != null) {
            settings.add(device -> device.reading(reading.value(), topic, part, unit));
        }
    }

    @Override
    public void confirms(Section confirmed) {
        confirmsAll = true;
    }

    @Override
    public void confirm(EventExecute sender) {
        requireNonNull(execute).through(sender);
    }

    @Override
    public void device(Section device) {
        if (!sends && !confirmsAll) {
            return;
        }
        device.section("confirmed")
                .filter(confirmed -> isFor(confirmed, "from"))
                .ifPresent(confirmed -> {
                    Duration within = confirmed.duration("within").orElse(Duration.ofSeconds(2));
                    requireStates(confirmed);
                    states.forEach(
                            rule -> duties.add(execute -> execute.confirmedBy(rule.topic(), rule.states(), within)));
                    confirmed.done();
                });
        device.section("ask").filter(ask -> isFor(ask, "to")).ifPresent(ask -> {
            Duration within = ask.duration("within").orElse(Duration.ofSeconds(2));
            requireStates(ask);
            message(ask)
                    .ifPresent(question -> states.forEach(rule ->
                            duties.add(execute -> execute.asking(question, rule.topic(), rule.states(), within))));
            ask.done();
        });
        device.duration("ready-after").ifPresent(pause -> duties.add(execute -> execute.readyAfter(pause)));
    }

    private void requireStates(Section section) {
        if (states.isEmpty()) {
            section.problem(section.name() + " is about what device.state reports, and there is none over " + name());
        }
    }

    @Override
    public @Nullable Outward outward(Section action) {
        Message message = message(action).orElse(null);
        return message == null
                ? null
                : values -> {
                    BrokerConnection open = requireNonNull(opened);
                    if (!open.isUp()) {
                        throw new IOException("the broker cannot be reached");
                    }
                    open.publish(new Message(
                            message.topic(), Template.of(message.payload()).with(values), message.kind()));
                };
    }

    /** Its topics begin with {@code topic}, or {@code evoloop/CONVERTER/function/STATE}. */
    @Override
    public NewFunction function(Node.Text state, Section section) {
        String topic = topic(section, "topic");
        if (opened != null && !functions.containsKey(state.value())) {
            section.problem("a broker's connection that is open takes no further function; restart the converter");
        }
        functionTopics.put(
                state.value(), topic == null ? MqttFunctions.topic(models.converter(), state.value()) : topic);
        return visit -> requireNonNull(functions.get(state.value())).run(visit);
    }

    @Override
    protected Parts make(SystemEventConverter converter) {
        if (address == null) {
            throw new IllegalStateException("the address of " + name() + " was refused");
        }
        BrokerConnection connection = new BrokerConnection(
                address, "evoloop-" + name() + "-" + ProcessHandle.current().pid());
        opened = connection;
        MqttDevice device = new MqttDevice(connection, converter.clock());
        settings.forEach(each -> each.accept(device));
        functionTopics.forEach(
                (state, topic) -> functions.put(state, new RemoteFunction(new MqttFunctions(device, topic))));
        MqttMonitor monitor = new MqttMonitor(name(), device);
        rules.forEach(each -> each.accept(monitor));
        if (infers) {
            monitor.inferring(converter);
        }
        List<MqttExecute> executes = new ArrayList<>();
        if (!messages.isEmpty() || confirmsAll) {
            MqttExecute made = new MqttExecute(name() + "Execute", device, messages);
            duties.forEach(each -> each.accept(made));
            executes.add(made);
            execute = made;
        }
        return new Parts(List.of(monitor), executes, device, connection::open, connection::close);
    }
}
