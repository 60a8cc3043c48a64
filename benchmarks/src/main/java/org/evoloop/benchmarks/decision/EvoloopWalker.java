package org.evoloop.benchmarks.decision;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;

/** The decision table of a pair whose new model is the walk's machine. */
final class EvoloopWalker extends Walker {
    private final DecisionTable table;
    private int situation;

    EvoloopWalker(Walk walk) {
        table = table(walk);
        situation = table.initial();
        if (walk.states().contains("Off")) {
            fire("Clean");
        }
    }

    static DecisionTable table(Walk walk) {
        StateMachine evolved = machine(walk, walk.moves());
        List<Walk.Move> own = walk.moves().stream()
                .filter(move -> !List.of("Move", "SpotWait").contains(move.source()))
                .filter(move -> !List.of("Move", "SpotWait").contains(move.target()))
                .toList();
        StateMachine original = machine(walk, own);
        Set<Event> sendable = new HashSet<>(original.events());
        Event ended = new Event("endSpot");
        sendable.remove(ended);
        return DecisionTable.compile(new ModelPair(original, evolved), new DeviceEvents(sendable, Set.of(ended)));
    }

    private static StateMachine machine(Walk walk, List<Walk.Move> moves) {
        StateMachineBuilder builder =
                StateMachine.named("walk").initial(walk.states().get(0));
        moves.forEach(move -> builder.transition(move.source(), move.event(), move.target()));
        if (walk.states().contains("Off") && moves.size() < walk.moves().size()) {
            // Transitions of the device that the new model removes.
            builder.transition("On", "Spot", "Spot").transition("Clean", "Clean", "On");
        }
        return builder.build();
    }

    @Override
    void fire(String event) {
        Decision decision = table.decide(situation, event);
        if (!(decision instanceof Decision.NotAcceptable)) {
            situation = table.after(situation, event);
            act();
        }
    }
}
