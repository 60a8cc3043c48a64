package org.evoloop.models.scaffold;

import static org.evoloop.models.scaffold.JavaText.literal;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;

/** Lines of text: the kinds {@code lines} and {@code program}. */
final class WrittenLines extends WrittenConnection {
    private static final String TCP = "tcp://";
    private static final String SERIAL = "serial://";
    private static final String UNIX = "unix://";

    private final Section section;
    private final StringBuilder settings = new StringBuilder();
    private final StringBuilder duties = new StringBuilder();
    private final Map<String, String> states = new LinkedHashMap<>();

    WrittenLines(String name, String field, Section section) {
        super(name, field);
        this.section = section;
        List<Node.Text> greeting = section.texts("greet");
        if (!greeting.isEmpty()) {
            setting(greeting.stream()
                    .map(line -> literal(line.value()))
                    .collect(Collectors.joining(", ", ".greet(", ")")));
        }
        section.section("watch")
                .ifPresent(watch -> setting(".watch("
                        + WrittenConnections.duration(watch.duration("after").orElse(Duration.ofSeconds(30))) + ", "
                        + literal(watch.need("ask").orElseThrow().value()) + ")"));
    }

    private void setting(String call) {
        settings.append("\n                ").append(call);
    }

    private String transport() {
        if (section.has("program")) {
            return "LineTransport.program(" + WrittenConnections.list(section.texts("program")) + ")";
        }
        String address = section.need("lines").orElseThrow().value();
        if (address.startsWith(SERIAL)) {
            return "SerialTransport.at(" + literal(address.substring(SERIAL.length())) + ", "
                    + section.text("baud").map(Node.Text::value).orElse("9600") + ")";
        }
        if (address.startsWith(UNIX)) {
            return "LineTransport.unix(Path.of(" + literal(address.substring(UNIX.length())) + "))";
        }
        String tcp = address.substring(TCP.length()).replaceFirst("/$", "");
        int colon = tcp.lastIndexOf(':');
        return "LineTransport.tcp(" + literal(tcp.substring(0, colon)) + ", " + tcp.substring(colon + 1) + ")";
    }

    @Override
    String shortSend() {
        return "line";
    }

    @Override
    List<String> artifacts() {
        return transport().startsWith("Serial") ? List.of("evoloop-line", "evoloop-serial") : List.of("evoloop-line");
    }

    @Override
    String field() {
        return "    final LineConnection " + variable() + ";\n";
    }

    @Override
    String creation() {
        return "        " + variable() + " = new LineConnection(" + transport() + ", clock)" + settings + ";\n";
    }

    @Override
    String adding() {
        String execute = sent().map(lines -> addition("new LineExecute(" + literal(name() + "Execute") + ", "
                        + variable() + ", " + lines + ")" + duties))
                .orElse("");
        return "        converter.addMonitor(new LineMonitor(" + literal(name()) + ", " + variable() + ")\n"
                + rules().stripTrailing() + ");\n" + execute + "        links.add(" + variable() + ");\n"
                + "        openings.add(" + variable() + "::open);\n        closings.add(" + variable()
                + "::close);\n";
    }

    @Override
    void send(String event, Section how) {
        sends(event, literal(how.need("line").orElseThrow().value()));
    }

    @Override
    void state(Section rule) {
        Map<String, String> found = new LinkedHashMap<>();
        rule.pairs("values").forEach((line, state) -> found.put(line.value(), literal(state.value())));
        states.putAll(found);
        rule(".found(" + WrittenConnections.map(found) + ")");
    }

    @Override
    void events(Section rule, String method) {
        Map<String, String> values = new LinkedHashMap<>();
        rule.pairs("values").forEach((line, event) -> values.put(line.value(), literal(event.value())));
        if (!values.isEmpty()) {
            rule("." + method + "(" + WrittenConnections.map(values) + ")");
        }
        rule.text("line")
                .ifPresent(line -> rule("." + method + "(Pattern.compile(" + literal(line.value()) + "), "
                        + literal(rule.need("event").orElseThrow().value()) + ")"));
    }

    @Override
    void reading(String reading, Section rule) {
        setting(".reading(" + literal(reading) + ", Pattern.compile("
                + literal(rule.need("line").orElseThrow().value()) + "), " + WrittenConnections.unit(rule) + ")");
    }

    @Override
    void device(Section device) {
        device.section("answer")
                .ifPresent(answer -> duty(".answeredBy("
                        + literal(answer.text("ok").map(Node.Text::value).orElse("OK")) + ", "
                        + literal(answer.text("error").map(Node.Text::value).orElse("ERR.*")) + ", "
                        + WrittenConnections.within(answer) + ")"));
        // The question of another connection has no line.
        device.section("ask")
                .filter(ask -> ask.has("line") && isFor(ask, "to"))
                .ifPresent(ask ->
                        duty(".asking(" + literal(ask.need("line").orElseThrow().value()) + ", "
                                + WrittenConnections.map(states) + ", " + WrittenConnections.within(ask) + ")"));
    }

    private void duty(String call) {
        duties.append("\n                ").append(call);
    }

    @Override
    String functions(String converter, String state, Section function) {
        return variable() + ".functions()";
    }

    @Override
    String outside(Section action, String values) {
        return "connections." + variable() + ".send("
                + literal(action.need("line").orElseThrow().value()) + ")";
    }
}
