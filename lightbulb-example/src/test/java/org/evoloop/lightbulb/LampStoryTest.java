package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.evoloop.xmi.XmiFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The evolution of the paper's section III, as whoever stands before the lamp sees it. */
class LampStoryTest {
    private static final String DARK = "( ) dark";
    private static final String DAYLIGHT = "(*) daylight";
    private static final String INCANDESCENT = "(*) incandescent";

    private final ManualClock clock = new ManualClock();
    private final Lamp lamp = new Lamp();
    private final PushMonitor wallSwitch = new PushMonitor("WallSwitch");
    private final SystemEventConverter converter =
            new SystemEventConverter(LoopConfig.defaults("lamp", clock).withoutThreads());

    @BeforeEach
    void start() {
        XmiFile machines = XmiFile.read(Path.of(System.getProperty("evoloop.root"), "models", "light-bulb.xml"));
        converter.addMonitor(wallSwitch);
        converter.addExecute(new LampExecute(lamp));
        converter.addKnowledge(new LampKnowledge(new ModelPair(machines.pick("original"), machines.pick("new")), lamp));
        converter.build();
        converter.start();
    }

    private void operateSwitch() throws InterruptedException {
        wallSwitch.press("switch");
        converter.observe(wallSwitch);
        converter.step();
    }

    private void pass(Duration duration) {
        clock.advance(duration);
        converter.step();
    }

    private void assertShows(String look, String original, String evolved) {
        assertThat(lamp).hasToString(look);
        assertThat(converter.knowledge().getOriginalState()).hasToString(original);
        assertThat(converter.knowledge().getCurrentState()).hasToString(evolved);
    }

    @Test
    void switchedOnceItLightsUpAndStaysSo() throws Exception {
        assertShows(DARK, "off", "off");

        operateSwitch();
        assertShows(DAYLIGHT, "on", "on");

        pass(Duration.ofHours(5));
        assertShows(DAYLIGHT, "on", "on");
    }

    @Test
    void switchedTwiceItGoesOffAfterTwoSeconds() throws Exception {
        operateSwitch();
        operateSwitch();
        assertShows(DAYLIGHT, "on", "wait");

        pass(Duration.ofMillis(1999));
        assertShows(DAYLIGHT, "on", "wait");

        pass(Duration.ofMillis(1));
        assertShows(DARK, "off", "off");
        assertThat(clock.pendingTasks()).isZero();
    }

    @Test
    void switchedAgainWithinTwoSecondsItTurnsIncandescentUntilSwitchedOff() throws Exception {
        operateSwitch();
        operateSwitch();
        clock.advance(Duration.ofMillis(1999));
        operateSwitch();
        assertShows(INCANDESCENT, "on", "incandescentOn");

        pass(Duration.ofHours(5));
        assertShows(INCANDESCENT, "on", "incandescentOn");

        operateSwitch();
        assertShows(DARK, "off", "off");
    }

    @Test
    void theNextRoundStartsInDaylightAgain() throws Exception {
        for (int press = 0; press < 5; press++) {
            operateSwitch();
        }

        assertShows(DAYLIGHT, "on", "on");
    }

    @Test
    void stoppedWhileIncandescentItShowsItsOwnLightAndGoesOnWhereItWas() throws Exception {
        for (int press = 0; press < 3; press++) {
            operateSwitch();
        }

        converter.stop();
        assertThat(lamp).hasToString(DAYLIGHT);

        converter.start();
        assertShows(INCANDESCENT, "on", "incandescentOn");
    }
}
