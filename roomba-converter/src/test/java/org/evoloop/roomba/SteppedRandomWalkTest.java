package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Random;
import java.util.stream.LongStream;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever buttons are pressed, shortly afterwards the converter knows the robot's true activity, and the robot is in
 * the right mode.
 */
class SteppedRandomWalkTest {
    private static final int STEPS = 200;

    private static final Duration SOON = Duration.ofMillis(500);

    /** No packet reports the end of a spot cleaning; it is inferred after a second of rest. */
    private static final Duration SPOT_END_SHOWS = Duration.ofMillis(1_100);

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 5), LongStream.of(new Random().nextLong()));
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void theConverterKnowsWhatTheRobotDoes(long seed) {
        Random random = new Random(seed);
        RobotOptions shortSpots =
                RobotOptions.builder().spotDurationMillis(8_000).build();
        try (SteppedRoomba roomba = new SteppedRoomba(shortSpots)) {
            for (int step = 0; step < STEPS; step++) {
                String what = doSomething(roomba, random);
                try {
                    roomba.advance(SOON).until(() -> agree(roomba), SPOT_END_SHOWS);
                } catch (AssertionError disagreement) {
                    throw new AssertionError("after step " + step + " (" + what + ") with seed " + seed, disagreement);
                }
            }
            ConverterStatus.EventCounts counts =
                    roomba.roomba.converter().status().events();
            assertThat(counts.handled()).as("seed %d", seed).isGreaterThan(STEPS / 4);
            assertThat(counts.failed()).as("seed %d", seed).isZero();
        }
    }

    private static boolean agree(SteppedRoomba roomba) {
        RobotActivity activity = roomba.truth().activity();
        return roomba.states().original().name().equalsIgnoreCase(activity.name())
                && roomba.truth().oiMode() == (activity == RobotActivity.ON ? OiMode.SAFE : OiMode.PASSIVE);
    }

    private static String doSomething(SteppedRoomba roomba, Random random) {
        switch (random.nextInt(5)) {
            case 0 -> {
                roomba.press(RobotEvents.CLEAN);
                return "controller Clean";
            }
            case 1 -> {
                roomba.press(RobotEvents.SPOT);
                return "controller Spot";
            }
            case 2 -> {
                roomba.robotPress(Button.CLEAN);
                return "robot's CLEAN";
            }
            case 3 -> {
                // The original model does not contain that SPOT pauses cleaning, so SPOT is not pressed then.
                if (roomba.truth().activity() != RobotActivity.CLEAN) {
                    roomba.robotPress(Button.SPOT);
                }
                return "robot's SPOT";
            }
            default -> {
                Duration passing = Duration.ofMillis(random.nextInt(10_000));
                roomba.advance(passing);
                return passing + " pass";
            }
        }
    }
}
