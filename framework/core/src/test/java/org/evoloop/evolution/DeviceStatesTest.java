package org.evoloop.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.junit.jupiter.api.Test;

/** New states in which the device must be somewhere. */
class DeviceStatesTest {
    private static final State GAP = new State("Gap");

    /** A garage door with one button, which stops, closes and opens it by turns. */
    static StateMachineBuilder door() {
        return StateMachine.named("door")
                .initial("Closed")
                .transition("Closed", "press", "Opening")
                .transition("Opening", "press", "StopUp")
                .transition("Opening", "limitOpen", "Open")
                .transition("StopUp", "press", "Closing")
                .transition("Open", "press", "Closing")
                .transition("Closing", "press", "StopDown")
                .transition("Closing", "limitClosed", "Closed")
                .transition("StopDown", "press", "Opening");
    }

    private static ModelPair pair(String deviceState) {
        StateMachine evolved = door().transition("Closed", "gap", "Gap")
                .transition("Gap", "press", "Closing")
                .deviceState("Gap", deviceState)
                .build();
        return new ModelPair(door().build(), evolved);
    }

    @Test
    void theDeviceMustBeWhereTheStateNamesIt() {
        ModelPair pair = pair("StopUp");

        pair.requireValid();
        assertThat(pair.whereDeviceMustBe(GAP)).containsExactly(new State("StopUp"));
        assertThat(pair.whereDeviceMustBe(new State("Open"))).containsExactly(new State("Open"));
        assertThat(pair.deviceStates(GAP)).isEmpty();
        assertThat(pair.isNew(GAP)).isTrue();
    }

    @Test
    void isDescribedWithWhereTheDeviceIs() {
        State stopUp = new State("StopUp");

        assertThat(pair("StopUp").describe(new Configuration(stopUp, GAP))).isEqualTo("Gap, the device in StopUp");
        assertThat(pair("StopUp").describe(new Configuration(stopUp, stopUp))).isEqualTo("StopUp");
    }

    @Test
    void theDeviceMayBeAnywhereInANewStateWithout() {
        StateMachine evolved = door().transition("Closed", "gap", "Gap").build();

        assertThat(new ModelPair(door().build(), evolved).whereDeviceMustBe(GAP))
                .isEmpty();
    }

    @Test
    void refusesADeviceStateThatTheOriginalLacks() {
        assertThatThrownBy(pair("StopUpp")::requireValid)
                .hasMessage("the new model 'door': the device state of Gap, StopUpp, is not a state of the original"
                        + " model; did you mean StopUp?");
    }

    @Test
    void refusesADeviceStateOfAStateThatTheDeviceHas() {
        StateMachine evolved = door().deviceState("Open", "StopUp").build();

        assertThat(new ModelPair(door().build(), evolved).deviceStateProblems())
                .extracting(Object::toString)
                .containsExactly(
                        "the device has state Open itself, so it can have no other device state; remove StopUp");
    }

    @Test
    void aPathNamesWhatIsDrawnInsideToo() {
        StateMachineBuilder fan = StateMachine.named("fan").initial("Off");
        for (String speed : List.of("Slow", "Fast")) {
            State state = new State(speed);
            fan.drawn(state, state, List.of(), List.of("On." + speed), false).transition("Off", speed, speed);
        }
        StateMachine original = fan.build();

        assertThat(goals(original, "On")).containsExactly(new State("Slow"), new State("Fast"));
        assertThat(goals(original, "On.Fast")).containsExactly(new State("Fast"));
        assertThat(goals(original, "Fast")).containsExactly(new State("Fast"));
        assertThat(goals(original, "On.F")).isEmpty();
    }

    private static List<State> goals(StateMachine original, String device) {
        StateMachine evolved = StateMachine.named("new")
                .initial("Off")
                .deviceState("Gap", device)
                .build();
        return new ModelPair(original, evolved).whereDeviceMustBe(GAP);
    }

    @Test
    void aNamedStateIsFollowedWhenItIsRenamed() {
        // The new model has another Fast, so what the device calls Fast is On.Fast there.
        State fast = new State("Fast");
        State onFast = new State("On.Fast");
        StateMachine original = StateMachine.named("fan")
                .initial("Off")
                .drawn(fast, fast, List.of(), List.of("On.Fast"), false)
                .transition("Off", "press", "Fast")
                .build();
        StateMachine evolved = StateMachine.named("new")
                .initial("Off")
                .drawn(onFast, onFast, List.of(), List.of("On.Fast"), false)
                .drawn(fast, fast, List.of(), List.of("Boost.Fast"), false)
                .transition("Off", "press", "On.Fast")
                .transition("Off", "boost", "Fast")
                .deviceState("Gap", "Fast")
                .build();

        ModelPair pair = new ModelPair(original, evolved);
        assertThat(pair.original().hasState(onFast)).isTrue();
        assertThat(pair.whereDeviceMustBe(GAP)).containsExactly(onFast);
    }
}
