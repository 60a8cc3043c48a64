package org.evoloop.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/**
 * Work that was given up while it still waited for its thread is never begun. The test plays the role of the threads.
 */
@InEachThreading
class GivenUpBeforeItBeganTest {
    private final List<Object> begun = new ArrayList<>();
    private final Crew crew;
    private final StageWorker<Object> stage;

    GivenUpBeforeItBeganTest(ThreadingModel threading) {
        LoopConfig config = LoopConfig.defaults("late", new ManualClock()).withThreading(threading);
        crew = new Crew(config);
        stage = new StageWorker<>(
                new Relay.Brain(),
                crew,
                new Sequencer<>(
                        config,
                        new Strict(),
                        new PlainQueue<>(1),
                        new Pipeline<>("loop", Dispatch.toEach()),
                        new LoopLock()),
                (by, input) -> {
                    begun.add(input);
                    return null;
                });
    }

    private static final class Strict implements LoopListener<Object> {
        @Override
        public void failed(Failure<Object> failure) {
            throw new AssertionError(failure.toString(), failure.cause());
        }

        @Override
        public void dropped(Object occurrence, boolean first) {
            throw new AssertionError(occurrence + " was dropped");
        }
    }

    @Test
    void theComponentIsNotCalledAndIsStuckNoLonger() {
        CarrierThread late = stage.give(1, "given up");
        stage.giveUp(1);
        assertThat(stage.isStuck()).isTrue();

        late.ended();
        crew.retire();

        assertThat(begun).isEmpty();
        assertThat(stage.isStuck()).isFalse();
    }
}
