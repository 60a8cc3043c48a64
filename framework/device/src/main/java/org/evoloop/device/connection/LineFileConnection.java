package org.evoloop.device.connection;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.Connection;
import org.evoloop.device.FileModels;
import org.evoloop.device.Outward;
import org.evoloop.device.Parts;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.function.NewFunction;
import org.evoloop.line.LineConnection;
import org.evoloop.line.LineExecute;
import org.evoloop.line.LineMonitor;
import org.evoloop.line.LineTransport;
import org.evoloop.payload.Match;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.RemoteFunction;
import org.jspecify.annotations.Nullable;

/** A connection that exchanges lines of text, made of a {@link LineMonitor} and a {@link LineExecute}. */
final class LineFileConnection extends Connection {
    private final FileModels models;
    private final @Nullable LineTransport transport;
    private final List<Consumer<LineConnection>> settings = new ArrayList<>();
    private final List<Consumer<LineMonitor>> rules = new ArrayList<>();
    private final List<Consumer<LineExecute>> duties = new ArrayList<>();
    private final Map<String, String> lines = new LinkedHashMap<>();
    private final Map<String, String> states = new LinkedHashMap<>();

    private final Map<String, RemoteFunction> functions = new ConcurrentHashMap<>();
    private final List<String> functionsOf = new ArrayList<>();

    private boolean sends;
    private volatile @Nullable LineConnection opened;

    private LineFileConnection(String name, String kind, @Nullable LineTransport transport, FileModels models) {
        super(name, kind);
        this.transport = transport;
        this.models = models;
    }

    /** @param transport null if its address was refused */
    static LineFileConnection read(
            String name, String kind, @Nullable LineTransport transport, Section section, FileModels models) {
        LineFileConnection connection = new LineFileConnection(name, kind, transport, models);
        String[] greeting = section.texts("greet").stream()
                .flatMap(line -> oneLine(section, line).stream())
                .toArray(String[]::new);
        if (greeting.length > 0) {
            connection.settings.add(made -> made.greet(greeting));
        }
        section.section("watch").ifPresent(watch -> {
            Duration after = watch.duration("after").orElse(Duration.ofSeconds(30));
            watch.need("ask")
                    .flatMap(line -> oneLine(watch, line))
                    .ifPresent(line -> connection.settings.add(made -> made.watch(after, line)));
            watch.done();
        });
        return connection;
    }

    private static Optional<String> oneLine(Section section, Node.Text text) {
        if (text.value().isEmpty() || text.value().matches("(?s).*[\r\n].*")) {
            section.problems().at(text, "'" + text.value().replaceAll("\\R", "\\\\n") + "' is not one line of text");
            return Optional.empty();
        }
        return Optional.of(text.value());
    }

    @Override
    public String shortSend() {
        return "line";
    }

    @Override
    public void send(Node.Text event, Section how) {
        sends = true;
        how.need("line").flatMap(line -> oneLine(how, line)).ifPresent(line -> lines.put(event.value(), line));
    }

    @Override
    public void state(Section rule) {
        Map<Node.Text, Node.Text> pairs = rule.pairs("values");
        rule.require("values");
        Map<String, String> found = new LinkedHashMap<>();
        pairs.forEach((line, state) -> found.put(line.value(), models.deviceState(state)));
        states.putAll(found);
        rules.add(monitor -> monitor.found(found));
    }

    @Override
    public void does(Section rule) {
        events(rule, models::devicesOwn, LineMonitor::device);
    }

    @Override
    public void press(Section rule) {
        events(rule, models::pressed, LineMonitor::controller);
    }

    /** Adds a rule to a monitor. */
    private interface Adding {
        LineMonitor to(LineMonitor monitor, Meanings events);
    }

    /** The forms {@code {values: {LINE: EVENT}}} and {@code {line: PATTERN, event: EVENT}}. */
    private void events(Section rule, Function<Node.Text, String> known, Adding adding) {
        Map<String, String> values = new LinkedHashMap<>();
        rule.pairs("values").forEach((line, event) -> values.put(line.value(), known.apply(event)));
        if (!values.isEmpty()) {
            rules.add(monitor -> adding.to(monitor, Meanings.of(values)));
        }
        if (!rule.has("values") || rule.has("line") || rule.has("event")) {
            rule.require("line");
            Pattern line = rule.pattern("line").orElse(null);
            rule.need("event").map(known).ifPresent(event -> {
                if (line != null) {
                    rules.add(monitor -> adding.to(monitor, Meanings.NONE.with(Match.matching(line), event)));
                }
            });
        }
    }

    @Override
    public void reading(Node.Text reading, Section rule) {
        rule.require("line");
        String unit = rule.text("unit").map(Node.Text::value).orElse("");
        rule.pattern("line").ifPresent(line -> {
            if (line.matcher("").groupCount() == 0) {
                rule.problem("the pattern '" + line + "' has no group; put the value in parentheses");
            } else {
                settings.add(made -> made.reading(reading.value(), line, unit));
            }
        });
    }

    @Override
    public void device(Section device) {
        if (!sends) {
            return;
        }
        device.section("answer").ifPresent(answer -> {
            String ok = answer.pattern("ok").map(Pattern::pattern).orElse("OK");
            String error = answer.pattern("error").map(Pattern::pattern).orElse("ERR.*");
            Duration within = answer.duration("within").orElse(Duration.ofSeconds(2));
            duties.add(execute -> execute.answeredBy(ok, error, within));
            answer.done();
        });
        device.section("ask").filter(ask -> isFor(ask, "to")).ifPresent(ask -> {
            Duration within = ask.duration("within").orElse(Duration.ofSeconds(2));
            if (states.isEmpty()) {
                ask.problem("an answer to " + ask.name() + " is one of the lines of device.state, which has none");
            }
            ask.need("line")
                    .flatMap(line -> oneLine(ask, line))
                    .ifPresent(line -> duties.add(execute -> execute.asking(line, states, within)));
            ask.done();
        });
    }

    @Override
    public @Nullable Outward outward(Section action) {
        String line = action.need("line").flatMap(text -> oneLine(action, text)).orElse(null);
        return line == null ? null : values -> requireNonNull(opened).send(line);
    }

    @Override
    public NewFunction function(Node.Text state, Section section) {
        LineConnection running = opened;
        if (running == null) {
            functionsOf.add(state.value());
        } else {
            functions.computeIfAbsent(state.value(), added -> new RemoteFunction(running.functions()));
        }
        return visit -> requireNonNull(functions.get(state.value())).run(visit);
    }

    @Override
    protected Parts make(SystemEventConverter converter) {
        if (transport == null) {
            throw new IllegalStateException("the address of " + name() + " was refused");
        }
        LineConnection connection = new LineConnection(transport, converter.clock());
        settings.forEach(each -> each.accept(connection));
        opened = connection;
        functionsOf.forEach(state -> functions.put(state, new RemoteFunction(connection.functions())));
        LineMonitor monitor = new LineMonitor(name(), connection);
        rules.forEach(each -> each.accept(monitor));
        List<LineExecute> executes = new ArrayList<>();
        if (!lines.isEmpty()) {
            LineExecute execute = new LineExecute(name() + "Execute", connection, lines);
            duties.forEach(each -> each.accept(execute));
            executes.add(execute);
        }
        return new Parts(List.of(monitor), executes, connection, connection::open, connection::close);
    }
}
