package org.evoloop.models.scaffold;

import static org.evoloop.models.scaffold.JavaText.literal;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;

/** Contacts and outputs on the pins of this computer: the kind {@code gpio}. The pins are opened when it is added to the converter. */
final class WrittenPins extends WrittenConnection {
    private static final Duration PRESS = Duration.ofMillis(200);

    private final Duration debounce;
    private final StringBuilder outputs = new StringBuilder();
    private final Set<String> lamps = new TreeSet<>();

    WrittenPins(String name, String field, Section section) {
        super(name, field);
        this.debounce = section.duration("debounce").orElse(Duration.ofMillis(20));
    }

    @Override
    List<String> artifacts() {
        return List.of("evoloop-gpio");
    }

    private String lamp(String pin) {
        return variable() + "Lamp" + pin;
    }

    @Override
    String field() {
        StringBuilder fields = new StringBuilder();
        lamps.forEach(pin -> fields.append("    OutputPin ").append(lamp(pin)).append(";\n"));
        return fields.toString();
    }

    @Override
    String adding() {
        StringBuilder java = new StringBuilder("        Pins " + variable() + " = Pins.open();\n");
        lamps.forEach(pin -> java.append("        ")
                .append(lamp(pin))
                .append(" = new OutputPin(")
                .append(variable())
                .append(", ")
                .append(pin)
                .append(");\n"));
        java.append("        converter.addMonitor(new GpioMonitor(").append(literal(name()));
        java.append(", ").append(variable()).append(", clock)\n");
        java.append(rules().stripTrailing()).append(");\n");
        if (!outputs.isEmpty()) {
            java.append("        converter.addExecute(new GpioExecute(").append(literal(name() + "Execute"));
            java.append(", ")
                    .append(variable())
                    .append(", clock)")
                    .append(outputs)
                    .append(");\n");
        }
        return java.append("        closings.add(")
                .append(variable())
                .append("::close);\n")
                .toString();
    }

    @Override
    void send(String event, Section how) {
        outputs.append("\n                .");
        if (how.has("pulse")) {
            outputs.append("pulse(")
                    .append(literal(event))
                    .append(", ")
                    .append(how.need("pulse").orElseThrow())
                    .append(", ")
                    .append(WrittenConnections.duration(how.period("for").orElse(PRESS)));
        } else {
            outputs.append("hold(")
                    .append(literal(event))
                    .append(", ")
                    .append(how.need("hold").orElseThrow())
                    .append(", ")
                    .append(isHigh(how));
        }
        outputs.append(')');
    }

    private static boolean isHigh(Section how) {
        return how.need("level").orElseThrow().value().equals("high");
    }

    private void contact(Section rule, String call, String more) {
        rule(".debounce("
                + WrittenConnections.duration(rule.duration("debounce").orElse(debounce)) + ")");
        rule("." + call + "(" + rule.need("contact").orElseThrow() + more + ")");
    }

    @Override
    void state(Section rule) {
        String closed = rule.text("closed").map(Node.Text::value).orElse("");
        String open = rule.text("open").map(Node.Text::value).orElse("");
        contact(rule, "found", ", " + literal(closed) + ", " + literal(open));
    }

    @Override
    void events(Section rule, String method) {
        contact(rule, method, ", " + literal(rule.need("event").orElseThrow().value()));
    }

    @Override
    String outside(Section action, String values) {
        String pin = action.need("hold").orElseThrow().value();
        lamps.add(pin);
        return "connections." + lamp(pin) + ".set(" + isHigh(action) + ")";
    }
}
