package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.evoloop.engine.Scene.Act;
import org.evoloop.engine.codec.SnapshotText;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The same inputs give the same outputs and the same next state, also if the state is saved and restored after each.
 */
class DeterminismTest {
    private static final int STORIES = 1_000;
    private static final int LENGTH = 25;

    private final List<Output> saidAgain = new ArrayList<>();

    /** Goes from one story to the next. */
    private final Core second = new Core(Scene.bulb().rules(), saidAgain::add);

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 2), LongStream.of(new Random().nextLong()));
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void aThousandStoriesAreRepeatable(long seed) {
        Random random = new Random(seed);
        List<Scene> scenes = new ArrayList<>(Scene.robot().with(3, Act.values()).kinds());
        scenes.addAll(Scene.bulb().with(3, Act.values()).kinds());
        scenes.addAll(Scene.dancingRobot().with(3, Act.values()).kinds());
        scenes.addAll(Scene.busyRobot().with(3, Act.values()).kinds());
        scenes.addAll(Scene.lamp().with(3, Act.values()).kinds());
        scenes.addAll(RandomPair.scene(seed).with(3, Act.values()).kinds());
        for (int story = 0; story < STORIES; story++) {
            Scene scene = scenes.get(random.nextInt(scenes.size()));
            assertRepeatable(scene, RandomStory.of(scene, random, LENGTH));
        }
    }

    /** The search for similar names is slow, so its last result is kept; but not beyond the models for which it is true. */
    @Test
    void similarNamesAreThoseOfTheModelsInForce() {
        Event misspelt = new Event("claen");
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press(misspelt.name());

        core.input(new Input.Changed(Scene.robot().rules(), 9)).press(misspelt.name());

        String robots = Scene.robot().rules().table().names().unknown(misspelt);
        assertThat(robots).contains("Clean");
        assertThat(((Output.Ended) core.said.get(core.said.size() - 1)).detail())
                .isEqualTo(robots);
    }

    private void assertRepeatable(Scene scene, List<Input> inputs) {
        List<Output> said = new ArrayList<>();
        Core first = new Core(scene.rules(), said::add);
        second.restore(scene.rules(), first.snapshot());
        Snapshot restored = second.snapshot();
        for (Input input : inputs) {
            said.clear();
            saidAgain.clear();
            Rules before = first.rules();
            first.apply(input);
            second.apply(input);
            Wiring.Result afterRestoring = Wiring.REAL.apply(before, restored, input);
            restored = SnapshotText.read(first.rules(), SnapshotText.write(afterRestoring.after()));

            if (!said.equals(saidAgain) || !said.equals(afterRestoring.said())) {
                assertThat(List.of(saidAgain, afterRestoring.said()))
                        .as("%s after %s", scene, inputs)
                        .containsOnly(said);
            }
            if (!first.snapshot().equals(second.snapshot()) || !first.snapshot().equals(restored)) {
                assertThat(List.of(second.snapshot(), restored))
                        .as("%s after %s", scene, inputs)
                        .containsOnly(first.snapshot());
            }
        }
    }
}
