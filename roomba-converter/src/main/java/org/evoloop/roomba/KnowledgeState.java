package org.evoloop.roomba;

import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.State;

/** Knows the models of the cleaning robot and the functions of its new states (paper, section VI.A). */
final class KnowledgeState extends StateKnowledge {
    private final NewFunction move;
    private final NewFunction spotWait;

    KnowledgeState(ModelPair pair, NewFunction move, NewFunction spotWait) {
        super(pair);
        this.move = move;
        this.spotWait = spotWait;
    }

    /** A new model need not have both states. */
    @Override
    protected void registerNewFunctions() {
        register(RobotEvents.STATE_MOVE, move);
        register(RobotEvents.STATE_SPOT_WAIT, spotWait);
    }

    private void register(String name, NewFunction function) {
        State state = new State(name);
        if (models().evolved().hasState(state) && models().isNew(state)) {
            function(name, function);
        }
    }
}
