package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;
import static org.evoloop.converter.Robot.at;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.Set;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** Monitors made from a function. */
class PollingMonitorTest {
    private final Queue<String> events = new ArrayDeque<>();

    private final RecordingExecute device = new RecordingExecute("Device", "play");

    /** Where a music player is after {@code monitor} has reported {@code event}. */
    private Configuration after(String event, PollingMonitor monitor) throws InterruptedException {
        try (SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults("player", new ManualClock()).withoutThreads())) {
            converter.addMonitor(monitor);
            converter.addExecute(device);
            converter.addKnowledge(new StateKnowledge(new ModelPair(
                    machine("original", "Stopped play -> Playing"), machine("new", "Stopped play -> Playing"))));
            converter.build();
            converter.start();
            events.add(event);
            converter.observe(monitor);
            converter.observe(monitor);
            assertThat(converter.step()).isTrue();
            assertThat(converter.step()).isFalse();
            return converter.knowledge().configuration();
        }
    }

    @Test
    void whatItSeesOfTheControllerIsSentToTheDevice() throws InterruptedException {
        assertThat(after("play", PollingMonitor.ofController("Remote", Duration.ofMillis(50), events::poll)))
                .isEqualTo(at("Playing", "Playing"));
        assertThat(device.sent()).containsExactly("play");
    }

    @Test
    void whatItSeesTheDeviceDoIsNotSent() throws InterruptedException {
        assertThat(after("play", PollingMonitor.ofDevice("Disc", Duration.ofSeconds(1), Set.of("play"), events::poll)))
                .isEqualTo(at("Playing", "Playing"));
        assertThat(device.sent()).isEmpty();
    }

    @Test
    void aPeriodOfZeroIsRefused() {
        assertThatThrownBy(() -> PollingMonitor.ofController("Remote", Duration.ZERO, events::poll))
                .hasMessage("the period of Remote is zero; a monitor that waits by itself extends EventMonitor");
    }
}
