package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.evoloop.engine.Scene.Act;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whatever happens in whatever order, the number of observed events is the sum of the outcomes' counts. */
class SumTest {
    private static final int STORIES = 500;
    private static final int LENGTH = 60;

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 4), LongStream.of(new Random().nextLong()));
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void ofRandomSchedules(long seed) {
        Random random = new Random(seed);
        List<Scene> scenes = new ArrayList<>(Scene.robot().with(5, Act.values()).kinds());
        scenes.addAll(Scene.bulb().with(5, Act.values()).kinds());
        scenes.addAll(RandomPair.scene(seed).with(5, Act.values()).kinds());
        for (int story = 0; story < STORIES; story++) {
            Scene scene = scenes.get(random.nextInt(scenes.size()));
            List<Input> inputs = RandomStory.of(scene, random, LENGTH);
            Core core = new Core(scene.rules(), output -> {});
            for (Input input : inputs) {
                core.apply(input);
                Tally tally = core.tally();
                long ended = tally.handled()
                        + tally.ignored()
                        + tally.stale()
                        + tally.failed()
                        + tally.dropped()
                        + tally.refused();
                long sum = ended + core.waiting() + (core.isBusy() ? 1 : 0);
                if (sum != tally.observed()) {
                    assertThat(sum)
                            .as("%s after %s of %s", tally, input, inputs)
                            .isEqualTo(tally.observed());
                }
            }
        }
    }
}
