package org.evoloop.benchmarks.decision;

import org.squirrelframework.foundation.fsm.AnonymousAction;
import org.squirrelframework.foundation.fsm.StateMachineBuilderFactory;
import org.squirrelframework.foundation.fsm.UntypedStateMachine;
import org.squirrelframework.foundation.fsm.UntypedStateMachineBuilder;
import org.squirrelframework.foundation.fsm.annotation.StateMachineParameters;
import org.squirrelframework.foundation.fsm.impl.AbstractUntypedStateMachine;

/** squirrel-foundation 0.3.10. */
final class SquirrelWalker extends Walker {
    private final UntypedStateMachine machine;

    /** Created by the library through reflection. */
    @StateMachineParameters(stateType = String.class, eventType = String.class, contextType = Walker.class)
    public static class Machine extends AbstractUntypedStateMachine {}

    SquirrelWalker(Walk walk) {
        UntypedStateMachineBuilder builder = StateMachineBuilderFactory.create(Machine.class);
        for (Walk.Move move : walk.moves()) {
            builder.externalTransition()
                    .from(move.source())
                    .to(move.target())
                    .on(move.event())
                    .perform(new AnonymousAction<UntypedStateMachine, Object, Object, Object>() {
                        @Override
                        public void execute(
                                Object from, Object to, Object event, Object context, UntypedStateMachine of) {
                            act();
                        }
                    });
        }
        machine = builder.newStateMachine(walk.initial());
        machine.start(this);
    }

    @Override
    void fire(String event) {
        machine.fire(event, this);
    }
}
