package org.evoloop.models.scaffold;

import static org.evoloop.models.scaffold.JavaText.literal;

import java.util.List;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;

/** A controller, or a device, that sends requests: the kind {@code webhooks}. It only receives. */
final class WrittenWebhooks extends WrittenConnection {
    private final Node.Text port;

    WrittenWebhooks(String name, String field, Section section) {
        super(name, field);
        this.port = section.need("webhooks").orElseThrow();
    }

    @Override
    String shortSend() {
        throw onlyReceives();
    }

    private static IllegalStateException onlyReceives() {
        return new IllegalStateException("webhooks only receive");
    }

    @Override
    List<String> artifacts() {
        return List.of("evoloop-http");
    }

    @Override
    String field() {
        return "";
    }

    @Override
    String creation() {
        return "";
    }

    @Override
    String adding() {
        return "        HttpMonitor " + variable() + " = new HttpMonitor(" + literal(name()) + ", " + port + ")\n"
                + rules().stripTrailing() + ";\n        converter.addMonitor(" + variable() + ");\n"
                + "        openings.add(" + variable() + "::open);\n        closings.add(" + variable()
                + "::close);\n";
    }

    @Override
    void send(String event, Section how) {
        throw onlyReceives();
    }

    @Override
    void state(Section rule) {
        events(rule, "found");
    }

    @Override
    void events(Section rule, String method) {
        rule.pairs("values")
                .forEach((request, name) ->
                        rule("." + method + "(" + literal(request.value()) + ", " + literal(name.value()) + ")"));
    }

    @Override
    void reading(String reading, Section rule) {
        throw onlyReceives();
    }

    @Override
    void device(Section device) {
        // Nothing is sent.
    }

    @Override
    String functions(String converter, String state, Section function) {
        throw onlyReceives();
    }

    @Override
    String outside(Section action, String values) {
        throw onlyReceives();
    }
}
