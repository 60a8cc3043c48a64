package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.evoloop.evolution.Outcome;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A flood of events takes bounded memory and few log lines, and the device's latest state is never lost. */
class FloodTest {
    private static final int MANY = 20_000;

    /** 1,024 wait at the monitor, and 1,024 plus the queue's eight in the core. */
    private static final int MOST_WAITING = 1024 + 8;

    private final Robot robot = new Robot();
    private final LoggedLines log = new LoggedLines("org.evoloop.converter.SystemEventConverter");

    @AfterEach
    void close() {
        log.close();
        robot.close();
    }

    /** Processes everything that waits at the monitor and in the core. */
    private void settleAll() throws InterruptedException {
        for (int count = 0; count < MOST_WAITING; count++) {
            robot.converter.observe(robot.panel);
        }
        robot.settle();
    }

    @Test
    void misspeltEventsOfTheDeviceAreRefusedAtTheDoorAndCounted() throws InterruptedException {
        for (int count = 0; count < MANY; count++) {
            robot.panel.ended("endSpott" + count);
            assertThat(robot.converter.status().queue().depth()).isZero();
        }
        robot.panel.found("Clean");
        settleAll();

        assertThat(robot.states()).isEqualTo(Robot.at("Clean", "Clean"));
        assertThat(robot.converter.status().events().ignored()).isEqualTo(MANY);
        assertThat(robot.last().outcome()).isEqualTo(Outcome.HANDLED);
    }

    @Test
    void whatTheDeviceReallyDoesMovesTheRecordHoweverMuchWaits() throws InterruptedException {
        for (int count = 0; count < MANY; count++) {
            robot.panel.pressed("Clean", true);
        }
        robot.panel.pressed("Spot", true);
        robot.converter.observe(robot.panel);
        assertThat(robot.converter.status().queue().depth())
                .as("and the question where it is")
                .isLessThanOrEqualTo(MOST_WAITING + 1);
        settleAll();

        assertThat(robot.states())
                .as("its last act, after On and Clean in turn")
                .isEqualTo(Robot.at("Spot", "Spot"));
        ConverterStatus status = robot.converter.status();
        assertThat(status.events().handled()
                        + status.events().ignored()
                        + status.events().stale()
                        + status.events().failed()
                        + status.queue().dropped())
                .isGreaterThanOrEqualTo(MANY + 1);
    }

    @Test
    void aFloodOfDifferentFailuresIsLoggedByBursts() throws InterruptedException {
        robot.brokenCable = new Exception("none");
        robot.soundSteps = 0;
        for (int count = 0; count < 1000; count++) {
            robot.brokenCable = new Exception("no answer to request " + count);
            robot.controller("Clean");
        }
        assertThat(log.lines()).hasSize(20).allMatch(line -> line.startsWith("Device.execute: no answer to request"));

        robot.clock.advance(Duration.ofSeconds(10));
        assertThat(log.lines()).hasSize(21);
        assertThat(log.lines().get(20))
                .isEqualTo("980 more different warnings were left out; status counts the failures");
        robot.brokenCable = new Exception("yet another");
        robot.controller("Clean");
        assertThat(log.lines()).last().isEqualTo("Device.execute: yet another");
    }

    @Test
    void aMessageThatIsABookIsCutOff() throws InterruptedException {
        robot.soundSteps = 0;
        robot.brokenCable = new Exception("x".repeat(10_000_000));
        robot.controller("Clean");
        assertThat(robot.last().detail()).hasSizeLessThan(1100).endsWith("...");
        robot.brokenCable = new Exception() {
            @Override
            public String getMessage() {
                throw new IllegalStateException("not even that");
            }
        };
        robot.controller("Clean");
        assertThat(robot.last().outcome()).isEqualTo(Outcome.FAILED);
    }
}
