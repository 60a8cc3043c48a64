package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/** The device reports what it cannot have done in its recorded state: the record is wrong, and the device is asked. */
class ContradictionTest {

    @Test
    void theDeviceIsAskedAndBothModelsFollowItsAnswer() {
        ScriptedCore core = new ScriptedCore(Scene.sliding()).own("second");
        assertThat(core.core.doubt()).isEqualTo("the device reports second, which is impossible in A");

        core.ready();
        assertThat(core.work().pending().occurrence()).isInstanceOf(Occurrence.InDoubt.class);
        core.planned().located("B");
        assertThat(core.record()).isEqualTo("B");
        rest(core);
        assertThat(core.core.at().evolved()).isEqualTo(new State("B"));
    }

    @Test
    void withoutAnAnswerTheOnlyStateToWhichItLeadsIsTheLikelier() {
        ScriptedCore core = new ScriptedCore(Scene.sliding()).own("second").asksInVain();
        assertThat(core.record()).isEqualTo("C, in doubt");
        rest(core);
        assertThat(core.core.at().evolved()).isEqualTo(new State("C"));

        core.found("C");
        assertThat(core.record()).isEqualTo("C");
        assertThat(core.core.snapshot().doubt()).isNull();
    }

    @Test
    void withoutAnAnswerTheRecordStaysIfThereAreSeveral() {
        ScriptedCore core =
                new ScriptedCore(Scene.robot()).own("Clean").own("Spot").own("Clean");
        core.asksInVain();

        assertThat(core.record()).isEqualTo("Spot, in doubt");
    }

    @Test
    void aPlanWaitsForTheAnswer() {
        ScriptedCore core =
                new ScriptedCore(Scene.sliding()).press("go").ready().planned();
        core.own("second").own("first").input(new Input.Sending(core.number()));

        assertThat(core.core.isBusy()).isFalse();
        core.ready();
        assertThat(core.work().pending().occurrence()).isInstanceOf(Occurrence.InDoubt.class);
    }

    @Test
    void whileAStepIsSentItMayHaveBeenDoneAfterTheStep() {
        ScriptedCore core = new ScriptedCore(Scene.robot()).press("Clean").begins();
        core.own("Spot");
        assertThat(core.record()).isEqualTo("Off");
        core.sent(false);
        assertThat(core.record()).endsWith("in doubt");
    }

    @Test
    void anAdapterThatKeepsTheOrderContradictsTheStepItself() {
        ScriptedCore core = new ScriptedCore(Scene.robot()).press("Clean").begins();
        core.own("endSpot").sent(true);
        assertThat(core.record()).isEqualTo("On, in doubt");
    }

    @Test
    void aStepWithoutEffectLeavesTheContradiction() {
        ScriptedCore core = new ScriptedCore(Scene.robot()).press("Clean").begins();
        core.own("endSpot").input(new Input.Failed(core.number(), "it failed", 9));
        assertThat(core.record()).isEqualTo("Off, in doubt");
    }

    @Test
    void whatNeitherTheDevicesModelHasNorWhatIsGuardedIsNoContradiction() {
        assertThat(new ScriptedCore(Scene.robot()).own("arriveSpot").record()).isEqualTo("Off");
        assertThat(new ScriptedCore(Scene.lamp()).own("power").own("dim").record())
                .isEqualTo("Bright");
    }

    /** Gives everything that waits its turn. */
    private static void rest(ScriptedCore core) {
        while (core.core.hasNext()) {
            core.ready();
            if (core.core.isBusy()) {
                core.planned();
            }
        }
    }
}
