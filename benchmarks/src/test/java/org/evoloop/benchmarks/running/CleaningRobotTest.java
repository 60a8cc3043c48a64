package org.evoloop.benchmarks.running;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.evolution.Configuration;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The benchmarks measure what they claim to. */
class CleaningRobotTest {
    private static final Configuration ON = new Configuration(new State("On"), new State("On"));

    private final PathTimer timer = new PathTimer();

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    @Timeout(60)
    void goesRoundAndRoundAndMeasuresEveryEventOnce(boolean threads) throws InterruptedException {
        try (CleaningRobot robot = new CleaningRobot(timer, threads)) {
            robot.next();
            for (int round = 1; round <= 20; round++) {
                for (int event = 1; event < CleaningRobot.STORY.size(); event++) {
                    robot.next();
                }
                assertThat(robot.states()).isEqualTo(ON);
            }
            robot.requireAllHandled();
        }
        assertThat(timer.nanos().getTotalCount()).isEqualTo(1 + 20 * 7);
    }
}
