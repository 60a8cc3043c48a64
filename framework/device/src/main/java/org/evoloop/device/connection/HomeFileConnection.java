package org.evoloop.device.connection;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.evoloop.config.Secret;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.Connection;
import org.evoloop.device.FileModels;
import org.evoloop.device.Outward;
import org.evoloop.device.Parts;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.NodeJson;
import org.evoloop.device.file.Section;
import org.evoloop.homeassistant.EntityValue;
import org.evoloop.homeassistant.HomeAddress;
import org.evoloop.homeassistant.HomeConnection;
import org.evoloop.homeassistant.HomeDevice;
import org.evoloop.homeassistant.HomeEvents;
import org.evoloop.homeassistant.HomeExecute;
import org.evoloop.homeassistant.HomeMonitor;
import org.evoloop.homeassistant.ServiceCall;
import org.evoloop.payload.Match;
import org.evoloop.payload.Meanings;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Entities of Home Assistant as a device or a controller, made of a {@link HomeMonitor} and a {@link HomeExecute}. */
final class HomeFileConnection extends Connection {
    private static final Logger LOG = LoggerFactory.getLogger(HomeFileConnection.class);
    private static final String TOKEN = "EVOLOOP_HOME_ASSISTANT_TOKEN";
    private static final Duration CONFIRMED = Duration.ofSeconds(5);

    private final FileModels models;
    private final @Nullable HomeAddress address;
    private final @Nullable Path tokenFile;
    private final @Nullable String entity;
    private final List<Consumer<HomeDevice>> settings = new ArrayList<>();
    private final List<Consumer<HomeMonitor>> rules = new ArrayList<>();
    private final Map<String, ServiceCall> calls = new LinkedHashMap<>();
    private final Map<EntityValue, Meanings> states = new LinkedHashMap<>();
    private final Set<String> operated = new LinkedHashSet<>();
    private final Set<String> pressing = new LinkedHashSet<>();
    private final Set<ServiceCall> outward = new LinkedHashSet<>();
    private final List<Consumer<HomeConnection>> expected = new ArrayList<>();
    private Duration confirmed = CONFIRMED;
    private @Nullable Duration asked;
    private @Nullable Duration ready;
    private boolean infers;
    private String id;
    private volatile @Nullable HomeConnection opened;

    private HomeFileConnection(
            String name,
            @Nullable HomeAddress address,
            @Nullable Path tokenFile,
            @Nullable String entity,
            FileModels models) {
        super(name, "home-assistant");
        this.address = address;
        this.tokenFile = tokenFile;
        this.entity = entity;
        this.models = models;
        this.id = models.converter();
    }

    static HomeFileConnection read(String name, Section section, FileModels models) {
        Path file = section.problems().file();
        HomeAddress address = section.value(
                        "home-assistant", text -> HomeAddress.parse(text, named -> file.resolveSibling(named)))
                .orElse(null);
        Path token = section.value("token-file", text -> {
                    Path named = file.resolveSibling(text);
                    // Only to find a mistake now: it is read again before each connect.
                    Secret.read(named);
                    return named;
                })
                .orElse(null);
        if (section.has("token")) {
            section.problem(
                    "a token in this file would be seen by everybody who sees the file; write it into another one, "
                            + "and name that here, as token-file: token");
        }
        return new HomeFileConnection(name, address, token, entity(section), models);
    }

    /** An entity; null if there is none. One that is refused is returned as another, so that nothing else is missing. */
    private static @Nullable String entity(Section section) {
        return section.has("entity")
                ? section.value("entity", EntityValue::requireId).orElse("refused.entity")
                : null;
    }

    private @Nullable String entityOf(Section section) {
        String own = entity(section);
        return own == null ? entity : own;
    }

    /** The value of a rule; null if it names none, which is noted. */
    private @Nullable EntityValue valueOf(Section rule) {
        String of = entityOf(rule);
        String attribute = rule.text("attribute").map(Node.Text::value).orElse(null);
        if (of == null) {
            rule.problem(rule.name() + " needs entity; or give the connection " + name() + " one");
            return null;
        }
        EntityValue value = new EntityValue(of, attribute);
        Set<Node.Text> texts =
                rule.has("json") ? Set.of() : rule.pairs("values").keySet();
        if (attribute == null) {
            texts.forEach(text -> requireState(rule, of, text));
        }
        expected.add(
                home -> home.expect(value, texts.stream().map(Node.Text::value).toArray(String[]::new)));
        place(rule, value.toString(), of);
        return value;
    }

    /** What is wrong in Home Assistant is said with the line that is about it. */
    private void place(Section rule, String... keys) {
        String place = rule.problems().file().getFileName() + ":" + rule.node().line();
        for (String key : keys) {
            expected.add(home -> home.placed(key, place));
        }
    }

    private static void requireState(Section rule, String of, Node.Text text) {
        if (text.value().equals("unavailable") || text.value().equals("unknown")) {
            rule.problems()
                    .at(
                            text,
                            "an entity that is " + text
                                    + " cannot be reached, which is no state; leave it out, and status shows it");
            return;
        }
        Set<String> known = EntityValue.statesOf(of);
        if (!known.isEmpty()) {
            rule.problems().requireOneOf(text, known, of + " is never '" + text + "'");
        }
    }

    @Override
    public String shortSend() {
        return "service";
    }

    @Override
    public void send(Node.Text event, Section how) {
        call(how).ifPresent(call -> calls.put(event.value(), call));
    }

    private Optional<ServiceCall> call(Section how) {
        String of = entityOf(how);
        String data =
                how.section("data").map(section -> NodeJson.of(section.node())).orElse("{}");
        how.require("service");
        Optional<ServiceCall> call = how.value("service", service -> new ServiceCall(service, of, data));
        call.ifPresent(each -> place(how, each.toString()));
        if (of != null) {
            place(how, of);
            operated.add(of);
            requireNoLoop(how, of);
        }
        return call;
    }

    /** What is operated would press itself. */
    private void requireNoLoop(Section rule, @Nullable String of) {
        if (of != null && operated.contains(of) && pressing.contains(of)) {
            rule.problem(
                    of + " is operated by this converter, so it cannot be its controller, too: it would press itself; "
                            + "what it does by itself belongs into device.does");
        }
    }

    @Override
    public void state(Section rule) {
        EntityValue value = valueOf(rule);
        Meanings meanings = MeaningReader.read(rule, "state", models::deviceState);
        infers |= rule.flag("infer-events").orElse(false);
        if (value != null) {
            states.put(value, meanings);
            rules.add(monitor -> monitor.found(value, meanings));
        }
    }

    @Override
    public void does(Section rule) {
        events(rule, models::devicesOwn, HomeMonitor::device, HomeMonitor::device);
    }

    @Override
    public void press(Section rule) {
        events(rule, models::pressed, HomeMonitor::controller, HomeMonitor::controller);
        String of = rule.has("event-type") || rule.has("trigger") ? null : entityOf(rule);
        if (of != null) {
            pressing.add(of);
            requireNoLoop(rule, of);
        }
    }

    /** Adds a rule to a monitor. */
    private interface Adding<T> {
        HomeMonitor to(HomeMonitor monitor, T from, Meanings events);
    }

    private void events(
            Section rule, Function<Node.Text, String> known, Adding<EntityValue> ofValue, Adding<HomeEvents> ofEvents) {
        HomeEvents events = rule.section("trigger")
                .map(trigger -> HomeEvents.trigger(NodeJson.of(trigger.node())))
                .or(() -> rule.text("event-type").map(type -> HomeEvents.ofType(type.value())))
                .orElse(null);
        EntityValue value = rule.has("trigger") || rule.has("event-type") ? null : valueOf(rule);
        Meanings meanings = meanings(rule, known);
        if (events != null) {
            place(rule, events.toString());
            rules.add(monitor -> ofEvents.to(monitor, events, meanings));
        } else if (value != null) {
            rules.add(monitor -> ofValue.to(monitor, value, meanings));
        }
    }

    /** Without a form, {@code event} is meant each time: a button has only been pressed. */
    private static Meanings meanings(Section rule, Function<Node.Text, String> known) {
        return rule.meansAnyMessage()
                ? rule.text("event")
                        .map(event -> Meanings.NONE.with(Match.any(), known.apply(event)))
                        .orElse(Meanings.NONE)
                : MeaningReader.read(rule, "event", known);
    }

    @Override
    public void reading(Node.Text reading, Section rule) {
        EntityValue value = valueOf(rule);
        String unit = rule.text("unit").map(Node.Text::value).orElse("");
        if (value != null) {
            settings.add(device -> device.reading(reading.value(), value, unit));
        }
    }

    @Override
    public void device(Section device) {
        if (calls.isEmpty()) {
            return;
        }
        device.section("confirmed").ifPresent(section -> {
            confirmed = section.duration("within").orElse(CONFIRMED);
            requireStates(section);
            section.done();
        });
        device.section("ask").ifPresent(section -> {
            asked = section.duration("within").orElse(null);
            requireStates(section);
            section.done();
        });
        ready = device.duration("ready-after").orElse(null);
    }

    private void requireStates(Section section) {
        if (states.isEmpty()) {
            section.problem(section.name() + " is about what device.state reports, and there is none over " + name());
        }
    }

    @Override
    public @Nullable Outward outward(Section action) {
        ServiceCall call = call(action).orElse(null);
        if (call == null) {
            return null;
        }
        outward.add(call);
        return values -> requireNonNull(opened).carryOut(call, values);
    }

    @Override
    public void shownAs(String other) {
        id = other;
    }

    @Override
    protected boolean asksByItself() {
        return true;
    }

    @Override
    protected Parts make(SystemEventConverter converter) throws IOException {
        if (address == null) {
            throw new IllegalStateException("the address of " + name() + " was refused");
        }
        HomeConnection connection = new HomeConnection(address, token()).shownAs(id);
        opened = connection;
        outward.forEach(connection::require);
        expected.forEach(each -> each.accept(connection));
        HomeDevice device = new HomeDevice(connection, converter.clock());
        settings.forEach(each -> each.accept(device));
        HomeMonitor monitor = new HomeMonitor(name(), device);
        rules.forEach(each -> each.accept(monitor));
        if (infers) {
            monitor.inferring(converter);
        }
        List<HomeExecute> executes = new ArrayList<>();
        if (!calls.isEmpty()) {
            executes.add(execute(device));
        }
        return new Parts(List.of(monitor), executes, device, connection::open, connection::close);
    }

    private HomeExecute execute(HomeDevice device) {
        HomeExecute execute = new HomeExecute(name() + "Execute", device, calls);
        states.forEach((value, meanings) -> execute.confirmedBy(value, meanings, confirmed));
        if (asked != null) {
            execute.askedWithin(asked);
        }
        if (ready != null) {
            execute.readyAfter(ready);
        }
        return execute;
    }

    private Supplier<String> token() throws IOException {
        Path file = tokenFile;
        if (file != null) {
            if (Secret.isShared(file)) {
                LOG.warn(
                        "all users of this computer may read {}, and whoever has this token operates the house; only its "
                                + "owner may with: chmod 600 {}",
                        file,
                        file);
            }
            return () -> Secret.read(file);
        }
        String secret = System.getenv(TOKEN);
        if (secret == null || secret.isBlank()) {
            throw new IOException("there is no token for " + address
                    + "; create a long-lived access token on Home Assistant's page of your user, under Security, and "
                    + "write it into a file that token-file names at the connection " + name()
                    + ", or into the environment as " + TOKEN);
        }
        return secret::strip;
    }
}
