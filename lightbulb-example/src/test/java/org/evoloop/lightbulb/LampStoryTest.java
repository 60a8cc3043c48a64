package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.testkit.ConverterHarness;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;

/** The evolution of the paper's section III, as someone in front of the lamp sees it. */
class LampStoryTest {
    private static final ModelFile MACHINES =
            ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", "light-bulb.xml"));
    private static final String DARK = "( ) dark";
    private static final String DAYLIGHT = "(*) daylight";
    private static final String INCANDESCENT = "(*) incandescent";

    private final LightBulb lamp = new LightBulb();
    private final ConverterHarness converter = ConverterHarness.of(
                    lamp.knowledge(new ModelPair(MACHINES.pick("original"), MACHINES.pick("new"))))
            .with(lamp.execute())
            .start();

    private void operateSwitch() {
        converter.press("switch");
    }

    private void assertShows(String look, String original, String evolved) {
        assertThat(lamp).hasToString(look);
        converter.expect(original, evolved);
    }

    @Test
    void switchedOnceItLightsUpAndStaysSo() {
        assertShows(DARK, "off", "off");

        operateSwitch();
        assertShows(DAYLIGHT, "on", "on");

        converter.advance(Duration.ofHours(5));
        assertShows(DAYLIGHT, "on", "on");
    }

    @Test
    void switchedTwiceItGoesOffAfterTwoSeconds() {
        operateSwitch();
        operateSwitch();
        assertShows(DAYLIGHT, "on", "wait");

        converter.advance(Duration.ofMillis(1999));
        assertShows(DAYLIGHT, "on", "wait");

        converter.advance(Duration.ofMillis(1));
        assertShows(DARK, "off", "off");
        assertThat(converter.clock().pendingTasks()).isZero();
    }

    @Test
    void switchedAgainWithinTwoSecondsItTurnsIncandescentUntilSwitchedOff() {
        operateSwitch();
        operateSwitch();
        converter.advance(Duration.ofMillis(1999));
        operateSwitch();
        assertShows(INCANDESCENT, "on", "incandescentOn");

        converter.advance(Duration.ofHours(5));
        assertShows(INCANDESCENT, "on", "incandescentOn");

        operateSwitch();
        assertShows(DARK, "off", "off");
    }

    @Test
    void theNextRoundStartsInDaylightAgain() {
        for (int press = 0; press < 5; press++) {
            operateSwitch();
        }

        assertShows(DAYLIGHT, "on", "on");
    }

    @Test
    void stoppedWhileIncandescentItShowsItsOwnLightAndContinuesWhereItWas() {
        for (int press = 0; press < 3; press++) {
            operateSwitch();
        }

        converter.converter().stop();
        assertThat(lamp).hasToString(DAYLIGHT);

        converter.converter().start();
        assertShows(INCANDESCENT, "on", "incandescentOn");
    }
}
