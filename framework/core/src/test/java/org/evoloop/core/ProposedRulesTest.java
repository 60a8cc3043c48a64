package org.evoloop.core;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.Map;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;

/** Rules that neither the core nor its specification in {@code prism/proof} has. */
class ProposedRulesTest {
    private static final Event TIMEOUT = new Event("timeout");

    /** {@code Ledger.enterAsLeft}, {@code enter_as_left}: only timers of the present visit count as fired. */
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
}
