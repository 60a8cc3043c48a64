package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.Map;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;

/** What crashes, stops, and facts that come late leave behind. */
class AftermathTest {
    private static final Event TIMEOUT = new Event("timeout");

    /** It is stale, and the present visit's has not fired. */
    @Test
    void afterACrashAStaleTimerDoesNotCancelThatOfThePresentVisit() {
        ModelPair pair = new ModelPair(
                machine("device", "Off start -> On", "On stop -> Off"),
                machine("working", "Off start -> Work", "Work again -> Work", "Work timeout -> Off", "On"));
        Scene scene = Scene.of("working", pair, Map.of("Work", "timeout"), "start stop", "", 2);
        ScriptedCore core = new ScriptedCore(scene).press("start").ready().planned();
        long first = core.core.visit();
        long due = core.core.snapshot().visit().deadlines().get(TIMEOUT);

        core.press("again")
                .input(new Input.TimerDue(first, TIMEOUT, due))
                .ready()
                .planned();
        assertThat(core.core.snapshot().visit().deadlines()).containsKey(TIMEOUT);
        core.input(new Input.Recovered(due)).input(new Input.Opened(due));

        assertThat(core.core.snapshot().visit().deadlines()).containsKey(TIMEOUT);
    }

    /** The doubt comes back while the event is analyzed, and the device overtakes it. */
    @Test
    void nothingIsDecidedAgainBeforeTheDeviceHasBeenAsked() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").begins();
        long first = core.number();
        core.givenUp().found("off").ready().press("switch").ready();
        Decision early = core.core
                .rules()
                .decide(core.core.at(), core.core.steps(), core.work().pending(), guard -> false);
        long number = core.number();

        core.sent(first, false).own("switch").input(new Input.Planned(number, early, 9));
        assertThat(core.record()).endsWith("in doubt");
        core.ready();

        assertThat(core.work().pending().occurrence()).isInstanceOf(Occurrence.InDoubt.class);
    }

    /** A crash interrupted it, and a stop came before it was resumed. */
    @Test
    void whatAFunctionAskedForIsNotSentAfterItsVisit() {
        ScriptedCore core = new ScriptedCore(Scene.bulb());
        long visit = core.core.visit();
        core.observe(new Occurrence.Asked(new Event("switch"), Values.NONE, visit, 1));
        core.ready().planned();

        core.input(new Input.Recovered(2)).input(new Input.Opened(3));
        core.input(new Input.Closing()).input(new Input.Closed()).input(new Input.Opened(4));
        core.ready();

        assertThat(core.core.isBusy()).isFalse();
    }

    /** The reaction to the first fact has moved the device, so that to the second comes from elsewhere. */
    @Test
    void theReactionToALateFactDoesNotPartTheNewModelFromTheDevice() {
        Scene scene = Scene.slipping();
        ScriptedCore core = new ScriptedCore(scene).own("slip").own("slip");

        core.begins().sent(true).ready().planned();
        while (core.core.hasNext()) {
            core.ready().planned();
        }

        boolean parted = scene.rules()
                .table()
                .find(core.core.at(), core.core.at().original())
                .leavesState();
        assertThat(parted).as("%s", core.core.at()).isFalse();
    }

    /** A press at the device is a fact although it is a controller's event, and nobody has declared that it can be one. */
    @Test
    void theNewModelStaysWhereAnUndeclaredFactHasLedIt() {
        ModelPair pair = new ModelPair(
                machine("device", "Off press -> On", "On press -> Off"),
                machine("new", "Off press -> On", "On press -> Wait", "Wait timeout -> Off"));
        Scene scene = Scene.of("undeclared", pair, Map.of("Wait", "timeout"), "press", "", 2);
        ScriptedCore core = new ScriptedCore(scene).own("press").ready().planned();

        core.own("press").ready().planned();
        assertThat(core.core.at()).hasToString("(Off, Wait)");
        assertThat(core.core.hasNext()).isFalse();
    }
}
