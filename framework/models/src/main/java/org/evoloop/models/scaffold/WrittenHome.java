package org.evoloop.models.scaffold;

import static org.evoloop.models.scaffold.JavaText.literal;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.NodeJson;
import org.evoloop.device.file.Section;

/** Entities of Home Assistant: the kind {@code home-assistant}. */
final class WrittenHome extends WrittenConnection {
    private static final Duration CONFIRMED = Duration.ofSeconds(5);
    private static final String TOKEN = "EVOLOOP_HOME_ASSISTANT_TOKEN";

    private final Section section;
    private final String converter;
    private final StringBuilder readings = new StringBuilder();
    private final StringBuilder duties = new StringBuilder();
    /** What is called by actions, so that it is checked after each connect. */
    private final List<String> outward = new ArrayList<>();
    /** Variables of the meanings of states, by the value that reports them. */
    private final Map<String, String> states = new LinkedHashMap<>();

    private final StringBuilder meanings = new StringBuilder();
    private boolean infers;

    /** @param converter its name, by which its own entities are known */
    WrittenHome(String name, String field, Section section, String converter) {
        super(name, field);
        this.section = section;
        this.converter = converter;
    }

    private String device() {
        return variable() + "Device";
    }

    private Node.Text entity(Section rule) {
        return rule.text("entity").or(() -> section.text("entity")).orElseThrow();
    }

    private String value(Section rule) {
        String entity = literal(entity(rule).value());
        return rule.text("attribute")
                .map(attribute -> "EntityValue.attribute(" + entity + ", " + literal(attribute.value()) + ")")
                .orElse("EntityValue.state(" + entity + ")");
    }

    private String call(Section how) {
        String entity = how.text("entity")
                .or(() -> section.text("entity"))
                .map(text -> literal(text.value()))
                .orElse("null");
        String data = how.section("data").map(each -> NodeJson.of(each.node())).orElse("{}");
        return "new ServiceCall(" + literal(how.need("service").orElseThrow().value()) + ", " + entity + ", "
                + literal(data) + ")";
    }

    @Override
    String shortSend() {
        return "service";
    }

    @Override
    List<String> artifacts() {
        return List.of("evoloop-home-assistant");
    }

    @Override
    String field() {
        return "    final HomeConnection " + variable() + ";\n    private final HomeDevice " + device() + ";\n";
    }

    @Override
    String creation() {
        String url = section.need("home-assistant").orElseThrow().value();
        String folder = String.valueOf(
                section.problems().file().toAbsolutePath().normalize().getParent());
        String address = "HomeAddress.parse(" + literal(url)
                + (url.contains("?ca=") ? ", Path.of(" + literal(folder) + ")::resolve)" : ")");
        String token = section.text("token-file")
                .map(file -> WrittenConnections.secret(section, file))
                .orElse("Optional.ofNullable(System.getenv(" + literal(TOKEN) + "))\n"
                        + "                        .orElseThrow(() -> new IllegalArgumentException("
                        + literal("the environment has no " + TOKEN) + "))");
        StringBuilder java = new StringBuilder("        " + variable() + " = new HomeConnection(" + address
                + ",\n                () -> " + token + ")\n                .shownAs(" + literal(converter) + ");\n");
        outward.forEach(call -> java.append("        ")
                .append(variable())
                .append(".require(")
                .append(call)
                .append(");\n"));
        return java + "        " + device() + " = new HomeDevice(" + variable() + ", clock)" + readings + ";\n";
    }

    @Override
    String adding() {
        StringBuilder java = new StringBuilder(meanings);
        java.append("        converter.addMonitor(new HomeMonitor(").append(literal(name()));
        java.append(", ").append(device()).append(")\n").append(rules());
        java.append(infers ? "                .inferring(converter));\n" : "        );\n");
        sent().ifPresent(calls -> java.append(addition(
                "new HomeExecute(" + literal(name() + "Execute") + ", " + device() + ", " + calls + ")" + duties)));
        java.append("        links.add(").append(device()).append(");\n");
        java.append("        openings.add(").append(variable()).append("::open);\n");
        java.append("        closings.add(").append(variable()).append("::close);\n");
        return java.toString();
    }

    @Override
    void send(String event, Section how) {
        sends(event, call(how));
    }

    @Override
    void state(Section rule) {
        String value = value(rule);
        String variable = variable() + "States" + (states.isEmpty() ? "" : states.size() + 1);
        meanings.append("        Meanings ")
                .append(variable)
                .append(" = ")
                .append(WrittenConnections.meanings(rule, "state"))
                .append(";\n");
        states.put(variable, value);
        infers |= rule.flag("infer-events").orElse(false);
        rule(".found(" + value + ", " + variable + ")");
    }

    @Override
    void events(Section rule, String method) {
        String from = rule.section("trigger")
                .map(trigger -> "HomeEvents.trigger(" + literal(NodeJson.of(trigger.node())) + ")")
                .or(() -> rule.text("event-type").map(type -> "HomeEvents.ofType(" + literal(type.value()) + ")"))
                .orElseGet(() -> value(rule));
        String meant = rule.meansAnyMessage()
                ? "Meanings.NONE.with(Match.any(), "
                        + literal(rule.text("event").orElseThrow().value()) + ")"
                : WrittenConnections.meanings(rule, "event");
        rule("." + method + "(" + from + ", " + meant + ")");
    }

    @Override
    void reading(String reading, Section rule) {
        readings.append("\n                .reading(")
                .append(literal(reading))
                .append(", ")
                .append(value(rule))
                .append(", ")
                .append(WrittenConnections.unit(rule))
                .append(")");
    }

    @Override
    void device(Section device) {
        Duration within = device.section("confirmed")
                .flatMap(confirmed -> confirmed.duration("within"))
                .orElse(CONFIRMED);
        states.forEach((variable, value) ->
                duty(".confirmedBy(" + value + ", " + variable + ", " + WrittenConnections.duration(within) + ")"));
        device.section("ask")
                .flatMap(ask -> ask.duration("within"))
                .ifPresent(limit -> duty(".askedWithin(" + WrittenConnections.duration(limit) + ")"));
        device.duration("ready-after")
                .ifPresent(pause -> duty(".readyAfter(" + WrittenConnections.duration(pause) + ")"));
    }

    private void duty(String call) {
        duties.append("\n                ").append(call);
    }

    @Override
    String outside(Section action, String values) {
        String call = call(action);
        outward.add(call);
        return "connections." + variable() + ".carryOut(" + call + ", " + values + ")";
    }
}
