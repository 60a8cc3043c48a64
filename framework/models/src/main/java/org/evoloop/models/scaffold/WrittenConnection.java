package org.evoloop.models.scaffold;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.jspecify.annotations.Nullable;

/** A connection of a device file, in Java: a field of the class {@code Connections}, and what is added to the converter. */
abstract class WrittenConnection {
    private final String name;
    private final String field;
    private final StringBuilder rules = new StringBuilder();
    private final Map<String, String> sent = new LinkedHashMap<>();
    private @Nullable WrittenConnection confirming;

    WrittenConnection(String name, String field) {
        this.name = name;
        this.field = field;
    }

    /** Null, and noted as a mistake, for a kind that has no counterpart here. */
    static @Nullable WrittenConnection of(Node.Text name, String field, Section section, String converter) {
        if (section.has("mqtt")) {
            return new WrittenMqtt(name.value(), field, section);
        } else if (section.has("http")) {
            return new WrittenHttp(name.value(), field, section);
        } else if (section.has("lines") || section.has("program")) {
            return new WrittenLines(name.value(), field, section);
        } else if (section.has("webhooks")) {
            return new WrittenWebhooks(name.value(), field, section);
        } else if (section.has("gpio")) {
            return new WrittenPins(name.value(), field, section);
        } else if (section.has("home-assistant")) {
            return new WrittenHome(name.value(), field, section, converter);
        }
        section.problems()
                .at(
                        name,
                        "connection " + name + " is of a kind that --from does not turn into Java, which are lines,"
                                + " program, mqtt, http, webhooks, gpio and home-assistant; keep this file, or leave the connection out"
                                + " and add it in Java");
        return null;
    }

    final String name() {
        return name;
    }

    /** The variable. */
    final String variable() {
        return field;
    }

    /** Adds a call to those that set up its monitor. */
    final void rule(String call) {
        rules.append("                ").append(call).append('\n');
    }

    /** The calls of {@link #rule}; each on a line. */
    final String rules() {
        return rules.toString();
    }

    /** What is sent over this connection is confirmed by what another one reports, or by this one. */
    final void confirmedBy(WrittenConnection reporting) {
        confirming = reporting;
    }

    /** Whether it confirms what is sent over all connections. */
    final boolean confirmsAll() {
        return confirming == this;
    }

    /** Whether a section of the device is for this connection: it names it with {@code key}, or none. */
    final boolean isFor(Section section, String key) {
        return section.text(key).map(named -> named.value().equals(name)).orElse(true);
    }

    /** The variable of the component that sends. */
    final String executeVariable() {
        return field + "Execute";
    }

    /** Adds a component that sends. */
    final String addition(String execute) {
        WrittenConnection other = confirming;
        return other == null || other == this
                ? "        converter.addExecute(" + execute + ");\n"
                : "        " + other.executeVariable() + ".through(" + execute + ");\n";
    }

    final void sends(String event, String expression) {
        sent.put(event, expression);
    }

    /** What is sent, as a map's expression; empty if nothing is. */
    final Optional<String> sent() {
        return sent.isEmpty() ? Optional.empty() : Optional.of(WrittenConnections.map(sent));
    }

    /** What this kind has not: a file that has been read without mistakes does not ask for it. */
    private IllegalStateException absent() {
        return new IllegalStateException(name + " has no such thing");
    }

    /** The key of what is sent in a short form. */
    String shortSend() {
        throw absent();
    }

    /** The artifacts that it takes. */
    abstract List<String> artifacts();

    /** The declaration of its field; empty if it has none. */
    String field() {
        return "";
    }

    /** Creates it, in the constructor; empty if it is created later. */
    String creation() {
        return "";
    }

    /** Adds it to the converter. */
    abstract String adding();

    void send(String event, Section how) {
        throw absent();
    }

    abstract void state(Section rule);

    /** @param method of a monitor: {@code controller} or {@code device} */
    abstract void events(Section rule, String method);

    void reading(String reading, Section rule) {
        throw absent();
    }

    /** What the section {@code device} says about all that is sent. */
    void device(Section device) {}

    /**
     * The way to a program that runs the function of a state, as an expression of the constructor.
     *
     * @param function the section of the function
     */
    String functions(String converter, String state, Section function) {
        throw absent();
    }

    /** What an action does, as an expression of the class {@code Connections} named {@code connections}. */
    String outside(Section action, String values) {
        throw absent();
    }
}
