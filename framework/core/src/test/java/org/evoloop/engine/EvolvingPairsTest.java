package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.LongStream;
import org.evoloop.engine.Scene.Act;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.migration.Mapping;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Any models can replace any others wherever a migration exists. */
class EvolvingPairsTest {
    private static final int LENGTH = 40;
    private static final List<String> STATES = List.of("A", "B", "C", "N", "W");
    private static final Map<Act, Integer> TIMES = Map.of(Act.EVOLVE, 3, Act.END, 1, Act.STOP, 1);

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 500), LongStream.of(new Random().nextLong()));
    }

    static LongStream manySeeds() {
        return new Random(20).longs(10_000);
    }

    /** A scene in which one random pair replaces another, by a random mapping, and back. */
    private static Scene scene(long seed) {
        Random random = new Random(seed);
        Mapping mapping = Mapping.byName();
        for (String state : STATES) {
            if (random.nextInt(4) == 0) {
                mapping = mapping.withState(new State(state), new State(STATES.get(random.nextInt(STATES.size()))));
            }
        }
        Scene scene = RandomPair.scene(seed)
                .evolvingTo(RandomPair.other(seed, random.nextLong()), mapping)
                .with(2, Act.values());
        for (Map.Entry<Act, Integer> times : TIMES.entrySet()) {
            scene = scene.with(times.getKey(), times.getValue());
        }
        return scene.kinds().get(random.nextInt(4));
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void nothingIsLostOrWrong(long seed) {
        follow(scene(seed), new Random(seed));
    }

    @Test
    @Tag("slow")
    void nothingIsLostOrWrongInTenThousand() {
        manySeeds().forEach(seed -> follow(scene(seed), new Random(seed)));
    }

    private static void follow(Scene scene, Random random) {
        List<String> story = new ArrayList<>();
        Snapshot now = new Core(scene.rules(), output -> {}).snapshot();
        World world = new World(scene);
        for (int time = 1; time <= LENGTH; time++) {
            Move move = Moves.any(now, world, time, random);
            if (move == null) {
                return;
            }
            Rules rules = world.rules();
            Snapshot before = now;
            world = move.world();
            story.add(move.what());
            List<Output> said = List.of();
            Input input = move.input();
            if (input != null) {
                Wiring.Result result = Wiring.REAL.apply(rules, before, input);
                said = result.said();
                now = result.after();
                world.heard(input, said, now);
            }
            assertThat(Invariants.check(before, input, said, now, world))
                    .as("%s%n%s", scene, String.join("\n", story))
                    .isEmpty();
        }
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void anEqualModelChangesNothing(long seed) {
        Scene scene = RandomPair.scene(seed).with(2, Act.values()).with(0, Act.EVOLVE);
        ModelPair same = RandomPair.models(seed);
        Rules equal = scene.rules()
                .with(DecisionTable.compile(same, scene.rules().table().device()));
        List<Input> story = RandomStory.of(scene, new Random(seed), LENGTH);
        List<Output> swapped = new ArrayList<>();
        List<Output> said = new ArrayList<>();
        Core one = new Core(scene.rules(), said::add);
        Core other = new Core(scene.rules(), swapped::add);
        for (Input input : story) {
            other.evolved(Swap.of(other.rules(), equal, Mapping.byName()), other.nowNanos());
            one.apply(input);
            other.apply(input);
            assertThat(withoutSwaps(swapped)).isEqualTo(said);
            assertThat(other.snapshot()).isEqualTo(one.snapshot());
        }
    }

    private static List<Output> withoutSwaps(List<Output> outputs) {
        return outputs.stream()
                .filter(output -> !(output instanceof Output.Evolved) && !(output instanceof Output.CarryOver))
                .toList();
    }

    /**
     * Only where device and evolved system are in the same state; elsewhere the next models have paths of their own.
     */
    @ParameterizedTest
    @MethodSource("seeds")
    void aSwapWithItsRollbackEqualsNone(long seed) {
        Scene scene = RandomPair.scene(seed).with(2, Act.values()).with(0, Act.EVOLVE);
        Scene more = RandomPair.more(seed);
        List<Input> story = RandomStory.of(scene, new Random(seed), LENGTH);
        List<Output> swapped = new ArrayList<>();
        List<Output> said = new ArrayList<>();
        Core one = new Core(scene.rules(), said::add);
        Core other = new Core(scene.rules(), swapped::add);
        for (Input input : story) {
            if (scene.rules().table().standsTogether(other.at())) {
                other.evolved(Swap.of(other.rules(), more.rules(), Mapping.byName()), other.nowNanos());
            }
            other.evolved(Swap.of(other.rules(), scene.rules(), Mapping.byName()), other.nowNanos());
            assertThat(other.rules()).isEqualTo(scene.rules());
            one.apply(input);
            other.apply(input);
            assertThat(withoutSwaps(swapped)).isEqualTo(said);
            assertThat(other.snapshot()).isEqualTo(one.snapshot());
        }
    }
}
