package org.evoloop.migration;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * Reads a mapping, one rule per line:
 *
 * <pre>
 * # Fading was renamed to Muting
 * state Fading -> Muting
 * device Standby -> Off
 * timer tm(2s) of Fading -> tm(3s)
 * timer tm(2s) of Fading restarts
 * function of Fading restarts
 * function of Fading goes on
 * </pre>
 *
 * <p>Threading: not thread-safe.
 */
final class MappingText {
    private static final Pattern MOVED = Pattern.compile("(state|device)\\s+(.+?)\\s*->\\s*(.+)");
    private static final Pattern TIMER =
            Pattern.compile("timer\\s+(.+?)\\s+of\\s+(.+?)\\s*(?:->\\s*(.+)|\\s(restarts))");
    private static final Pattern FUNCTION = Pattern.compile("function\\s+of\\s+(.+?)\\s+(restarts|goes\\s+on)");
    private static final String FORMS =
            "'state A -> B', 'device A -> B', 'timer T of A -> T', 'timer T of A restarts', "
                    + "'function of A restarts' or 'function of A goes on'";

    private final ModelPair running;
    private final ModelPair next;
    private Mapping mapping = Mapping.byName();

    private MappingText(ModelPair running, ModelPair next) {
        this.running = running;
        this.next = next;
    }

    /** As {@link Mapping#parse}. */
    static Mapping parse(String file, String text, ModelPair running, ModelPair next) {
        MappingText reader = new MappingText(running, next);
        List<String> problems = new ArrayList<>();
        List<String> lines = text.lines().toList();
        for (int index = 0; index < lines.size(); index++) {
            String line = lines.get(index).strip();
            try {
                if (!line.isEmpty() && !line.startsWith("#")) {
                    reader.read(line);
                }
            } catch (ModelException problem) {
                problems.add(file + ", line " + (index + 1) + ": " + problem.getMessage());
            }
        }
        if (!problems.isEmpty()) {
            throw new ModelException(String.join("\n", problems));
        }
        return reader.mapping;
    }

    private void read(String line) {
        Matcher moved = MOVED.matcher(line);
        Matcher timer = TIMER.matcher(line);
        Matcher function = FUNCTION.matcher(line);
        if (moved.matches()) {
            move(moved.group(1).equals("device"), moved.group(2), moved.group(3));
        } else if (timer.matches()) {
            time(timer.group(1), timer.group(2), Optional.ofNullable(timer.group(3)));
        } else if (function.matches()) {
            State state = state(running.evolved(), "running new", function.group(1));
            if (!running.isNew(state)) {
                throw new ModelException(
                        "the device has " + state + " itself, which needs no function; leave the line out");
            }
            mapping = mapping.withFunction(state, function.group(2).startsWith("goes"));
        } else {
            throw new ModelException("'" + line + "' is no rule; write " + FORMS);
        }
    }

    private void move(boolean device, String from, String to) {
        if (device) {
            State state = state(running.original(), "running original", from);
            State becomes = state(next.original(), "next original", to);
            once(mapping.device().get(state), state);
            mapping = mapping.withDeviceState(state, becomes);
        } else {
            State state = state(running.evolved(), "running new", from);
            State becomes = state(next.evolved(), "next new", to);
            once(mapping.states().get(state), state);
            mapping = mapping.withState(state, becomes);
        }
    }

    private static void once(@Nullable State before, State state) {
        if (before != null) {
            throw new ModelException(state + " has been mapped to " + before + " already; keep one of the lines");
        }
    }

    private void time(String name, String of, Optional<String> becomes) {
        State state = state(running.evolved(), "running new", of);
        Mapping.TimerOf timer =
                new Mapping.TimerOf(state, known(name, timers(running.evolved(), state), "timer of " + state));
        if (becomes.isEmpty()) {
            mapping = mapping.withRestarted(timer);
            return;
        }
        State there = mapping.states().getOrDefault(state, state);
        mapping = mapping.withTimer(
                timer, known(becomes.get(), timers(next.evolved(), there), "timer of " + there + " in the next model"));
    }

    /** The timers of all states that differ from this one only in the history that they remember. */
    private static List<String> timers(StateMachine machine, State plain) {
        return machine.states().stream()
                .filter(state -> machine.withoutMemory(state).equals(plain))
                .flatMap(state -> machine.timers(state).keySet().stream())
                .map(Event::name)
                .distinct()
                .toList();
    }

    /** The state of that name, without remembered history. */
    private static State state(StateMachine machine, String model, String name) {
        Stream<String> names = machine.states().stream()
                .map(state -> machine.withoutMemory(state).name());
        return new State(known(name, names.distinct().toList(), "state of the " + model + " model"));
    }

    private static String known(String name, Collection<String> names, String what) {
        if (!names.contains(name)) {
            String there = names.stream().sorted().collect(Collectors.joining(", "));
            throw new ModelException(
                    "'" + name + "' is no " + what + "; there " + (names.isEmpty() ? "is none" : "are " + there));
        }
        return name;
    }
}
