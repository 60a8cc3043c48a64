package org.evoloop.core;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What exploration has found: each left a record that was sure of something else than where the device was. */
class CounterExamplesTest {

    @Test
    void aStepThatWasGivenUpHasItsEffectWhileAnotherIsSent() {
        ScriptedCore told = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = told.number();
        told.givenUp().asksInVain().press("switch").begins();

        told.sent(first, true);
        assertThat(told.record()).isEqualTo("on");
        told.sent(true);

        assertThat(told.record()).as("switched twice").isEqualTo("off");
    }

    @Test
    void outOfOrderThatIsNotKnownToHaveComeFirst() {
        ScriptedCore told = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = told.number();
        told.givenUp().asksInVain().press("switch").begins();

        told.sent(first, false);
        told.sent(false);

        assertThat(told.record()).isEqualTo("on, in doubt");
    }

    @Test
    void theDeviceActsBetweenALateEffectAndItsReport() {
        ScriptedCore told = new ScriptedCore(Scene.robot()).press("Clean").begins();
        long first = told.number();

        // The device took Clean, then its own Spot, and ended in Spot.
        told.givenUp().own("Spot").sent(first, false);

        assertThat(told.record()).isEqualTo("Off, in doubt");
    }

    @Test
    void inOrderALateEffectCameAfterWhatTheDeviceDid() {
        ScriptedCore told = new ScriptedCore(Scene.robot()).press("Clean").begins();
        long first = told.number();

        told.givenUp().own("Clean").sent(first, true);

        assertThat(told.record()).isEqualTo("Clean");
    }

    @Test
    void aSecondDoubtIsNotSettledByKnowingOfTheSecondStep() {
        ScriptedCore told = new ScriptedCore(Scene.bulb()).press("switch").begins();
        told.givenUp().asksInVain().press("switch").begins();
        long second = told.number();

        told.givenUp().sent(second, true);

        assertThat(told.record()).isEqualTo("off, in doubt");
    }

    @Test
    void theDeviceIsFoundWhileAStepIsOnItsWay() {
        ScriptedCore told = new ScriptedCore(Scene.bulb()).press("switch").begins();

        told.found("on");
        assertThat(told.record()).isEqualTo("on");
        told.sent(true);

        assertThat(told.record()).as("switched there").isEqualTo("off");
    }

    @Test
    void outOfOrderTheDeviceMayHaveBeenFoundBeforeOrAfterTheStep() {
        ScriptedCore told = new ScriptedCore(Scene.bulb()).press("switch").begins();

        told.found("on").sent(false);

        assertThat(told.record()).endsWith(", in doubt");
    }

    /** Clean then leads to the same place whether it came before or after both, but not if it came between. */
    @Test
    void theDeviceActsTwiceWhileAStepIsOnItsWay() {
        ScriptedCore told =
                new ScriptedCore(Scene.robot()).press("Clean").begins().sent(false);
        told.press("Clean").begins();

        told.own("Spot").own("endSpot").sent(false);

        assertThat(told.record()).isEqualTo("Clean, in doubt");
    }

    @Test
    void aDeviceThatNeverStopsActingWhileItIsAskedIsNotTakenAtItsWord() {
        ScriptedCore told = new ScriptedCore(Scene.bulb())
                .press("switch")
                .begins()
                .givenUp()
                .ready()
                .planned();

        for (int attempt = 0; attempt <= Conversion.MOST_ATTEMPTS; attempt++) {
            told.own("switch").located("off");
        }

        assertThat(told.core.isBusy()).isFalse();
        assertThat(told.record()).isEqualTo("on, in doubt");
    }

    @Test
    void aStepThatWasGivenUpHasItsEffectAfterTheDeviceWasFound() {
        ScriptedCore told = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = told.number();

        told.givenUp().found("off");
        assertThat(told.record()).isEqualTo("off");
        told.sent(first, true);

        assertThat(told.record()).isEqualTo("on");
    }

    @Test
    void outOfOrderThatIsInDoubtAgain() {
        ScriptedCore told = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = told.number();

        told.givenUp().found("off").sent(first, false);

        assertThat(told.record()).isEqualTo("off, in doubt");
    }

    @Test
    void aStepThatWasGivenUpHasItsEffectAfterAnother() {
        ScriptedCore told = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = told.number();
        told.givenUp().asksInVain().press("switch").begins();

        told.found("off").sent(true).sent(first, true);

        assertThat(told.record()).isEqualTo("off");
    }
}
