package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;

/** A press that is too old when its turn comes is stale; nothing else ages. */
class PressAgeTest {
    private static final long SECOND = Duration.ofSeconds(1).toNanos();

    private static Scene limited(Scene scene) {
        return scene.withPressAge(10 * SECOND);
    }

    private static List<String> endings(ScriptedCore core) {
        return core.said.stream()
                .filter(Output.Ended.class::isInstance)
                .map(Output.Ended.class::cast)
                .map(ended -> ended.occurrence().label() + " " + ended.outcome() + " " + ended.detail())
                .toList();
    }

    @Test
    void isMeasuredWhenItsTurnComes() {
        for (long seconds : new long[] {10, 11}) {
            ScriptedCore core = new ScriptedCore(limited(Scene.bulb()));
            core.observe(pressed("switch", Source.CONTROLLER, 0))
                    .observe(pressed("switch", Source.PANEL, 0))
                    .begins();
            core.input(new Input.Sent(core.number(), true, seconds * SECOND)).ready();

            assertThat(core.core.isBusy()).isEqualTo(seconds == 10);
            assertThat(endings(core))
                    .hasSize(seconds == 10 ? 1 : 2)
                    .last()
                    .isEqualTo(
                            seconds == 10
                                    ? "switch HANDLED "
                                    : "switch STALE pressed 11 s before its turn; the limit is 10 s");
        }
    }

    @Test
    void afterAnOutageNothingThatWaitedIsBegun() {
        ScriptedCore core = new ScriptedCore(limited(Scene.bulb()));
        for (int press = 0; press < 2; press++) {
            core.observe(pressed("switch", Source.CONTROLLER, 0));
        }
        core.ready()
                .input(new Input.Recovered(15 * SECOND))
                .input(new Input.Opened(15 * SECOND))
                .ready();

        assertThat(core.said).noneMatch(Output.Send.class::isInstance);
        assertThat(endings(core)).hasSize(2).allMatch(ending -> ending.startsWith("switch STALE"));
    }

    @Test
    void norIsThePlanThatWasInterruptedContinued() {
        ScriptedCore core = new ScriptedCore(limited(Scene.bulb()));
        core.observe(pressed("switch", Source.CONTROLLER, 0)).ready().planned();
        long sends = core.said.stream().filter(Output.Send.class::isInstance).count();
        core.input(new Input.Recovered(15 * SECOND))
                .input(new Input.Opened(15 * SECOND))
                .ready();

        assertThat(core.said.stream().filter(Output.Send.class::isInstance)).hasSize((int) sends);
        assertThat(core.core.isBusy()).isFalse();
        assertThat(core.core.isVisitOver()).isFalse();
        assertThat(endings(core)).hasSize(1).first().asString().startsWith("switch STALE pressed 15 s");
    }

    @Test
    void whatTheModelDefersAndWhatATimerRaisesDoNotAge() {
        ScriptedCore core = new ScriptedCore(limited(Scene.grinder()));
        core.observe(pressed("start", Source.CONTROLLER, 0)).ready().planned();
        core.observe(pressed("grind", Source.CONTROLLER, 1));
        core.input(new Input.TimerDue(core.core.visit(), new Event("timeout"), 6 * SECOND));
        core.input(new Input.Changed(core.core.rules(), 60 * SECOND)).ready();
        assertThat(core.work().pending().occurrence().label()).isEqualTo("timeout");

        core.planned().sending().sent(true).runsEffect().runsEffect().ready();
        assertThat(core.work().pending().occurrence().label()).isEqualTo("grind");
    }

    @Test
    void aPressOfWhatOnlyTheDeviceDoesMovesNothing() {
        ScriptedCore core = new ScriptedCore(Scene.robot());
        core.own("Clean").own("Spot");
        int waiting = core.core.waiting();
        Snapshot before = core.core.snapshot();
        core.press("endSpot");

        assertThat(core.core.snapshot().at()).isEqualTo(before.at());
        assertThat(core.core.waiting()).isEqualTo(waiting);
        assertThat(endings(core))
                .last()
                .asString()
                .startsWith("endSpot IGNORED only the device itself can raise endSpot");
    }

    private static Occurrence pressed(String event, Source source, long atNanos) {
        return new Occurrence.Heard(
                new Event(event), Values.NONE, source, false, Set.of(), Occurrence.ANY_VISIT, atNanos);
    }
}
