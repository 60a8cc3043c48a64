package org.evoloop.roomba;

import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;

/** Knows the models of the cleaning robot and the functions of its new states (paper, section VI.A). */
final class KnowledgeState extends StateKnowledge {
    private final NewFunction move;
    private final NewFunction spotWait;

    KnowledgeState(ModelPair pair, NewFunction move, NewFunction spotWait) {
        super(pair);
        this.move = move;
        this.spotWait = spotWait;
    }

    @Override
    protected void registerNewFunctions() {
        function(RobotEvents.STATE_MOVE, move);
        function(RobotEvents.STATE_SPOT_WAIT, spotWait);
    }
}
