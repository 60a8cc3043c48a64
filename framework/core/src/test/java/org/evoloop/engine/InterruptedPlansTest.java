package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.List;
import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/**
 * Plans of two steps into a state that the device has itself, which the end of the process interrupts: such a state is
 * its own device state, to which the new model follows.
 */
class InterruptedPlansTest {
    private final ScriptedCore core = new ScriptedCore(Scene.of(
            "espresso",
            new ModelPair(
                    machine(
                            "machine",
                            "Off power -> On",
                            "On power -> Off",
                            "On steam -> Steam",
                            "Steam steam -> On",
                            "Steam power -> Off"),
                    machine(
                            "new",
                            "Off power -> On",
                            "On power -> Off",
                            "Off froth -> Steam",
                            "Steam steam -> On",
                            "Steam power -> Off",
                            "Off rest -> Rest",
                            "Rest power -> On")),
            Map.of(),
            "power steam",
            "power",
            2));

    private static Configuration at(String state) {
        return new Configuration(new State(state), new State(state));
    }

    private List<String> sent() {
        return core.said.stream()
                .filter(Output.Took.class::isInstance)
                .map(output -> ((Output.Took) output).step().trigger().name())
                .toList();
    }

    private void endsWhileItSendsTheSecondStep() {
        core.press("froth").begins().sent(true).sending();
        core.input(new Input.Recovered(1)).input(new Input.Opened(2));
    }

    @Test
    void whereTheSecondStepHadNoEffectTheNewModelFollowsToWhereTheFirstLed() {
        endsWhileItSendsTheSecondStep();
        core.ready().planned().located("On").ready().planned();
        assertThat(core.core.at()).isEqualTo(at("On"));
        assertThat(sent()).containsExactly("power");
        assertThat(core.core.hasNext()).isFalse();
    }

    @Test
    void soItDoesWhenTheDeviceReportsThatUnasked() {
        endsWhileItSendsTheSecondStep();
        core.found("On").ready().planned();
        while (core.core.hasNext()) {
            core.ready().planned();
        }
        assertThat(core.core.at()).isEqualTo(at("On"));
    }

    @Test
    void whereItHadAnEffectThePressEndsInTheStateThatWasAskedFor() {
        endsWhileItSendsTheSecondStep();
        core.ready().planned().located("Steam");
        assertThat(core.core.at()).isEqualTo(at("Steam"));
        assertThat(sent()).containsExactly("power");
        assertThat(core.core.hasNext()).isFalse();
    }

    @Test
    void aPressThatIsDecidedAgainIsNotOvertakenByWhatItHasDone() {
        core.press("power").begins();
        // Before or after it took the step?
        core.found("Off").sent(false);
        assertThat(core.record()).endsWith(", in doubt");
        core.found("On");
        while (core.core.hasNext()) {
            core.ready().planned();
            if (core.core.snapshot().work() != null) {
                core.sending().sent(true);
            }
        }
        assertThat(core.core.at()).isEqualTo(at("On"));
    }

    @Test
    void whatEndsBetweenTheStepsGoesOn() {
        core.press("froth").begins().sent(true);
        core.input(new Input.Recovered(1)).input(new Input.Opened(2));
        core.ready().planned().sending().sent(true);
        assertThat(core.core.at()).isEqualTo(at("Steam"));
        assertThat(sent()).containsExactly("power", "steam");
    }
}
