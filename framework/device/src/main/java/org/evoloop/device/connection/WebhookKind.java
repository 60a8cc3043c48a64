package org.evoloop.device.connection;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.Connection;
import org.evoloop.device.ConnectionKind;
import org.evoloop.device.FileModels;
import org.evoloop.device.Parts;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.http.HttpMonitor;

/**
 * {@code webhooks: PORT}: a controller, or a device, that sends HTTP requests to this computer.
 *
 * <p>Threading: as {@link ConnectionKind}.
 *
 * @since 0.1
 */
public final class WebhookKind implements ConnectionKind {
    private static final int HIGHEST_PORT = 65_535;

    /** For {@link java.util.ServiceLoader}. */
    public WebhookKind() {}

    @Override
    public String key() {
        return "webhooks";
    }

    @Override
    public Connection read(String name, Section section, FileModels models) {
        return new Webhooks(name, section.number("webhooks", 1, HIGHEST_PORT).orElse(0), models);
    }

    private static final class Webhooks extends Connection {
        private final int port;
        private final FileModels models;
        private final List<Consumer<HttpMonitor>> rules = new ArrayList<>();

        Webhooks(String name, int port, FileModels models) {
            super(name, "webhooks");
            this.port = port;
            this.models = models;
        }

        @Override
        public void send(Node.Text event, Section how) {
            how.problem("connection " + name() + " only receives; send over another one");
        }

        @Override
        public void state(Section rule) {
            requests(rule, models::deviceState, HttpMonitor::found);
        }

        @Override
        public void does(Section rule) {
            requests(rule, models::devicesOwn, HttpMonitor::device);
        }

        @Override
        public void press(Section rule) {
            requests(rule, models::pressed, HttpMonitor::controller);
        }

        /** Adds a rule to a monitor. */
        private interface Adding {
            HttpMonitor to(HttpMonitor monitor, String request, String name);
        }

        /** The form {@code {POST /boost: boost}}. */
        private void requests(Section rule, Function<Node.Text, String> known, Adding adding) {
            rule.require("values");
            Map<String, String> meanings = new LinkedHashMap<>();
            rule.pairs("values").forEach((request, name) -> {
                String meaning = known.apply(name);
                if (request.value().matches("(GET|POST|PUT|DELETE|PATCH) /\\S*")) {
                    meanings.put(request.value(), meaning);
                } else {
                    rule.problems().at(request, "'" + request + "' is no request; write one such as POST /boost");
                }
            });
            meanings.forEach((request, name) -> rules.add(monitor -> adding.to(monitor, request, name)));
        }

        @Override
        protected Parts make(SystemEventConverter converter) {
            HttpMonitor monitor = new HttpMonitor(name(), port);
            rules.forEach(rule -> rule.accept(monitor));
            return new Parts(List.of(monitor), List.of(), null, monitor::open, monitor::close);
        }
    }
}
