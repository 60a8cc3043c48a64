package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.List;
import java.util.Map;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

/** Found by exploration: each of these led to a wrong recorded state that was not in doubt. */
class CounterExamplesTest {

    @Test
    void aStepThatWasGivenUpHasItsEffectWhileAnotherIsSent() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = core.number();
        core.givenUp().asksInVain().press("switch").begins();

        core.sent(first, true);
        assertThat(core.record()).isEqualTo("on");
        core.sent(true);

        assertThat(core.record()).as("switched twice").isEqualTo("off");
    }

    @Test
    void outOfOrderThatIsNotKnownToHaveComeFirst() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = core.number();
        core.givenUp().asksInVain().press("switch").begins();

        core.sent(first, false);
        core.sent(false);

        assertThat(core.record()).isEqualTo("on, in doubt");
    }

    @Test
    void theDeviceActsBetweenALateEffectAndItsReport() {
        ScriptedCore core = new ScriptedCore(Scene.robot()).press("Clean").begins();
        long first = core.number();

        // The device took Clean, then its own Spot, and ended in Spot.
        core.givenUp().own("Spot").sent(first, false);

        assertThat(core.record()).isEqualTo("Spot, in doubt");
    }

    @Test
    void inOrderALateEffectCameAfterWhatTheDeviceDid() {
        ScriptedCore core = new ScriptedCore(Scene.robot()).press("Clean").begins();
        long first = core.number();

        core.givenUp().own("Clean").sent(first, true);

        assertThat(core.record()).isEqualTo("Clean");
    }

    /** The event has failed, so nothing else would tell the new model that the device is elsewhere. */
    @Test
    void theSystemFollowsALateEffect() {
        ScriptedCore core = new ScriptedCore(Scene.robot()).press("Clean").begins();
        long first = core.number();

        core.givenUp().asksInVain().sent(first, true);
        assertThat(core.core.hasNext()).isTrue();
        core.ready().planned();

        assertThat(core.core.at()).hasToString("(On, On)");
    }

    @Test
    void theSystemFollowsAFactAboutWhichAnalyzeFails() {
        ScriptedCore core = new ScriptedCore(Scene.robot()).own("Clean").ready();

        core.input(new Input.Failed(core.number(), "analyze failed", 9));

        assertThat(core.core.at()).hasToString("(On, On)");
        assertThat(core.core.tally().failed()).isEqualTo(1);
        assertThat(core.core.isVisitOver()).isFalse();
    }

    @Test
    void aSecondDoubtIsNotSettledByKnowingOfTheSecondStep() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").begins();
        core.givenUp().asksInVain().press("switch").begins();
        long second = core.number();

        core.givenUp().sent(second, true);

        assertThat(core.record()).isEqualTo("off, in doubt");
    }

    @Test
    void theDeviceIsFoundWhileAStepIsOnItsWay() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").begins();

        core.found("on");
        assertThat(core.record()).isEqualTo("on");
        core.sent(true);

        assertThat(core.record()).as("switched there").isEqualTo("off");
    }

    @Test
    void outOfOrderTheDeviceMayHaveBeenFoundBeforeOrAfterTheStep() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").begins();

        core.found("on").sent(false);

        assertThat(core.record()).endsWith(", in doubt");
    }

    /** Clean leads to the same state whether it came before or after both, but not if it came between them. */
    @Test
    void theDeviceActsTwiceWhileAStepIsOnItsWay() {
        ScriptedCore core =
                new ScriptedCore(Scene.robot()).press("Clean").begins().sent(false);
        core.press("Clean").begins();

        core.own("Spot").own("endSpot").sent(false);

        assertThat(core.record()).isEqualTo("Clean, in doubt");
    }

    @Test
    void aDeviceThatNeverStopsActingWhileItIsAskedIsNotTakenAtItsWord() {
        ScriptedCore core = new ScriptedCore(Scene.bulb())
                .press("switch")
                .begins()
                .givenUp()
                .ready()
                .planned();

        for (int attempt = 0; attempt <= Conversion.MOST_ATTEMPTS; attempt++) {
            core.own("switch").located("off");
        }

        assertThat(core.core.isBusy()).isFalse();
        assertThat(core.record()).isEqualTo("on, in doubt");
    }

    @Test
    void aStepThatWasGivenUpHasItsEffectAfterTheDeviceWasFound() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = core.number();

        core.givenUp().found("off");
        assertThat(core.record()).isEqualTo("off");
        core.sent(first, true);

        assertThat(core.record()).isEqualTo("on");
    }

    @Test
    void outOfOrderThatIsInDoubtAgain() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = core.number();

        core.givenUp().found("off").sent(first, false);

        assertThat(core.record()).isEqualTo("off, in doubt");
    }

    @Test
    void aStepThatWasGivenUpHasItsEffectAfterAnother() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = core.number();
        core.givenUp().asksInVain().press("switch").begins();

        core.found("off").sent(true).sent(first, true);

        assertThat(core.record()).isEqualTo("off");
    }

    /** Whether a docked device obeys is up to its guard, which the core does not know. */
    @Test
    void theDeviceActsWhileAStepIsOnItsWayThatItsGuardsMayStop() {
        for (boolean inOrder : List.of(true, false)) {
            ScriptedCore core = new ScriptedCore(docking()).press("start").begins();

            core.own("dock").sent(inOrder);

            assertThat(core.record()).isEqualTo("Docked, in doubt");
        }
    }

    @Test
    void aLateEffectThatTheGuardsOfTheDeviceMayHaveStopped() {
        ScriptedCore core = new ScriptedCore(docking()).press("start").begins();
        long first = core.number();

        core.own("dock").givenUp().sent(first, true);

        assertThat(core.record()).isEqualTo("Docked, in doubt");
    }

    private static Scene docking() {
        StateMachine device = machine(
                "docking",
                "Off start -> On",
                "Off dock -> Docked",
                "On dock -> Docked",
                "Docked start [charged] -> On");
        return Scene.of("docking", new ModelPair(device, device), Map.of(), "start", "dock", 2);
    }
}
