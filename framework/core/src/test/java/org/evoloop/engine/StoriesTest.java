package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.evoloop.engine.Scene.Act;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Paths through exploration's world, along which {@code ./evoloop study --check} also runs the specification in {@code
 * prism/proof}. If the core was changed on purpose, copy the failure's output into the file, and adapt the
 * specification.
 */
class StoriesTest {
    private static final Path GOLDEN = Path.of(System.getProperty("evoloop.root"), "prism", "proof", "golden");
    private static final int MOST = 60;

    static Stream<Arguments> pairs() {
        return Stream.of(
                Arguments.of("robot", everything(Scene.robot())),
                Arguments.of("bulb", everything(Scene.bulb())),
                Arguments.of("fan", boosts()),
                Arguments.of("lift", alarms()));
    }

    /** The fan is mostly pressed, so that it is often on its way to the state that its boost needs. */
    private static Scene boosts() {
        return DeviceStateScenes.fan()
                .with(5, Act.PRESS)
                .with(2, Act.GIVE_UP, Act.END, Act.OWN)
                .with(1, Act.FAIL, Act.JUMP);
    }

    /** The elevator is pressed most of all, so that the alarm often comes while something is under way or waits. */
    private static Scene alarms() {
        return Scene.lift().with(12, Act.PRESS).with(1, Act.GIVE_UP, Act.OWN, Act.JUMP, Act.FAIL, Act.END);
    }

    private static Scene everything(Scene scene) {
        return scene.with(4, Act.PRESS)
                .with(2, Act.OWN, Act.RAISE, Act.STOP, Act.GIVE_UP, Act.END, Act.FAIL)
                .with(1, Act.JUMP, Act.ASK, Act.CHANGE);
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void goAsTheyWent(String name, Scene scene) throws IOException {
        String stories = LongStream.rangeClosed(1, 40)
                .mapToObj(seed -> Story.of(seed % 2 == 0 ? scene : scene.mute().outOfOrder(), seed, MOST))
                .collect(Collectors.joining());

        assertThat(stories).isEqualTo(Files.readString(GOLDEN.resolve(name + ".stories.txt")));
    }
}
