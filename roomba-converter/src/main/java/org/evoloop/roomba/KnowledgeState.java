package org.evoloop.roomba;

import java.util.Set;
import java.util.function.Function;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.function.NewFunction;
import org.evoloop.roomba.move.Move;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/** Knows the models of the cleaning robot and the functions of its new states (paper, section VI.A). */
final class KnowledgeState extends StateKnowledge {
    private final RobotModels models;
    private final Function<Move.Back, Move> move;
    private final Resumption resumption;
    private final NewFunction spotWait;
    private final NewFunction quietHours;
    private final Readiness readiness;

    /** @param move creates a Move with the events to raise when it ends before arrival */
    KnowledgeState(
            RobotModels models,
            RoombaSession session,
            Function<Move.Back, Move> move,
            Resumption resumption,
            NewFunction spotWait,
            NewFunction quietHours) {
        super(models.pair());
        this.models = models;
        this.move = move;
        this.resumption = resumption;
        this.spotWait = spotWait;
        this.quietHours = quietHours;
        this.readiness = new Readiness(session, this::device);
    }

    RobotModels robot() {
        return models;
    }

    @Override
    protected void registerNewFunctions() {
        models.functions().forEach((state, function) -> {
            switch (function) {
                case MOVE -> {
                    registerMove(state);
                    maySend(state, RobotEvents.CLEAN);
                    maySend(state, RobotEvents.UNDOCK);
                }
                case SPOT_WAIT -> function(state.name(), spotWait);
                case SPOT_CLEAN -> {
                    function(state.name(), spotClean());
                    maySend(state, RobotEvents.SPOT);
                }
                case CHARGE -> {
                    function(state.name(), charge());
                    maySend(state, RobotEvents.DOCK);
                }
                case QUIET_HOURS -> function(state.name(), quietHours);
                case NONE -> function(state.name(), NewFunction.none());
            }
        });
    }

    /** Models of others need not say what this program's functions send. In a device state nothing has to be sent. */
    private void maySend(State state, String event) {
        boolean isKnown = models().original().triggers().contains(new Event(event));
        if (isKnown && models().whereDeviceMustBe(state).isEmpty()) {
            sends(state.name(), event);
        }
    }

    private NewFunction spotClean() {
        return new RobotWork(this::device, "cleaning the spot", RobotEvents.SPOT, Set.of(RobotEvents.STATE_SPOT));
    }

    private NewFunction charge() {
        return new RobotWork(this::device, "charging first, then going on", RobotEvents.DOCK, RobotWork.DOCKING);
    }

    private State device() {
        return configuration().original();
    }

    /** Each transition into the state has its own way back. */
    private void registerMove(State state) {
        function(state.name(), moveFrom(state));
        for (Transition entry : models.entries(state)) {
            putTransition(
                    entry.source().name(),
                    state.name(),
                    moveFrom(models.before(entry)),
                    entry.event().toString());
        }
    }

    private NewFunction moveFrom(State before) {
        Move made = move.apply(activity -> models.wayBack(activity, before));
        return visit -> {
            if (resumption.isResumed()) {
                made.giveUp(visit, "the converter was stopped on the way");
            } else if (readiness.provide(visit)) {
                made.run(visit);
            }
        };
    }
}
