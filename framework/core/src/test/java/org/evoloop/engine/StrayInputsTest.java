package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.evoloop.engine.codec.SnapshotText;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Inputs at a time when no shell brings them, as from a damaged journal: none makes the core fail. */
class StrayInputsTest {
    private static final int SEQUENCES = 500;
    private static final int INPUTS = 60;

    static Stream<Scene> scenes() {
        return Stream.of(Scene.robot(), Scene.bulb());
    }

    @Test
    void anEffectThatWasNotBegunDoesNotCount() {
        ScriptedCore core = new ScriptedCore(Scene.bulb()).press("switch").ready();
        Work before = core.work();

        core.input(new Input.EffectRun(core.number(), "", 9));

        assertThat(core.work()).isEqualTo(before);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void anySequenceOfInputsLeavesAStateThatCanBeStored(Scene scene) {
        for (int seed = 0; seed < SEQUENCES; seed++) {
            Random random = new Random(seed);
            ScriptedCore core = new ScriptedCore(scene);
            for (int count = 0; count < INPUTS; count++) {
                step(core, random);
            }
            Snapshot last = core.core.snapshot();
            assertThat(SnapshotText.read(core.core.rules(), SnapshotText.write(last)))
                    .as("seed %d", seed)
                    .isEqualTo(last);
        }
    }

    private static void step(ScriptedCore core, Random random) {
        Work work = core.core.snapshot().work();
        long present = work == null ? 0 : work.pending().number();
        long number = random.nextInt(3) == 0 ? present + random.nextInt(3) - 1 : present;
        long now = random.nextInt(100);
        List<State> states =
                List.copyOf(core.core.rules().table().models().original().states());
        List<Event> events =
                List.copyOf(core.core.rules().table().models().evolved().events());
        State state = states.get(random.nextInt(states.size()));
        Event event = events.get(random.nextInt(events.size()));
        switch (random.nextInt(15)) {
            case 0 -> core.input(new Input.Opened(now));
            case 1 -> core.input(new Input.Closing());
            case 2 -> core.input(new Input.Closed());
            case 3 -> core.input(new Input.Recovered(now));
            case 4, 5 -> core.press(event.name());
            case 6 -> core.own(event.name());
            case 7 -> core.found(state.name());
            case 8 -> core.ready();
            case 9 -> {
                if (work != null) {
                    core.planned();
                }
            }
            case 10 -> core.input(new Input.Sending(number));
            case 11 -> core.input(new Input.Sent(number, random.nextBoolean(), now));
            case 12 -> core.input(new Input.EffectRun(number, random.nextBoolean() ? "" : "it broke", now));
            case 13 -> core.input(new Input.Located(number, random.nextBoolean() ? state : null, now));
            default ->
                core.input(
                        random.nextBoolean()
                                ? new Input.GivenUp(number, "it was given up", now)
                                : new Input.Failed(number, "it failed", now));
        }
    }
}
