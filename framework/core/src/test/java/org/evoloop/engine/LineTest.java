package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/** Controllers' events and all others have places of their own in the queue, here two each, and begin in their order. */
class LineTest {
    private final ScriptedCore core = new ScriptedCore(Scene.robot());

    private long dropped() {
        return core.core.tally().dropped();
    }

    private void asks() {
        core.observe(asked());
    }

    private Occurrence asked() {
        return new Occurrence.Asked(new Event("Spot"), Values.NONE, core.core.visit(), 1);
    }

    @Test
    void pressesAreLostWhenAsManyWaitWhateverElseWaits() {
        core.own("Clean").own("Clean").own("Clean").press("Clean").press("Clean");
        assertThat(dropped()).isZero();
        core.press("Clean");
        assertThat(dropped()).isEqualTo(1);
        core.own("Clean");
        assertThat(dropped()).isEqualTo(1);
        assertThat(core.core.waiting()).isEqualTo(6);
    }

    @Test
    void aFunctionWaitsBehindFactsAndFunctionsOnly() {
        core.press("Clean").press("Clean").press("Clean");
        assertThat(core.core.hasRoom(asked())).isTrue();
        asks();
        assertThat(core.core.hasRoom(asked())).isTrue();
        core.own("Clean");
        assertThat(core.core.hasRoom(asked())).isFalse();
    }

    @Test
    void aPressThatBeginsFreesItsPlace() {
        core.press("Clean").press("Clean").ready().press("Clean");
        assertThat(dropped()).isZero();
        core.press("Clean");
        assertThat(dropped()).isEqualTo(1);
    }

    @Test
    void aPressThatIsOvertakenTakesUpAPlaceAgain() {
        core.press("Clean").ready().planned().own("Clean").press("Clean").sending();
        assertThat(core.core.isBusy()).isFalse();
        assertThat(core.core.waiting())
                .as("the press, the fact and the other press")
                .isEqualTo(3);
        core.press("Clean");
        assertThat(dropped()).isEqualTo(1);
    }

    @Test
    void whatTheStateDefersLeavesThePlacesOfOthersFree() {
        ScriptedCore grinder =
                new ScriptedCore(Scene.grinder()).press("start").ready().planned();
        grinder.press("grind").press("grind").press("grind").ready();
        assertThat(grinder.core.isBusy()).isFalse();
        assertThat(grinder.core.tally().dropped()).as("the third").isEqualTo(1);

        grinder.press("stop").press("start").press("start");
        assertThat(grinder.core.tally().dropped()).as("the second start, too").isEqualTo(2);

        grinder.ready().planned().runsEffect().runsEffect();
        assertThat(grinder.core.at().evolved()).isEqualTo(new State("Off"));
        grinder.press("stop");
        assertThat(grinder.core.tally().dropped()).as("behind two and one").isEqualTo(3);
    }

    @Test
    void aFunctionMayRaiseWhatLeavesAStateThatDefersItsOtherEvents() {
        ScriptedCore grinder =
                new ScriptedCore(Scene.grinder()).press("start").ready().planned();
        Occurrence grind = raised("grind", grinder);
        grinder.observe(grind).observe(grind);

        assertThat(grinder.core.hasRoom(grind)).isFalse();
        assertThat(grinder.core.hasRoom(raised("timeout", grinder))).isTrue();
    }

    private static Occurrence raised(String event, ScriptedCore by) {
        return new Occurrence.Heard(new Event(event), Values.NONE, Source.FUNCTION, by.core.visit(), 1);
    }

    @Test
    void closingFreesThePlaces() {
        core.own("Clean").press("Clean").press("Clean").input(new Input.Closing());
        assertThat(core.core.waiting()).isEqualTo(1);
        core.input(new Input.Opened(9)).press("Clean").press("Clean");
        assertThat(dropped()).isZero();
        assertThat(core.core.waiting()).isEqualTo(3);
    }
}
