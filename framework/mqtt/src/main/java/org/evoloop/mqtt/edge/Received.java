package org.evoloop.mqtt.edge;

import java.util.Map;
import org.evoloop.converter.edge.EdgeShell;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * A record of schema 1 from the gateway. Unknown members are ignored.
 *
 * <p>Errors: a missing member that is needed, or a member of the wrong kind, is an {@link IllegalArgumentException}.
 *
 * <p>Threading: immutable.
 */
final class Received {
    /** Whole doubles of a smaller magnitude fit in a long. */
    private static final double MOST_WHOLE = 0x1p63;

    private final Map<String, @Nullable Object> members;

    Received(String payload) {
        members = Json.object(payload);
        if (number("schema", 1) != 1) {
            throw new IllegalArgumentException("its schema is " + number("schema", 1) + "; update this program");
        }
    }

    long number(String name, long otherwise) {
        if (!members.containsKey(name)) {
            return otherwise;
        } else if (members.get(name) instanceof Double number
                && number == Math.rint(number)
                && Math.abs(number) < MOST_WHOLE) {
            return number.longValue();
        }
        throw new IllegalArgumentException("'" + name + "' must be a whole number");
    }

    boolean truth(String name) {
        return Boolean.TRUE.equals(members.get(name));
    }

    String text(String name) {
        if (members.get(name) instanceof String text) {
            return text;
        }
        throw new IllegalArgumentException("'" + name + "' must be a string");
    }

    private String text(String name, String otherwise) {
        return members.containsKey(name) ? text(name) : otherwise;
    }

    /** The step that the device is to take. */
    Step step() {
        Event event = new Event(text("event"));
        return new Step(new Transition(new State(text("from")), event, new State(text("to"))), event, false, false);
    }

    Values values() {
        Values values = Values.NONE;
        if (members.get("values") instanceof Map<?, ?> all) {
            for (Map.Entry<?, ?> each : all.entrySet()) {
                if (each.getValue() != null) {
                    values = values.with(String.valueOf(each.getKey()), each.getValue());
                }
            }
        }
        return values;
    }

    EdgeShell.Standing standing() {
        return new EdgeShell.Standing(
                new Configuration(new State(text("device")), new State(text("system"))),
                number("visit", 0),
                truth("settled"),
                truth("function"),
                text("from", ""),
                text("by", ""));
    }
}
