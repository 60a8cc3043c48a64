package org.evoloop.mqtt.edge;

import org.evoloop.converter.edge.EdgeShell;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.payload.JsonRecord;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/**
 * A record from the gateway. Unknown members are ignored.
 *
 * <p>Errors: a missing member that is needed, or a member of the wrong kind, is an {@link IllegalArgumentException}.
 *
 * <p>Threading: immutable.
 */
record Received(JsonRecord members) {
    Received(String payload) {
        this(JsonRecord.of(payload));
        long schema = members.number("schema", EdgeRecords.SCHEMA);
        if (schema != EdgeRecords.SCHEMA) {
            throw new IllegalArgumentException("its schema is " + schema + "; update this program");
        }
    }

    /** The step that the device is to take. */
    Step step() {
        Event event = new Event(members.text("event"));
        return new Step(
                new Transition(new State(members.text("from")), event, new State(members.text("to"))),
                event,
                false,
                false);
    }

    EdgeShell.Standing standing() {
        return new EdgeShell.Standing(
                new Configuration(new State(members.text("device")), new State(members.text("system"))),
                members.number("visit", 0),
                members.truth("settled"),
                members.truth("function"),
                members.text("from", ""),
                members.text("by", ""));
    }
}
