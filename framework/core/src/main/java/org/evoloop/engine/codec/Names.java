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

    Names(ModelPair models, Items items) {
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
        String name = items.text();
        for (State state : model.states()) {
            if (state.name().equals(name)) {
                return state;
            }
        }
        throw gone(model, "has no state '" + name + "'");
    }

    private SnapshotException gone(StateMachine model, String what) {
        return items.wrong("the model '" + model.name() + "' " + what
                + "; use the models with which it was written, or start without it");
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
        String name = items.text();
        try {
            return new Event(name, items.texts());
        } catch (ModelException e) {
            throw items.damaged(String.valueOf(e.getMessage()));
        }
    }
}
