package org.evoloop.device;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import org.evoloop.config.OptionLine;
import org.evoloop.config.Options;
import org.evoloop.converter.Effect;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.evolution.DeviceEvents;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads the sections of a device file that use its connections.
 *
 * <p>Threading: for one thread.
 */
final class SectionReader {
    private static final Logger LOG = LoggerFactory.getLogger(SectionReader.class);

    /** The keys by which a rule says where a message comes from. */
    private static final List<String> SOURCES = List.of("from", "topic", "json", "entity", "attribute", "event-type");

    final Section file;
    private final FileModels models;
    private final Connections connections;
    private final Map<String, FileKnowledge.Function> functions = new LinkedHashMap<>();
    private final Map<String, Effect.OfEvent> effects = new LinkedHashMap<>();
    private final Map<String, Integer> costs = new LinkedHashMap<>();
    private final Set<String> doNotPass = new LinkedHashSet<>();

    final Guards guards;
    final FileKnowledge.Content content;
    final List<Scenario> scenarios = new ArrayList<>();
    final List<OptionLine> options = new ArrayList<>();
    LearnSection learning = LearnSection.NONE;
    HomeSection home = HomeSection.NONE;
    DaySection day = DaySection.NONE;

    @Nullable
    Connection confirming;

    SectionReader(Section file, FileModels models, Connections connections) {
        this.file = file;
        this.models = models;
        this.connections = connections;
        this.guards = Guards.read(file, models);
        this.content = new FileKnowledge.Content(functions, guards.all(), effects, costs, doNotPass);
    }

    void read(Options programOptions) {
        file.section("device").ifPresent(this::device);
        file.section("controller").ifPresent(controller -> {
            rules(controller, "press", Connection::press);
            controller.done();
        });
        day = DaySection.read(file, models);
        functionsAndEffects();
        file.section("learn").ifPresent(learn -> learning = LearnSection.read(learn, models));
        file.section("home-assistant").ifPresent(section -> home = HomeSection.read(section, models));
        file.section("scenarios").ifPresent(all -> scenarios.addAll(Scenario.read(all, models, home)));
        programOptions.names().forEach(this::option);
        programOptions.check(options, file.problems()::at);
        file.done();
    }

    /** Those of a file that is read again act over the connections, and by the day, of the one that runs. */
    void functionsAndEffects(DaySection running) {
        day = running;
        functionsAndEffects();
    }

    private void functionsAndEffects() {
        FunctionReader functionReader = new FunctionReader(models, connections, day);
        file.named("functions").forEach((state, section) -> {
            models.newState(state);
            functionReader.function(state, section).ifPresent(function -> functions.put(state.value(), function));
        });
        file.section("effects").ifPresent(all -> all.keys().forEach(text -> effect(all, text, functionReader)));
    }

    private void option(String option) {
        Node found = file.any(option).orElse(null);
        List<Node.Text> values = file.texts(option);
        if (found != null && !values.isEmpty()) {
            options.add(new OptionLine(
                    option,
                    values.stream().map(Node.Text::value).toList(),
                    found instanceof Node.Items,
                    file.problems().file(),
                    found.line()));
        }
    }

    private void device(Section device) {
        device.section("send").ifPresent(this::sends);
        rules(device, "state", ofDevice(Connection::state));
        rules(device, "does", ofDevice(Connection::does));
        requireOneMeaning(device);
        device.named("readings").forEach((reading, rule) -> {
            models.declareReading(reading);
            Connection from = connections.named(rule, "from");
            if (from != null) {
                from.useForDevice();
                from.reading(reading, rule);
                rule.done();
            }
        });
        device.texts("do-not-pass").forEach(state -> doNotPass.add(models.deviceState(state)));
        confirmed(device);
        connections.all().forEach(connection -> connection.device(device));
        if (connections.areKnown()) {
            device.done();
        }
    }

    /** The first rule for a message is used: as a state and an event, it would only be the state. */
    private static void requireOneMeaning(Section device) {
        Map<List<String>, Node.Text> states = messages(device, "state");
        messages(device, "does").forEach((message, text) -> {
            Node.Text state = states.get(message);
            if (state != null) {
                device.problems()
                        .at(
                                text,
                                "'" + text + "' is also in device.state, in line " + state.line()
                                        + ", and would only be heard as a state; leave it out in one of them");
            }
        });
    }

    /** The messages under {@code key} that are written as they are, by where they come from. */
    private static Map<List<String>, Node.Text> messages(Section device, String key) {
        Map<List<String>, Node.Text> messages = new LinkedHashMap<>();
        for (Section rule : DeviceFile.rules(device, key)) {
            if (rule.any("values").orElse(null) instanceof Node.Entries values) {
                for (Node.Text text : values.entries().keySet()) {
                    List<String> message = new ArrayList<>(List.of(text.value()));
                    SOURCES.forEach(each ->
                            message.add(rule.any(each).map(Node::content).orElse("")));
                    messages.put(message, text);
                }
            }
        }
        return messages;
    }

    /** One connection may tell what becomes of what is sent over others, and one be asked where several could. */
    private void confirmed(Section device) {
        naming(device, "ask", "to").ifPresent(ask -> connections.named(ask, "to"));
        naming(device, "confirmed", "from").ifPresent(confirmed -> {
            confirming = connections.named(confirmed, "from");
            if (confirming != null) {
                confirming.confirms(confirmed);
            }
        });
    }

    /** The section if it has this key; otherwise whether anybody knows it is left open. */
    private static Optional<Section> naming(Section device, String section, String key) {
        return device.node().entries().entrySet().stream()
                .filter(each -> each.getKey().value().equals(section))
                .filter(each -> each.getValue() instanceof Node.Entries pairs
                        && pairs.entries().keySet().stream()
                                .anyMatch(has -> has.value().equals(key)))
                .findFirst()
                .flatMap(found -> device.section(section));
    }

    private void sends(Section send) {
        for (Node.Text event : send.keys()) {
            models.sent(event);
            Node how = send.any(event.value()).orElseThrow();
            Section asked = how instanceof Node.Entries
                    ? send.section(event.value()).orElseThrow()
                    : shortForm(send, event, how);
            Connection to = asked == null ? null : connections.named(asked, "to");
            if (asked != null && to != null) {
                to.useForDevice();
                asked.number("cost", 1, DeviceEvents.MAX_COST).ifPresent(cost -> costs.put(event.value(), cost));
                to.send(event, asked);
                asked.done();
            }
        }
    }

    /** {@code power: PWR} as {@code power: {line: PWR}}, for the only connection. */
    private @Nullable Section shortForm(Section send, Node.Text event, Node how) {
        if (!(how instanceof Node.Text text)) {
            send.problems().at(how, "how " + event + " is sent is " + how.kind() + "; write a text or a mapping");
            return null;
        }
        Section empty = new Section("device.send." + event, new Node.Entries(how.line(), Map.of()), send.problems());
        Connection only = connections.named(empty, "to");
        String key = only == null ? null : only.shortSend();
        if (only != null && key == null) {
            send.problems()
                    .at(how, "how " + event + " is sent takes a mapping, such as {to: " + only.name() + ", ...}");
        }
        return key == null
                ? null
                : new Section(
                        "device.send." + event,
                        new Node.Entries(how.line(), Map.of(new Node.Text(how.line(), key, true), text)),
                        send.problems());
    }

    private void rules(Section parent, String key, BiConsumer<Connection, Section> rule) {
        DeviceFile.rules(parent, key).forEach(each -> rule(each, rule));
    }

    private static BiConsumer<Connection, Section> ofDevice(BiConsumer<Connection, Section> rule) {
        return (connection, section) -> {
            connection.useForDevice();
            rule.accept(connection, section);
        };
    }

    private void rule(Section section, BiConsumer<Connection, Section> rule) {
        Connection from = connections.named(section, "from");
        if (from != null) {
            rule.accept(from, section);
            section.done();
        }
    }

    private void effect(Section all, Node.Text text, FunctionReader functionReader) {
        all.section(text.value()).ifPresent(section -> {
            models.effect(text);
            Action.Do action = functionReader.outward(section);
            section.done();
            if (action != null) {
                effects.put(text.value(), values -> action.perform(values, what -> LOG.info("{}", what)));
            }
        });
    }
}
