package org.evoloop.device;

import java.time.Duration;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.function.NewFunction;
import org.jspecify.annotations.Nullable;

/** Reads what functions and effects of a device file do. */
final class FunctionReader {
    private static final List<String> ACTIONS = List.of("send", "raise", "finish", "wait", "say", "run", "to");

    /** What connections send. */
    private static final List<String> OUTWARD = List.of("line", "payload", "call", "pulse", "hold");

    private final FileModels models;
    private final Connections connections;
    private final DaySection day;

    FunctionReader(FileModels models, Connections connections, DaySection day) {
        this.models = models;
        this.connections = connections;
        this.day = day;
    }

    /** The function of {@code state}; empty if it cannot be used, which is noted. */
    Optional<FileKnowledge.Function> function(Node.Text state, Section section) {
        Optional<FileKnowledge.Function> function = section.has("elsewhere")
                ? elsewhere(state, section)
                : section.has(DaySection.WAITING)
                        ? day.waiting(section, event -> models.raisedIn(state, event))
                        : Optional.of(actions(state, section))
                                .map(actions -> new FileKnowledge.Function(actions, actions.sends()));
        section.done();
        return function;
    }

    /** A function of a connection: {@code elsewhere: CONNECTION}. */
    private Optional<FileKnowledge.Function> elsewhere(Node.Text state, Section section) {
        Set<String> sends = new LinkedHashSet<>();
        section.texts("sends").forEach(event -> sends.add(models.functionSends(event)));
        section.texts("raises").forEach(event -> models.raisedIn(state, event));
        Connection connection = connections.named(section, "elsewhere");
        NewFunction runs = connection == null ? null : connection.function(state, section);
        return connection == null || runs == null
                ? Optional.empty()
                : Optional.of(new FileKnowledge.Function(new PlayableFunction(connection, runs), sends));
    }

    /** What the file itself says. */
    private FileFunction actions(Node.Text state, Section section) {
        List<Action> steps = new ArrayList<>(actions(state, section, "on-enter"));
        steps.addAll(actions(state, section, "steps"));
        Duration period = section.period("every").orElse(null);
        List<Action> repeated = new ArrayList<>();
        Map<LocalTime, List<Action>> daily = new LinkedHashMap<>();
        for (Section at : section.listed("at")) {
            at.require("time");
            LocalTime time = at.value("time", Section::timeOfDay).orElse(null);
            Action action = action(state, at);
            at.done();
            if (time != null && action != null) {
                daily.computeIfAbsent(time, first -> new ArrayList<>()).add(action);
            }
        }
        if (section.has("every")) {
            Action action = action(state, section);
            if (action != null) {
                repeated.add(action);
            }
        }
        List<Action.Do> onExit = new ArrayList<>();
        for (Section each : section.listed("on-exit")) {
            Action action = action(state, each);
            each.done();
            if (action instanceof Action.Do outside) {
                onExit.add(outside);
            } else if (action != null) {
                each.problem(
                        "when a state has been left, its function can only act outside: to a connection, or run a program");
            }
        }
        return new FileFunction(steps, period, repeated, daily, onExit);
    }

    private List<Action> actions(Node.Text state, Section section, String key) {
        List<Action> actions = new ArrayList<>();
        for (Section each : section.listed(key)) {
            Action action = action(state, each);
            each.done();
            if (action != null) {
                actions.add(action);
            }
        }
        return actions;
    }

    /**
     * The action in {@code section}, which may have other keys, too.
     *
     * @param state whose function it belongs to
     */
    private @Nullable Action action(Node.Text state, Section section) {
        // Where there is one connection, what is sent over it says enough.
        boolean isSaid =
                OUTWARD.stream().anyMatch(section::has) && ACTIONS.stream().noneMatch(section::has);
        String kind = isSaid ? "to" : section.oneOf(ACTIONS).orElse(null);
        if (kind == null) {
            return null;
        }
        return switch (kind) {
            case "send" ->
                section.text("send")
                        .map(event -> new Action.Send(models.functionSends(event)))
                        .orElse(null);
            case "raise" ->
                section.text("raise")
                        .map(event -> new Action.Raise(models.raisedIn(state, event)))
                        .orElse(null);
            case "finish" ->
                section.text("finish")
                        .map(event -> new Action.Finish(models.raisedIn(state, event)))
                        .orElse(null);
            case "wait" -> section.duration("wait").map(Action.Wait::new).orElse(null);
            case "say" ->
                section.text("say").map(text -> new Action.Say(text.value())).orElse(null);
            default -> outward(section);
        };
    }

    /** For messages: {@code to panel: LED ON}; without what may be secret, as a program's arguments. */
    private static String what(Connection connection, Section section) {
        if (section.has("run")) {
            return "run "
                    + section.texts("run").stream()
                            .map(Node.Text::value)
                            .findFirst()
                            .orElse("");
        }
        String more = section.node().entries().entrySet().stream()
                .filter(each -> !List.of("to", "every", "time", "within", "body")
                        .contains(each.getKey().value()))
                .map(Map.Entry::getValue)
                .filter(Node.Text.class::isInstance)
                .map(text -> text.toString().replaceFirst("^([A-Z]+ /[^?]*)\\?.*", "$1"))
                .collect(Collectors.joining(" "));
        return "to " + connection.name() + ": " + more;
    }

    /** What is done outside of the converter: {@code to: CONNECTION}, and what that connection asks for. */
    Action.@Nullable Do outward(Section section) {
        Connection connection = connections.named(section, "to");
        Outward outward = connection == null ? null : connection.outward(section);
        return connection == null || outward == null
                ? null
                : new Action.Do(connection, what(connection, section), outward);
    }
}
