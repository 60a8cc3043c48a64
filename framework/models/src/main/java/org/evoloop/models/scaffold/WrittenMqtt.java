package org.evoloop.models.scaffold;

import static org.evoloop.models.scaffold.JavaText.literal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;

/** A broker's connection: the kind {@code mqtt}. */
final class WrittenMqtt extends WrittenConnection {
    private record Found(String topic, String variable) {}

    private final Section section;
    private final StringBuilder settings = new StringBuilder();
    private final StringBuilder duties = new StringBuilder();
    private final Map<String, String> stateMeanings = new LinkedHashMap<>();
    private final List<Found> states = new ArrayList<>();
    private boolean infers;

    WrittenMqtt(String name, String field, Section section) {
        super(name, field);
        this.section = section;
        section.section("availability").ifPresent(here -> {
            String online = here.text("online").map(Node.Text::value).orElse("online");
            String part = here.has("json") ? ".in(" + WrittenConnections.part(here) + ")" : "";
            setting(".availability(" + topic(here, "state-topic") + ", Match.exactly(" + literal(online) + ")" + part
                    + ")");
        });
    }

    private void setting(String call) {
        settings.append("\n                ").append(call);
    }

    /** The topic of a rule, else this one of the connection. */
    private String topic(Section rule, String otherwise) {
        return literal(rule.text("topic")
                .or(() -> section.text(otherwise))
                .orElseThrow()
                .value());
    }

    private String message(Section how, String payload) {
        return "Message.command(" + topic(how, "command-topic") + ", " + payload + ")";
    }

    private static String payload(Section how) {
        return literal(how.need("payload").orElseThrow().value());
    }

    private String device() {
        return variable() + "Device";
    }

    @Override
    String shortSend() {
        return "payload";
    }

    @Override
    List<String> artifacts() {
        return List.of("evoloop-mqtt");
    }

    @Override
    String field() {
        return "    final BrokerConnection " + variable() + ";\n    private final MqttDevice " + device() + ";\n";
    }

    @Override
    String creation() {
        String address = "BrokerAddress.parse("
                + literal(section.need("mqtt").orElseThrow().value()) + ")";
        String password = section.text("password-file")
                .map(file -> ".withPassword(" + WrittenConnections.secret(section, file) + ")")
                .orElse("");
        return "        " + variable() + " = new BrokerConnection(\n                " + address + password + ", "
                + literal("evoloop-" + name() + "-") + " + ProcessHandle.current().pid());\n"
                + "        " + device() + " = new MqttDevice(" + variable() + ", clock)" + settings + ";\n";
    }

    @Override
    String adding() {
        StringBuilder java = new StringBuilder();
        String device = device();
        stateMeanings.forEach((name, meanings) -> java.append("        Meanings ")
                .append(name)
                .append(" = ")
                .append(meanings)
                .append(";\n"));
        java.append("        converter.addMonitor(new MqttMonitor(").append(literal(name()));
        java.append(", ").append(device).append(")\n").append(rules());
        java.append(infers ? "                .inferring(converter));\n" : "        );\n");
        sent().or(() -> confirmsAll() ? Optional.of("Map.of()") : Optional.empty())
                .map(messages -> "new MqttExecute(" + literal(name() + "Execute") + ", " + device + ", " + messages
                        + ")" + duties)
                .map(execute -> confirmsAll()
                        ? "        MqttExecute " + executeVariable() + " = " + execute + ";\n"
                                + addition(executeVariable())
                        : addition(execute))
                .ifPresent(java::append);
        java.append("        links.add(").append(device).append(");\n");
        java.append("        openings.add(").append(variable()).append("::open);\n");
        java.append("        closings.add(").append(variable()).append("::close);\n");
        return java.toString();
    }

    @Override
    void send(String event, Section how) {
        sends(event, message(how, payload(how)));
    }

    @Override
    void state(Section rule) {
        String meanings = variable() + "States" + (states.isEmpty() ? "" : states.size() + 1);
        String topic = topic(rule, "state-topic");
        stateMeanings.put(meanings, WrittenConnections.meanings(rule, "state"));
        states.add(new Found(topic, meanings));
        infers |= rule.flag("infer-events").orElse(false);
        rule(".found(" + topic + ", " + meanings + ")");
    }

    @Override
    void events(Section rule, String method) {
        rule("." + method + "(" + topic(rule, "state-topic") + ", " + WrittenConnections.meanings(rule, "event") + ")");
    }

    @Override
    void reading(String reading, Section rule) {
        setting(".reading(" + literal(reading) + ", " + topic(rule, "state-topic") + ", "
                + WrittenConnections.part(rule) + ", " + WrittenConnections.unit(rule) + ")");
    }

    @Override
    void device(Section device) {
        device.section("confirmed")
                .filter(confirmed -> isFor(confirmed, "from"))
                .ifPresent(confirmed -> states.forEach(state -> duty(".confirmedBy(" + state.topic() + ", "
                        + state.variable() + ", " + WrittenConnections.within(confirmed) + ")")));
        // The question of another connection has no payload.
        device.section("ask")
                .filter(ask -> ask.has("payload") && isFor(ask, "to"))
                .ifPresent(ask -> states.forEach(state -> duty(".asking(" + message(ask, payload(ask)) + ", "
                        + state.topic() + ", " + state.variable() + ", " + WrittenConnections.within(ask) + ")")));
        device.duration("ready-after")
                .ifPresent(pause -> duty(".readyAfter(" + WrittenConnections.duration(pause) + ")"));
    }

    private void duty(String call) {
        duties.append("\n                ").append(call);
    }

    @Override
    String functions(String converter, String state, Section function) {
        String topic = function.text("topic")
                .map(given -> literal(given.value()))
                .orElse("MqttFunctions.topic(" + literal(converter) + ", " + literal(state) + ")");
        return "new MqttFunctions(" + device() + ", " + topic + ")";
    }

    @Override
    String outside(Section action, String values) {
        String text = payload(action);
        String payload = text.contains("${") ? "Template.of(" + text + ").with(" + values + ")" : text;
        return "Connections.publish(connections." + variable() + ", " + message(action, payload) + ")";
    }
}
