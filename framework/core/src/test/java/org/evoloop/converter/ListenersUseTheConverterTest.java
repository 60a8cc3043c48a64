package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.evoloop.converter.recording.FailureLog;
import org.evoloop.converter.recording.Listeners;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** A listener may use the converter in every way, and hears what it was added for: no more, and in order. */
class ListenersUseTheConverterTest {
    private final ManualClock clock = new ManualClock();
    private final Listeners listeners =
            new Listeners(LoopConfig.defaults("notices", clock), new FailureLog(LoopConfig.defaults("notices", clock)));

    private static ConverterListener onDoubt(Consumer<String> heard) {
        return new ConverterListener() {
            @Override
            public void doubted(String why) {
                heard.accept(why);
            }
        };
    }

    private static void await(CountDownLatch latch) {
        try {
            assertThat(latch.await(10, TimeUnit.SECONDS)).isTrue();
        } catch (InterruptedException interrupted) {
            throw new AssertionError(interrupted);
        }
    }

    @Test
    void whatAListenerReportsOfTheDeviceIsNotLostWithoutThreads() {
        try (Player player = new Player(NewFunction.none())) {
            List<Configuration> heard = new ArrayList<>();
            player.converter.addListener(new ConverterListener() {
                @Override
                public void moved(Configuration before, Configuration after) {
                    heard.add(after);
                    if (after.original().name().equals("Playing")) {
                        player.converter.offer(new Occurrence.Found(new State("Stopped"), player.clock.nanoTime()));
                    }
                }
            });
            player.press("play");
            player.settle();
            assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
            assertThat(heard)
                    .containsExactly(
                            at("Playing", "Stopped"),
                            at("Playing", "Playing"),
                            at("Stopped", "Playing"),
                            at("Stopped", "Stopped"));
        }
    }

    @Test
    void anEventDuringWhichAListenerStopsTheConverterEndsOnce() {
        try (Player player = new Player(NewFunction.none())) {
            player.converter.addListener(new ConverterListener() {
                @Override
                public void moved(Configuration before, Configuration after) {
                    if (after.evolved().name().equals("Fading")) {
                        player.converter.stop();
                    }
                }
            });
            player.press("play");
            player.press("fade");
            player.settle();
            assertThat(player.outcomes()).containsExactly("play HANDLED", "fade HANDLED");
            player.converter.start();
            player.press("stop");
            player.settle();
            assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
            assertThat(player.converter.status().events())
                    .isEqualTo(new ConverterStatus.EventCounts(3, 3, 0, 0, 0, 0, 0, 0, 0));
        }
    }

    @Test
    void aRemovedListenerHearsNothingMoreAndItsCallInProgressIsNotInterrupted() throws InterruptedException {
        CountDownLatch called = new CountDownLatch(1);
        CountDownLatch removed = new CountDownLatch(1);
        BlockingQueue<Boolean> interrupted = new LinkedBlockingQueue<>();
        ConverterListener first = onDoubt(why -> {
            called.countDown();
            await(removed);
            interrupted.add(Thread.currentThread().isInterrupted());
        });
        listeners.add(first);
        listeners.doubted("one");
        listeners.doubted("two");
        await(called);
        listeners.remove(first);
        removed.countDown();
        assertThat(interrupted.poll(10, TimeUnit.SECONDS)).isFalse();
        listeners.close();
        assertThat(interrupted).isEmpty();
    }

    @Test
    void aListenerThatAnotherOneRemovesIsNotCalledAgain() {
        List<String> heard = new ArrayList<>();
        ConverterListener second = onDoubt(why -> heard.add("second " + why));
        listeners.add(onDoubt(why -> listeners.remove(second)));
        listeners.add(second);
        listeners.doubted("one");
        listeners.close();
        assertThat(heard).isEmpty();
    }

    @Test
    void aListenerIsNotToldWhatHappenedBeforeItWasAdded() {
        CountDownLatch added = new CountDownLatch(1);
        BlockingQueue<String> heard = new LinkedBlockingQueue<>();
        listeners.add(onDoubt(why -> await(added)));
        listeners.doubted("one");
        listeners.doubted("two");
        listeners.add(onDoubt(heard::add));
        listeners.doubted("three");
        added.countDown();
        listeners.close();
        assertThat(heard).containsExactly("three");
    }

    @Test
    void closingDoesNotInterruptACallThatReturnsInTime() throws InterruptedException {
        CountDownLatch called = new CountDownLatch(1);
        CountDownLatch release = new CountDownLatch(1);
        BlockingQueue<Boolean> interrupted = new LinkedBlockingQueue<>();
        listeners.add(onDoubt(why -> {
            called.countDown();
            await(release);
            interrupted.add(Thread.currentThread().isInterrupted());
        }));
        listeners.doubted("one");
        listeners.doubted("two");
        await(called);
        Thread closing = new Thread(listeners::close);
        closing.start();
        while (closing.getState() != Thread.State.TIMED_WAITING) {
            Thread.onSpinWait();
        }
        release.countDown();
        closing.join();
        assertThat(interrupted).containsExactly(false, false);
    }
}
