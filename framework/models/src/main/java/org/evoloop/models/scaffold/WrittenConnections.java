package org.evoloop.models.scaffold;

import static org.evoloop.models.scaffold.JavaText.literal;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.device.DeviceFile;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.jspecify.annotations.Nullable;

/** Writes the connections of a device file in Java. The file has been read before, and has no mistakes. */
final class WrittenConnections {
    private static final String LINES = "evoloop-line";
    private static final Duration USUAL_LIMIT = Duration.ofSeconds(2);
    private static final Duration LIMIT_OF_PROGRAMS = Duration.ofSeconds(10);

    private final Map<String, WrittenConnection> byName = new LinkedHashMap<>();
    private final Set<String> artifacts = new LinkedHashSet<>();
    private final Set<String> helpers = new TreeSet<>();
    private final Map<String, String> commands = new LinkedHashMap<>();
    private final Map<String, String> functions = new LinkedHashMap<>();
    private final JavaNames names = new JavaNames();
    private @Nullable WrittenConnection confirming;

    /** @param file of which a connection that has no counterpart here is noted as a mistake */
    WrittenConnections(Section file) {
        List.of("clock", "links", "openings", "closings", "connected", "converter")
                .forEach(names::reserve);
        String converter = file.text("converter").map(Node.Text::value).orElse("");
        file.named("connections").forEach((name, section) -> {
            String field = names.free(JavaNames.small(JavaNames.camel(name.value(), "Connection")) + "Link");
            WrittenConnection written = WrittenConnection.of(name, field, section, converter);
            if (written != null) {
                byName.put(name.value(), written);
                artifacts.addAll(written.artifacts());
            }
        });
        if (file.problems().isEmpty()) {
            file.section("device").ifPresent(this::device);
            file.section("controller")
                    .ifPresent(controller -> DeviceFile.rules(controller, "press")
                            .forEach(rule -> named(rule, "from").events(rule, "controller")));
        }
    }

    private WrittenConnection named(Section section, String key) {
        return section.text(key)
                .map(name -> byName.get(name.value()))
                .orElseGet(() -> byName.values().iterator().next());
    }

    private void device(Section device) {
        device.section("send").ifPresent(send -> send.keys().forEach(event -> send(send, event)));
        DeviceFile.rules(device, "state").forEach(rule -> named(rule, "from").state(rule));
        DeviceFile.rules(device, "does").forEach(rule -> named(rule, "from").events(rule, "device"));
        device.named("readings").forEach((name, rule) -> named(rule, "from").reading(name.value(), rule));
        confirming = device.section("confirmed")
                .flatMap(confirmed -> confirmed.text("from"))
                .map(from -> byName.get(from.value()))
                .orElse(null);
        if (confirming != null) {
            byName.values().forEach(each -> each.confirmedBy(confirming));
        }
        byName.values().forEach(each -> each.device(device));
    }

    private void send(Section send, Node.Text event) {
        Node how = send.any(event.value()).orElseThrow();
        if (how instanceof Node.Text text) {
            WrittenConnection only = byName.values().iterator().next();
            only.send(
                    event.value(),
                    new Section("", new Node.Entries(how.line(), Map.of(key(how, only), text)), send.problems()));
            return;
        }
        Section section = send.section(event.value()).orElseThrow();
        if (isRun(section, "to")) {
            commands.put(event.value(), command(section));
        } else {
            named(section, "to").send(event.value(), section);
        }
    }

    private static Node.Text key(Node place, WrittenConnection of) {
        return new Node.Text(place.line(), of.shortSend(), true);
    }

    private static boolean isRun(Section section, String key) {
        return section.has("run") && !section.has(key);
    }

    private String command(Section section) {
        artifacts.add(LINES);
        return "new ProgramCommand(" + list(section.texts("run")) + ", "
                + duration(section.duration("within").orElse(LIMIT_OF_PROGRAMS)) + ", clock)";
    }

    /** The function of {@code state} that another program runs, as the name of its field. */
    String function(String converter, String state, Section function) {
        String field = names.free(JavaNames.small(JavaNames.camel(state, "State")) + "Function");
        functions.put(field, named(function, "elsewhere").functions(converter, state, function));
        artifacts.add("evoloop-payload");
        return field;
    }

    /** An action that {@code section} describes, as a statement. */
    String outside(Section section, String told, String values) {
        String what;
        String action;
        if (isRun(section, "to")) {
            List<Node.Text> run = section.texts("run");
            artifacts.add(LINES);
            helpers.add("device/program.txt");
            what = "run " + (run.isEmpty() ? "" : run.get(0));
            action = "connections.program("
                    + duration(section.duration("within").orElse(LIMIT_OF_PROGRAMS)) + ", "
                    + run.stream().map(text -> literal(text.value())).collect(Collectors.joining(", ")) + ").run("
                    + values + ")";
        } else {
            WrittenConnection to = named(section, "to");
            what = "to " + to.name();
            action = to.outside(section, values);
            if (to instanceof WrittenMqtt) {
                helpers.add("device/publish.txt");
            }
        }
        return "connections.outside(" + literal(what) + ", " + told + ", () -> " + action + ");\n";
    }

    Set<String> artifacts() {
        return artifacts;
    }

    /** What the class {@code Connections} takes; asked for last, since an action may add to it. */
    Map<String, String> values() {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("fields", join(WrittenConnection::field) + functions("    final RemoteFunction %s;\n"));
        values.put(
                "constructor", join(WrittenConnection::creation) + functions("        %s = new RemoteFunction(%s);\n"));
        // The one that confirms is there before what it confirms.
        String adding = Stream.concat(Stream.ofNullable(confirming), byName.values().stream())
                .distinct()
                .map(WrittenConnection::adding)
                .collect(Collectors.joining());
        if (!commands.isEmpty()) {
            String run = "new RunExecute(\"RunExecute\", " + map(commands) + ")";
            adding += confirming == null
                    ? "        converter.addExecute(" + run + ");\n"
                    : "        " + confirming.executeVariable() + ".through(" + run + ");\n";
        }
        values.put("adding", adding);
        values.put("methods", helpers.stream().map(Template::text).collect(Collectors.joining()));
        return values;
    }

    private String functions(String line) {
        return functions.entrySet().stream()
                .map(each -> String.format(line, each.getKey(), each.getValue()))
                .collect(Collectors.joining());
    }

    private String join(Function<WrittenConnection, String> part) {
        return byName.values().stream().map(part).collect(Collectors.joining());
    }

    /** What a file holds that {@code section} names; it is read where it is. */
    static String secret(Section section, Node.Text file) {
        Path named = section.problems()
                .file()
                .toAbsolutePath()
                .resolveSibling(file.value())
                .normalize();
        return "Secret.read(Path.of(" + literal(named.toString()) + "))";
    }

    /** {@code Map.ofEntries(...)} in the order given. */
    static String map(Map<String, String> expressions) {
        return expressions.entrySet().stream()
                .map(entry -> "\n                        Map.entry(" + literal(entry.getKey()) + ", " + entry.getValue()
                        + ")")
                .collect(Collectors.joining(",", "Map.ofEntries(", ")"));
    }

    static String list(List<Node.Text> texts) {
        return texts.stream().map(text -> literal(text.value())).collect(Collectors.joining(", ", "List.of(", ")"));
    }

    static String duration(Duration time) {
        return time.toMillis() % 1000 == 0
                ? "Duration.ofSeconds(" + time.toSeconds() + ")"
                : "Duration.ofMillis(" + time.toMillis() + ")";
    }

    /** The limit {@code within} of a section. */
    static String within(Section section) {
        return duration(section.duration("within").orElse(USUAL_LIMIT));
    }

    /** The meanings of a rule, as an expression. */
    static String meanings(Section rule, String one) {
        String part = rule.text("json")
                .map(pointer -> ".at(" + literal(pointer.value()) + ")")
                .orElse("");
        List<String> with = new ArrayList<>();
        rule.pairs("values")
                .forEach((text, name) -> with.add(with("exactly(" + literal(text.value()) + ")", part, name)));
        rule.pairs("ranges").forEach((name, range) -> with.add(with(between(range.value()), part, name)));
        rule.text("pattern")
                .ifPresent(pattern -> with.add(with(
                        "matching(Pattern.compile(" + literal(pattern.value()) + "))",
                        part,
                        rule.text(one).orElseThrow())));
        String lasting = rule.period("steady")
                .map(time -> "\n                        .lasting(" + duration(time) + ")")
                .orElse("");
        return "Meanings.NONE" + String.join("", with) + lasting;
    }

    private static String with(String match, String part, Node.Text name) {
        return "\n                        .with(Match." + match + part + ", " + literal(name.value()) + ")";
    }

    private static String between(String range) {
        int dots = range.indexOf("..");
        String from = range.substring(0, dots);
        String to = range.substring(dots + 2);
        return "between(" + (from.isEmpty() ? "Double.NEGATIVE_INFINITY" : Double.parseDouble(from)) + ", "
                + (to.isEmpty() ? "Double.POSITIVE_INFINITY" : Double.parseDouble(to)) + ")";
    }

    /** The part of a message that a rule is about, as an expression. */
    static String part(Section rule) {
        return rule.text("json")
                .map(pointer -> "Part.at(" + literal(pointer.value()) + ")")
                .orElse("Part.WHOLE");
    }

    static String unit(Section rule) {
        return literal(rule.text("unit").map(Node.Text::value).orElse(""));
    }
}
