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
import java.util.stream.Collectors;
import org.evoloop.device.DeviceFile;
import org.evoloop.device.DeviceProgram;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Problems;
import org.evoloop.device.file.Section;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * A device file in Java: what the generated classes take.
 *
 * <p>Threading: one thread.
 */
public final class WrittenFile {
    private static final List<String> STEPS = List.of("on-enter", "steps");
    private static final Set<String> OF_THE_DAY = Set.of("schedule", "quiet");

    private final DeviceFile file;
    private final Section root;
    private final WrittenConnections connections;

    private WrittenFile(DeviceFile file, Section root) {
        this.file = file;
        this.root = root;
        this.connections = new WrittenConnections(root);
    }

    /**
     * Reads a file.
     *
     * @throws org.evoloop.device.file.DeviceFileException with all mistakes, and all that cannot be turned into Java
     */
    public static WrittenFile read(Path path) {
        DeviceFile file = DeviceFile.read(path, DeviceProgram.options());
        Problems problems = new Problems(path);
        Section root = Section.read(path, problems);
        if (file.references().isEmpty()) {
            problems.at(
                    root.node(), "a project needs models, and this file has none; draw or learn them, and name them");
        }
        file.options()
                .forEach(option -> problems.at(
                        option.line(),
                        "'" + option.name() + "' is an option, which a Java project takes on its command line, or from"
                                + " --config; remove it here"));
        root.keys().stream()
                .filter(key -> OF_THE_DAY.contains(key.value()))
                .forEach(key -> problems.at(
                        key,
                        "'" + key + "' is not written in Java; leave it out, and add a TimetableMonitor, or an"
                                + " EventAnalyze, to the project"));
        WrittenFile written = new WrittenFile(file, root);
        problems.throwIfAny();
        return written;
    }

    /** What was read. */
    public DeviceFile file() {
        return file;
    }

    /** The events between converter and device. */
    public DeviceEvents events() {
        return new DeviceEvents(file.sent().stream().map(Event::new).collect(Collectors.toSet()), file.devicesOwn());
    }

    Set<String> artifacts() {
        return connections.artifacts();
    }

    Map<String, String> connections() {
        return connections.values();
    }

    /** The states with functions of the file, with what the generated class of each contains. */
    Map<String, Map<String, String>> functions() {
        Map<String, Map<String, String>> functions = new LinkedHashMap<>();
        root.named("functions").forEach((state, function) -> {
            if (!function.has("elsewhere")) {
                functions.put(state.value(), function(function));
            }
        });
        return functions;
    }

    /** The states whose functions run in other programs, with the field that is each function. */
    Map<String, String> functionsElsewhere() {
        Map<String, String> functions = new LinkedHashMap<>();
        root.named("functions").forEach((state, function) -> {
            if (function.has("elsewhere")) {
                functions.put(state.value(), connections.function(file.name(), state.value(), function));
            }
        });
        return functions;
    }

    /** The new states that only need the device in a state. */
    List<String> withoutFunction() {
        ModelPair pair = file.models();
        Set<State> named = root.named("functions").keySet().stream()
                .flatMap(name -> pair.evolved().alike(new State(name.value())).stream())
                .collect(Collectors.toSet());
        return pair.evolved().states().stream()
                .filter(state ->
                        pair.isNew(state) && !pair.whereDeviceMustBe(state).isEmpty() && !named.contains(state))
                .map(State::name)
                .toList();
    }

    private Map<String, String> function(Section section) {
        StringBuilder body = new StringBuilder();
        String constants = "";
        String methods = "";
        List<Section> last = section.listed("on-exit");
        if (!last.isEmpty()) {
            body.append("        visit.onEnd(() -> {\n");
            for (Section action : last) {
                body.append("            Actions.last(() -> ")
                        .append(connections
                                .outside(action, "told -> {}", "Values.NONE")
                                .replaceFirst(";\n$", ""))
                        .append(");\n");
            }
            body.append("        });\n");
        }
        for (Section at : section.listed("at")) {
            body.append("        visit.daily(LocalTime.parse(")
                    .append(literal(at.need("time").orElseThrow().value()))
                    .append("), ")
                    .append(task(List.of(at), "        "))
                    .append(");\n");
        }
        if (section.has("every")) {
            body.append("        visit.after(PERIOD, () -> repeat(visit));\n");
            constants = "    private static final Duration PERIOD = "
                    + WrittenConnections.duration(section.period("every").orElseThrow()) + ";\n\n";
            methods = Template.fill("device/repeat.txt", Map.of("task", task(List.of(section), "        ")));
        }
        List<Section> steps = new ArrayList<>();
        STEPS.forEach(key -> steps.addAll(section.listed(key)));
        if (!steps.isEmpty()) {
            body.append("        ").append(task(steps, "        ")).append(".run();\n");
        }
        return Map.of("constants", constants, "body", body.toString(), "functionMethods", methods);
    }

    /** These actions as a task; those after a wait are in a task of their own. */
    private String task(List<Section> actions, String indent) {
        String inner = indent + "    ";
        StringBuilder task = new StringBuilder("Actions.in(visit, () -> {\n");
        for (int i = 0; i < actions.size(); i++) {
            Section action = actions.get(i);
            task.append(inner);
            if (action.has("wait")) {
                Duration time = action.duration("wait").orElseThrow();
                task.append("visit.after(")
                        .append(WrittenConnections.duration(time))
                        .append(", ");
                task.append(task(actions.subList(i + 1, actions.size()), inner)).append(");\n");
                break;
            }
            task.append(statement(action));
        }
        return task.append(indent).append("})").toString();
    }

    private String statement(Section action) {
        for (String verb : List.of("send", "raise", "finish", "say")) {
            if (action.has(verb)) {
                return "visit." + verb + "("
                        + literal(action.need(verb).orElseThrow().value()) + ");\n";
            }
        }
        return connections.outside(action, "visit::say", "Values.NONE");
    }

    /** The events that a function sends to the device. */
    private static Set<String> sends(Section function) {
        if (function.has("elsewhere")) {
            return function.texts("sends").stream()
                    .map(Node.Text::value)
                    .collect(Collectors.toCollection(LinkedHashSet::new));
        }
        List<Section> actions = new ArrayList<>(List.of(function));
        STEPS.forEach(key -> actions.addAll(function.listed(key)));
        actions.addAll(function.listed("at"));
        return actions.stream()
                .flatMap(action -> action.texts("send").stream())
                .map(Node.Text::value)
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    /** The lines that register everything but functions. */
    String registrations() {
        StringBuilder lines = new StringBuilder();
        root.named("functions")
                .forEach((state, function) -> sends(function)
                        .forEach(
                                event -> line(lines, "sends(" + literal(state.value()) + ", " + literal(event) + ")")));
        root.named("guards")
                .forEach((text, guard) -> line(lines, "guard(" + literal(text.value()) + ", " + guard(guard) + ")"));
        root.named("effects")
                .forEach((text, effect) -> line(
                        lines,
                        "effect(" + literal(text.value()) + ", values -> "
                                + connections
                                        .outside(effect, "System.out::println", "values")
                                        .replaceFirst(";\n$", "")
                                + ")"));
        root.section("device").ifPresent(device -> {
            device.section("send")
                    .ifPresent(send -> send.keys().stream()
                            .filter(event -> send.any(event.value()).orElseThrow() instanceof Node.Entries)
                            .forEach(event -> send.section(event.value())
                                    .flatMap(how -> how.text("cost"))
                                    .ifPresent(cost ->
                                            line(lines, "cost(" + literal(event.value()) + ", " + cost + ")"))));
            device.texts("do-not-pass").forEach(state -> line(lines, "doNotPass(" + literal(state.value()) + ")"));
        });
        return lines.toString();
    }

    private static void line(StringBuilder lines, String call) {
        lines.append("        ").append(call).append(";\n");
    }

    private static String guard(Section guard) {
        if (guard.has("between")) {
            return guard.texts("between").stream()
                    .map(time -> literal(time.value()))
                    .collect(Collectors.joining(", ", "() -> conditions.isBetween(", ")"));
        }
        String range = ", "
                + guard.text("above")
                        .map(Node.Text::value)
                        .map(Double::valueOf)
                        .map(String::valueOf)
                        .orElse("Double.NEGATIVE_INFINITY")
                + ", "
                + guard.text("below")
                        .map(Node.Text::value)
                        .map(Double::valueOf)
                        .map(String::valueOf)
                        .orElse("Double.POSITIVE_INFINITY")
                + ")";
        return guard.has("reading")
                ? "() -> conditions.reads("
                        + literal(guard.need("reading").orElseThrow().value()) + range
                : "values -> Conditions.carries(values, "
                        + literal(guard.need("value").orElseThrow().value()) + range;
    }

    /** The scenarios as test methods. */
    String tests() {
        JavaNames names = new JavaNames();
        List.of("close", "reads", "until", "aConverterCanBeBuilt").forEach(names::reserve);
        StringBuilder tests = new StringBuilder();
        root.section("scenarios")
                .ifPresent(all -> all.keys().forEach(name -> {
                    if (all.listed(name.value()).stream().anyMatch(step -> step.has("command"))) {
                        // The project does not have the entities of Home Assistant.
                        return;
                    }
                    String method = names.free(JavaNames.small(JavaNames.camel(name.value(), "Scenario")));
                    tests.append("\n    @Test\n    @DisplayName(").append(literal(name.value()));
                    tests.append(")\n    void ").append(method).append("() {\n");
                    all.listed(name.value()).forEach(step -> tests.append(step(step)));
                    tests.append("    }\n");
                }));
        return tests.toString();
    }

    /** In the order in which a step of a scenario does what it says. */
    private static String step(Section step) {
        StringBuilder lines = new StringBuilder();
        step.pairs("readings")
                .forEach((name, value) ->
                        line(lines, "reads(" + literal(name.value()) + ", " + Double.valueOf(value.value()) + ")"));
        call(lines, step, "until", "until");
        call(lines, step, "press", "converter.press");
        call(lines, step, "device", "converter.deviceDoes");
        step.duration("after")
                .ifPresent(time -> line(lines, "converter.advance(" + WrittenConnections.duration(time) + ")"));
        if (step.has("sent")) {
            line(
                    lines,
                    step.texts("sent").stream()
                            .map(event -> literal(event.value()))
                            .collect(Collectors.joining(", ", "assertSent(", ")")));
        }
        call(lines, step, "state", "assertState");
        call(lines, step, "device-state", "assertDeviceState");
        return lines.toString();
    }

    private static void call(StringBuilder lines, Section step, String key, String method) {
        step.text(key).ifPresent(text -> line(lines, method + "(" + literal(text.value()) + ")"));
    }
}
