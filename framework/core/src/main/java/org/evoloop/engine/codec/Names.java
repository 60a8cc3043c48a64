package org.evoloop.engine.codec;

import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** Looks up the model elements named by the next items. */
final class Names {
    private final ModelPair models;
    private final Items items;
    private final boolean strict;

    /** @param strict whether a state must be in the models */
    Names(ModelPair models, Items items, boolean strict) {
        this.strict = strict;
        this.models = models;
        this.items = items;
    }

    State originalState() {
        return state(models.original());
    }

    State evolvedState() {
        return state(models.evolved());
    }

    private State state(StateMachine model) {
        String name = items.name();
        State state;
        try {
            state = new State(name);
        } catch (ModelException e) {
            throw items.damaged(String.valueOf(e.getMessage()));
        }
        if (strict && !model.hasState(state)) {
            throw gone(model, "has no state '" + name + "'");
        }
        return state;
    }

    private CodecException gone(StateMachine model, String what) {
        return items.wrong(
                "the model '" + model.name() + "' " + what,
                "use the models with which it was written, or start without it");
    }

    Transition originalTransition() {
        return transition(models.original());
    }

    Transition evolvedTransition() {
        return transition(models.evolved());
    }

    private Transition transition(StateMachine model) {
        State source = state(model);
        Event event = event();
        State target = state(model);
        Transition known = model.transition(source, event).orElse(null);
        if (known == null || !known.target().equals(target)) {
            throw gone(model, "has no transition " + source + " --" + event + "--> " + target);
        }
        return known;
    }

    Event event() {
        String name = items.name();
        try {
            return new Event(name, items.names());
        } catch (ModelException e) {
            throw items.damaged(String.valueOf(e.getMessage()));
        }
    }
}
