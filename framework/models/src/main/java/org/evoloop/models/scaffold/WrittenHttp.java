package org.evoloop.models.scaffold;

import static org.evoloop.models.scaffold.JavaText.literal;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;

/** A device that answers requests: the kind {@code http}. */
final class WrittenHttp extends WrittenConnection {
    private final Section section;
    private final String base;
    private String states = "";
    private String readyAfter = "";

    WrittenHttp(String name, String field, Section section) {
        super(name, field);
        this.section = section;
        this.base = section.need("http").orElseThrow().value().replaceFirst("/+$", "");
    }

    private String call(String request, String body) {
        String[] words = request.split(" ", 2);
        StringBuilder call = new StringBuilder("HttpCall.")
                .append(words[0].toLowerCase(Locale.ROOT))
                .append('(')
                .append(literal(base + words[1]))
                .append(words[0].equals("GET") ? ")" : ", " + literal(body) + ")");
        section.pairs("headers").forEach((name, value) -> header(call, name, literal(value.value())));
        section.pairs("header-files")
                .forEach((name, file) -> header(call, name, WrittenConnections.secret(section, file)));
        return call.toString();
    }

    private static void header(StringBuilder call, Node.Text name, String value) {
        call.append(".header(")
                .append(literal(name.value()))
                .append(", ")
                .append(value)
                .append(')');
    }

    private String call(Section how) {
        String accepting = how.text("accepted")
                .map(Node.Text::value)
                .map(range -> range.contains("..") ? range.replace("..", ", ") : range + ", " + range)
                .map(range -> ".accepting(" + range + ")")
                .orElse("");
        return call(
                        how.need("call").orElseThrow().value(),
                        how.text("body").map(Node.Text::value).orElse(""))
                + accepting;
    }

    @Override
    String shortSend() {
        return "call";
    }

    @Override
    List<String> artifacts() {
        return List.of("evoloop-http");
    }

    @Override
    String adding() {
        StringBuilder java = new StringBuilder();
        String execute = executeVariable();
        String within = WrittenConnections.within(section);
        sent().ifPresent(calls -> java.append("        HttpExecute ")
                .append(execute)
                .append(" = new HttpExecute(")
                .append(literal(name() + "Execute"))
                .append(", ")
                .append(calls)
                .append(", ")
                .append(within)
                .append(")")
                .append(readyAfter)
                .append(";\n")
                .append(addition(execute)));
        String question =
                section.text("poll").map(path -> call("GET " + path, "")).orElse("");
        if (question.isEmpty()) {
            sent().ifPresent(calls ->
                    java.append("        links.add(").append(execute).append(");\n"));
            return java.toString();
        }
        String asked = variable() + "Question";
        java.append("        HttpCall ")
                .append(asked)
                .append(" = ")
                .append(question)
                .append(";\n");
        if (!states.isEmpty()) {
            java.append("        Meanings ").append(variable()).append("States = ");
            java.append(states).append(";\n");
        }
        java.append("        HttpPoll ")
                .append(variable())
                .append(" = new HttpPoll(")
                .append(literal(name()));
        java.append(", converter, ").append(asked).append(", ");
        java.append(WrittenConnections.duration(section.period("every").orElse(Duration.ofSeconds(5))));
        java.append(", ").append(within).append(")\n").append(rules());
        java.append("                .downAfter(");
        java.append(section.text("down-after").map(Node.Text::value).orElse("3"))
                .append(");\n");
        sent().ifPresent(calls -> {
            java.append("        ").append(variable()).append(".beside(").append(execute);
            java.append(");\n");
            if (!states.isEmpty()) {
                java.append("        ").append(execute).append(".asking(").append(asked);
                java.append(", ").append(variable()).append("States);\n");
            }
        });
        java.append("        converter.addMonitor(").append(variable()).append(");\n        links.add(");
        java.append(variable()).append(");\n        openings.add(").append(variable());
        java.append("::open);\n        closings.add(").append(variable()).append("::close);\n");
        return java.toString();
    }

    @Override
    void send(String event, Section how) {
        sends(event, call(how));
    }

    @Override
    void state(Section rule) {
        states = WrittenConnections.meanings(rule, "state");
        rule(".found(" + variable() + "States)");
        if (rule.flag("infer-events").orElse(false)) {
            rule(".inferring()");
        }
    }

    @Override
    void events(Section rule, String method) {
        rule("." + method + "(" + WrittenConnections.meanings(rule, "event") + ")");
    }

    @Override
    void reading(String reading, Section rule) {
        rule(".reading(" + literal(reading) + ", " + WrittenConnections.part(rule) + ", "
                + WrittenConnections.unit(rule) + ")");
    }

    @Override
    void device(Section device) {
        device.duration("ready-after")
                .ifPresent(pause -> readyAfter = ".readyAfter(" + WrittenConnections.duration(pause) + ", clock)");
    }

    @Override
    String outside(Section action, String values) {
        return call(action) + ".send(" + values + ", " + WrittenConnections.within(section) + ")";
    }
}
