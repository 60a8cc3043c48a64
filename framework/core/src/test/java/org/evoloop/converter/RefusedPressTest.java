package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.converter.LiveRobot.until;
import static org.evoloop.converter.Robot.at;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A press while the converter does not run is refused with an exception. */
@Timeout(60)
class RefusedPressTest {
    private final PushMonitor panel = new PushMonitor("Panel");
    private final BlockingQueue<String> socket = new LinkedBlockingQueue<>();

    private SystemEventConverter robot(LoopConfig config) {
        SystemEventConverter converter = new SystemEventConverter(config);
        converter.addMonitor(panel);
        converter.addMonitor(new EventMonitor("Socket") {
            @Override
            protected Occurrence getEvent() throws InterruptedException {
                return fromController(socket.take());
            }
        });
        converter.addExecute(new RecordingExecute("Device", "Clean", "Spot"));
        StateKnowledge knowledge = new StateKnowledge(PaperModels.cleaningRobot());
        knowledge.function("Move", NewFunction.none());
        knowledge.function("SpotWait", NewFunction.none());
        converter.addKnowledge(knowledge);
        return converter;
    }

    @Test
    void beforeTheFirstStartAndWhileStoppedAlike() {
        try (SystemEventConverter converter = robot(LoopConfig.defaults("robot", new ManualClock()))) {
            converter.build();
            assertRefused("the converter robot is stopped, so Clean is refused; start it first");
            converter.start();
            panel.press("Clean");
            until(() -> converter.history().size() == 1);
            converter.stop();
            assertRefused("the converter robot is stopped, so Clean is refused; start it first");
            converter.start();
            panel.press("Clean");
            until(() -> converter.history().size() == 2);
            assertThat(converter.knowledge().configuration()).isEqualTo(at("Clean", "Clean"));
            assertThat(converter.status().queue().refused()).isEqualTo(2);
            converter.close();
            assertRefused("the converter robot is closed, so Clean is refused");
        }
    }

    @Test
    void inAConverterWithoutThreadsToo() {
        try (SystemEventConverter converter =
                robot(LoopConfig.defaults("robot", new ManualClock()).withoutThreads())) {
            assertRefused("Panel is not part of a converter that was built, so Clean is refused");
            converter.build();
            assertRefused("the converter robot is stopped, so Clean is refused; start it first");
            converter.start();
            converter.remove("Panel");
            assertRefused("Panel is not part of a converter that was built, so Clean is refused");
            assertThat(converter.step()).isFalse();
            assertThat(converter.status().queue().refused()).isEqualTo(1);
        }
    }

    @Test
    void whatAnyMonitorReportsBeforeTheFirstStartIsRefused() {
        try (SystemEventConverter converter = robot(LoopConfig.defaults("robot", new ManualClock()))) {
            socket.add("Clean");
            converter.build();
            until(() -> converter.status().queue().refused() == 1);
            converter.start();
            socket.add("Clean");
            until(() -> converter.history().size() == 1);
            assertThat(converter.knowledge().configuration()).isEqualTo(at("On", "On"));
        }
    }

    @Test
    void whatOnlyTheDeviceCanRaiseIsRefused() {
        try (SystemEventConverter converter = robot(LoopConfig.defaults("robot", new ManualClock()))) {
            converter.build();
            converter.start();
            assertThatThrownBy(() -> panel.press("endSpot"))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage(
                            "only the device itself can raise endSpot, so it cannot be pressed; a monitor reports it"
                                    + " with fromDevice");
            socket.add("endSpot");
            until(() -> converter.history().size() == 1);
            assertThat(converter.history().get(0).outcome()).isEqualTo(Outcome.IGNORED);
            assertThat(converter.status().doubt()).isEmpty();
        }
    }

    /** Whoever gets no exception has pressed, and whoever gets one has not, at every moment of a start and a stop. */
    @Test
    void pressTellsTheTruthWhileTheConverterIsStartedAndStopped() throws Exception {
        try (SystemEventConverter converter =
                robot(LoopConfig.defaults("robot", new ManualClock()).withQueueCapacity(1_000_000))) {
            converter.build();
            AtomicLong taken = new AtomicLong();
            AtomicBoolean over = new AtomicBoolean();
            Set<String> told = ConcurrentHashMap.newKeySet();
            List<Thread> people = new ArrayList<>();
            for (int person = 0; person < 4; person++) {
                people.add(new Thread(() -> {
                    while (!over.get()) {
                        try {
                            panel.press("Clean");
                            taken.incrementAndGet();
                        } catch (IllegalStateException refused) {
                            told.add(refused.getMessage());
                        }
                        Thread.yield();
                    }
                }));
            }
            people.forEach(Thread::start);
            for (int time = 0; time < 300; time++) {
                converter.start();
                Thread.yield();
                converter.stop();
            }
            over.set(true);
            for (Thread person : people) {
                person.join();
            }
            assertThat(told).containsExactly("the converter robot is stopped, so Clean is refused; start it first");
            assertThat(converter.status().queue().taken()).isEqualTo(taken.get());
        }
    }

    private void assertRefused(String message) {
        assertThatThrownBy(() -> panel.press("Clean"))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage(message);
    }
}
