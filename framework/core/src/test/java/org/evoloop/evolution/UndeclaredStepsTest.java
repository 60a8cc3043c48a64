package org.evoloop.evolution;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.evoloop.PaperModels;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;

/** How acts of the device are treated that are not declared as its own. */
class UndeclaredStepsTest {

    @Test
    void theyMeanWhatDeclaredOnesDo() {
        ModelPair robot = PaperModels.cleaningRobot();
        Set<Event> buttons = Set.of(new Event("Clean"), new Event("Spot"));
        DecisionTable declared = DecisionTable.compile(robot, new DeviceEvents(buttons, buttons));
        DecisionTable undeclared = DecisionTable.compile(robot, new DeviceEvents(buttons, Set.of()));

        assertThat(undeclared.configurations()).hasSizeGreaterThan(4).allSatisfy(at -> {
            for (Event button : buttons) {
                assertThat(undeclared.decide(at, button, true)).isEqualTo(declared.decide(at, button, true));
            }
        });
        assertThat(undeclared.decide(robot.initial(), new Event("Clean"), true).deviceStart())
                .isEqualTo(new State("On"));
    }

    @Test
    void anEventUnderAGuardThatNoTransitionThereHasMovesNothing() {
        Event guarded = new Event("toggle", List.of("hot"));
        StateMachine original = StateMachine.named("o")
                .initial("Off")
                .transition("Off", "toggle", "On")
                .transition("On", "toggle", "Off")
                .build();
        StateMachine evolved = StateMachine.named("n")
                .initial("Off")
                .transition("Off", "toggle", "On")
                .transition(new Transition(new State("On"), guarded, new State("Off")), "")
                .build();
        DecisionTable table =
                DecisionTable.compile(new ModelPair(original, evolved), new DeviceEvents(original.events(), Set.of()));

        Decision decision = table.decide(table.models().initial(), guarded, true);

        assertThat(decision).isInstanceOf(Decision.NotAcceptable.class);
        assertThat(decision.steps()).isEmpty();
    }
}
