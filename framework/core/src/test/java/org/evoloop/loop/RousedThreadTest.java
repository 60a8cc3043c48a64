package org.evoloop.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** A thread that is roused before its work is ready. The test plays the role of the threads. */
class RousedThreadTest {
    private final List<Object> worked = new ArrayList<>();
    private final LoopConfig config =
            LoopConfig.defaults("roused", new ManualClock()).withThreading(ThreadingModel.THREAD_PER_COMPONENT);
    private final CarrierThread thread = new CarrierThread(this, "first", config.waiting());
    private final CarrierThread next = new CarrierThread(this, "second", config.waiting());
    private final StageWorker<Object> stage = new StageWorker<>(
            new Relay.Brain(),
            new Crew(config),
            new Sequencer<>(config, new Silent(), new Backlog<>(1), new LoopLock()),
            (by, input) -> {
                worked.add(input);
                return null;
            });

    private static final class Silent implements LoopListener<Object> {
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
    void isOneThatSleeps() {
        thread.rouse();
        assertThat(thread.isRoused()).isFalse();

        thread.maySleep();
        thread.rouse();
        assertThat(thread.isRoused()).isTrue();
    }

    @Test
    void rousesTheOneThatFollows() {
        thread.precede(next);
        thread.maySleep();
        next.maySleep();

        thread.rouse();
        assertThat(next.isRoused()).isFalse();
        thread.lookOut();
        assertThat(next.isRoused()).isTrue();
    }

    @Test
    void isNotRousedAgainForNothingBeforeItHasWorked() {
        thread.maySleep();
        thread.rouse();
        thread.lookOut();
        thread.rouse();
        assertThat(thread.isRoused()).isFalse();

        stage.give(1, "work");
        thread.give(stage);
        thread.runGiven();
        assertThat(worked).containsExactly("work");
        thread.rouse();
        assertThat(thread.isRoused()).isTrue();
    }

    @Test
    void seesWorkThatComesWhileItLooksOut() {
        thread.maySleep();
        thread.rouse();
        stage.give(1, "work");
        thread.give(stage);
        thread.lookOut();
        thread.rouse();
        assertThat(thread.isRoused()).isTrue();
    }
}
