package org.evoloop.journal;

import java.util.HashMap;
import java.util.Map;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** The transitions that records name, each looked up once. */
interface Arcs {
    /** Those of the device's model. */
    Transition original(State source, Event event, State target);

    /** Those of the new model. */
    Transition evolved(State source, Event event, State target);

    /** Those of these models. */
    static Arcs of(ModelPair models) {
        return new Arcs() {
            @Override
            public Transition original(State source, Event event, State target) {
                return find(models.original(), source, event, target);
            }

            @Override
            public Transition evolved(State source, Event event, State target) {
                return find(models.evolved(), source, event, target);
            }
        };
    }

    private static Transition find(StateMachine model, State source, Event event, State target) {
        Transition found = model.transition(source, event).orElse(null);
        if (found == null || !found.target().equals(target)) {
            throw new Cursor.Senseless(
                    "the model '" + model.name() + "' has no transition " + source + " --" + event + "--> " + target);
        }
        return found;
    }

    /** Those that are named, whatever the models are: for reading without them. */
    static Arcs asNamed() {
        Map<Transition, Transition> known = new HashMap<>();
        return new Arcs() {
            @Override
            public Transition original(State source, Event event, State target) {
                return known.computeIfAbsent(new Transition(source, event, target), arc -> arc);
            }

            @Override
            public Transition evolved(State source, Event event, State target) {
                return original(source, event, target);
            }
        };
    }
}
