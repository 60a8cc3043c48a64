package org.evoloop;

import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;

/**
 * Machines as tests write them: the initial state is the source of the first line; a line is {@code Off press [hot] -> On /
 * beep, blink}, with {@code =>} in place of the arrow for an internal transition, or the name of a state or, with a {@code
 * !}, of an event.
 */
public final class Machines {
    private static final Pattern LINE =
            Pattern.compile("(\\S+) ([^\\[/]+?)((?: \\[[^]]+])*) ([-=])> (\\S+)(?: / (.*))?");

    private Machines() {}

    public static StateMachine machine(String name, String... lines) {
        StateMachineBuilder builder = StateMachine.named(name).initial(lines[0].split(" ", 2)[0]);
        for (String line : lines) {
            Matcher transition = LINE.matcher(line);
            if (transition.matches()) {
                builder.transition(transition(transition), "");
            } else if (line.startsWith("!")) {
                builder.event(line.substring(1));
            } else {
                builder.state(line);
            }
        }
        return builder.build();
    }

    private static Transition transition(Matcher line) {
        List<String> guards = Pattern.compile("\\[([^]]+)]")
                .matcher(line.group(3))
                .results()
                .map(guard -> guard.group(1))
                .toList();
        List<String> effects =
                line.group(6) == null ? List.of() : Arrays.asList(line.group(6).split(", "));
        return new Transition(
                new State(line.group(1)),
                new Event(line.group(2), guards),
                new State(line.group(5)),
                effects,
                line.group(4).equals("="));
    }
}
