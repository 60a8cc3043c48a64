package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** The core's inputs along one random path through a scene. */
final class RandomStory {
    private RandomStory() {}

    /** @param length how many things happen, including those that the core does not notice */
    static List<Input> of(Scene scene, Random random, int length) {
        List<Input> inputs = new ArrayList<>();
        List<Output> said = new ArrayList<>();
        Core core = new Core(scene.rules(), said::add);
        World world = new World(scene);
        for (int time = 1; time <= length; time++) {
            Move move = Moves.any(core.snapshot(), world, time, random);
            if (move == null) {
                return inputs;
            }
            world = move.world();
            Input input = move.input();
            if (input != null) {
                said.clear();
                core.apply(input);
                world.heard(input, said, core.snapshot());
                inputs.add(input);
            }
        }
        return inputs;
    }
}
