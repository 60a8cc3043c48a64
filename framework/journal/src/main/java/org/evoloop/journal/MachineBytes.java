package org.evoloop.journal;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.engine.codec.ByteItems;
import org.evoloop.engine.codec.ByteWriter;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;

/** State machines in the head of a segment, so that a journal can be read without its model files. */
final class MachineBytes {
    /** What a state has; the numbers are in the file. */
    private static final int END = 1;

    private static final int DEVICE = 2;
    private static final int SENDS = 4;
    private static final int INHERITED = 8;

    private MachineBytes() {}

    static void write(ByteWriter bytes, StateMachine machine) {
        bytes.text(machine.name());
        bytes.number(machine.states().size());
        for (State state : machine.states()) {
            bytes.name(state.name());
            bytes.name(machine.withoutMemory(state).name());
            bytes.names(machine.activities(state));
            bytes.names(machine.paths(state));
            String device = machine.deviceState(state);
            List<String> sends = machine.sends(state).stream().map(Event::name).toList();
            bytes.octet((machine.isEnd(state) ? END : 0)
                    | (device == null ? 0 : DEVICE)
                    | (machine.inheritsDeviceState(state) ? INHERITED : 0)
                    | (sends.isEmpty() ? 0 : SENDS));
            if (device != null) {
                bytes.name(device);
            }
            if (!sends.isEmpty()) {
                bytes.names(sends);
            }
            bytes.number(machine.deferred(state).size());
            machine.deferred(state).forEach(event -> event(bytes, event));
        }
        bytes.name(machine.initial().name());
        bytes.names(machine.initialEffects());
        bytes.names(machine.spontaneous().stream().map(Event::name).toList());
        bytes.names(machine.urgent().stream().map(Event::name).toList());
        bytes.number(machine.transitions().size());
        for (Transition transition : machine.transitions()) {
            bytes.name(transition.source().name());
            event(bytes, transition.event());
            bytes.name(transition.target().name());
            bytes.names(transition.effects());
            bytes.truth(transition.internal());
            bytes.names(transition.keeps());
        }
    }

    private static void event(ByteWriter bytes, Event event) {
        bytes.name(event.name());
        bytes.names(event.guards());
    }

    static StateMachine read(ByteItems cursor) {
        StateMachineBuilder builder = StateMachine.named(cursor.text());
        for (int left = cursor.count(); left > 0; left--) {
            State state = new State(cursor.name());
            State withoutMemory = new State(cursor.name());
            List<String> activities = cursor.names();
            List<String> paths = cursor.names();
            int traits = cursor.octet();
            builder.drawn(state, withoutMemory, activities, paths, (traits & END) != 0);
            if ((traits & DEVICE) != 0 && (traits & INHERITED) != 0) {
                builder.inheritedDeviceState(state.name(), cursor.name());
            } else if ((traits & DEVICE) != 0) {
                builder.deviceState(state.name(), cursor.name());
            }
            if ((traits & SENDS) != 0) {
                cursor.names().forEach(event -> builder.sends(state.name(), event));
            }
            for (int deferred = cursor.count(); deferred > 0; deferred--) {
                builder.defers(state.name(), event(cursor));
            }
        }
        builder.initial(cursor.name());
        builder.initialEffects(cursor.names());
        cursor.names().forEach(name -> builder.spontaneous(new Event(name)));
        cursor.names().forEach(name -> builder.urgent(new Event(name)));
        List<Transition> transitions = new ArrayList<>();
        for (int left = cursor.count(); left > 0; left--) {
            transitions.add(transition(cursor));
        }
        transitions.forEach(transition -> builder.transition(transition, ""));
        return builder.build();
    }

    private static Transition transition(ByteItems cursor) {
        State source = new State(cursor.name());
        Event event = event(cursor);
        State target = new State(cursor.name());
        List<String> effects = cursor.names();
        boolean internal = cursor.truth();
        Set<String> keeps = new LinkedHashSet<>(cursor.names());
        return new Transition(source, event, target, effects, internal, keeps);
    }

    private static Event event(ByteItems cursor) {
        String name = cursor.name();
        return new Event(name, cursor.names());
    }
}
