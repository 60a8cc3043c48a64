package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.evoloop.engine.Scene.Act;
import org.evoloop.rehearsal.Comparison;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whatever happens to a converter, the same models beside it decide the same. */
class SameModelsTest {
    private static final int LENGTH = 120;

    /** In these, a doubt from before the comparison is settled late, or a press too old ends another's visit. */
    private static final long[] RARE = {
        3224647957794528644L, 5587108819434192134L, -1196694759062514379L, -6408328380651812641L
    };

    static LongStream seeds() {
        LongStream common = LongStream.concat(LongStream.rangeClosed(1, 1000), LongStream.of(RARE));
        return LongStream.concat(common, LongStream.of(new Random().nextLong()));
    }

    /** A random pair, or one of the paper's; with any adapter, device, queue and age of presses. */
    private static Scene scene(long seed, Random random) {
        List<Scene> scenes = List.of(RandomPair.scene(seed), Scene.robot(), Scene.bulb(), Scene.lamp());
        Scene scene = scenes.get(random.nextInt(8) % scenes.size()).withQueue(random.nextInt(9));
        scene = scene.with(6, Act.values())
                .with(20, Act.PRESS, Act.OWN, Act.RAISE)
                .with(0, Act.EVOLVE);
        if (random.nextInt(3) == 0) {
            scene = scene.withPressAge(1 + random.nextInt(40));
        }
        return scene.kinds().get(random.nextInt(4));
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void neverDiffer(long seed) {
        compare(seed);
    }

    @Test
    @Tag("slow")
    void neverDifferInTenThousandRuns() {
        new Random(47).longs(10_000).forEach(SameModelsTest::compare);
    }

    private static void compare(long seed) {
        Random random = new Random(seed);
        Scene scene = scene(seed, random);
        List<Input> story = RandomStory.of(scene, random, LENGTH);
        int begins = random.nextInt(3) == 0 ? random.nextInt(story.size() + 1) : 0;
        List<String> told = new ArrayList<>();
        List<String> differences = new ArrayList<>();
        Comparison comparison = new Comparison(
                (occurrence, then, now) -> {
                    if (then == null || now == null || !then.isSame(now)) {
                        differences.add(occurrence + ": " + then + " | " + now);
                    }
                },
                ending -> {});
        Core core = new Core(scene.rules(), comparison.hears());
        for (Input input : story) {
            if (!comparison.hasBegun() && told.size() >= begins && isBetweenEvents(core)) {
                comparison.begin(core, scene.rules(), core.snapshot());
            }
            core.apply(input);
            told.add(input.toString());
            if (comparison.hasBegun()) {
                comparison.took(input);
                assertThat(differences)
                        .as("seed %d, %s, from input %d%n%s", seed, scene, begins, String.join("\n", told))
                        .isEmpty();
            }
        }
        if (comparison.hasBegun()) {
            assertThat(comparison.at()).as("seed %d", seed).isEqualTo(core.at());
            comparison.end();
            assertThat(differences).as("seed %d", seed).isEmpty();
        }
    }

    private static boolean isBetweenEvents(Core core) {
        return !core.isBusy() && core.doubt().isEmpty();
    }
}
