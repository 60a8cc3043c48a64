package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.converter.LiveRobot.until;
import static org.evoloop.converter.Robot.at;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.Occurrence;
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

    private void assertRefused(String message) {
        assertThatThrownBy(() -> panel.press("Clean"))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage(message);
    }
}
