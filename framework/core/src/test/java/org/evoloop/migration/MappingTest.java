package org.evoloop.migration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import org.evoloop.evolution.ModelPair;
import org.evoloop.migration.Mapping.TimerOf;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

class MappingTest {
    private static final ModelPair RUNNING = new ModelPair(
            machine("device", "Off press -> On", "On press -> Off"),
            machine("new", "Off press -> On", "On press -> Off", "On hold -> Dim", "Dim tm(2s) -> Off"));
    private static final ModelPair NEXT = new ModelPair(
            machine("firmware", "Idle press -> On", "On press -> Idle"),
            machine("next", "Idle press -> On", "On press -> Idle", "On hold -> Soft", "Soft tm(3s) -> Idle"));
    private static final State DIM = new State("Dim");
    private static final TimerOf TIMER = new TimerOf(DIM, "tm(2s)");

    private static Mapping parse(String... lines) {
        return Mapping.parse("swap.txt", String.join("\n", lines), RUNNING, NEXT);
    }

    @Test
    void aFileSaysWhatDoesNotGoByName() {
        assertThat(parse(
                        "# a lamp",
                        "",
                        "device Off -> Idle",
                        "state Off->Idle",
                        "  state Dim -> Soft",
                        "timer tm(2s) of Dim -> tm(3s)",
                        "function of Dim goes on"))
                .isEqualTo(Mapping.byName()
                        .withDeviceState(new State("Off"), new State("Idle"))
                        .withState(new State("Off"), new State("Idle"))
                        .withState(DIM, new State("Soft"))
                        .withTimer(TIMER, "tm(3s)")
                        .withFunction(DIM, true));
        assertThat(parse("timer tm(2s) of Dim restarts", "function of Dim restarts"))
                .isEqualTo(Mapping.byName().withRestarted(TIMER).withFunction(DIM, false));
        assertThat(parse("")).isEqualTo(Mapping.byName());
    }

    @Test
    void allMistakesAreReportedWithTheirLines() {
        assertThatThrownBy(() -> parse(
                        "state Dimm -> Soft",
                        "state Dim -> Softly",
                        "device On -> Soft",
                        "timer tm(9s) of Dim restarts",
                        "timer tm(2s) of Dim -> tm(2s)",
                        "function of On restarts",
                        "Dim becomes Soft",
                        "state Dim -> Soft",
                        "state Dim -> On"))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining(
                        "swap.txt, line 1: 'Dimm' is no state of the running new model; there are Dim, Off, On")
                .hasMessageContaining("line 2: 'Softly' is no state of the next new model")
                .hasMessageContaining("line 3: 'Soft' is no state of the next original model")
                .hasMessageContaining("line 4: 'tm(9s)' is no timer of Dim; there are tm(2s)")
                .hasMessageContaining("line 5: 'tm(2s)' is no timer of Dim in the next model; there is none")
                .hasMessageContaining("line 6: the device has On itself")
                .hasMessageContaining("line 7: 'Dim becomes Soft' is no rule; write 'state A -> B'")
                .hasMessageContaining("line 9: Dim has been mapped to Soft already");
    }
}
