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
    List<String> artifacts() {
        return List.of("evoloop-http");
    }

    @Override
    String adding() {
        return "        HttpMonitor " + variable() + " = new HttpMonitor(" + literal(name()) + ", " + port + ")\n"
                + rules().stripTrailing() + ";\n        converter.addMonitor(" + variable() + ");\n"
                + "        openings.add(" + variable() + "::open);\n        closings.add(" + variable()
                + "::close);\n";
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
}
