package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.concurrent.CountDownLatch;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Facts do not crowd out controllers' events, and these do not hold up functions. */
@Timeout(60)
class QueueRoomTest {

    @Test
    void whatTheDeviceDidDoesNotCrowdOutPresses() throws InterruptedException {
        try (Robot robot = new Robot(2)) {
            for (int acts = 0; acts < 100; acts++) {
                robot.panel.pressed("Clean", true);
                robot.converter.observe(robot.panel);
            }
            robot.panel.press("Clean");
            robot.panel.press("Clean");
            assertThatIllegalStateException().isThrownBy(() -> robot.panel.press("Clean"));
            assertThat(robot.converter.status().queue().depth()).isEqualTo(102);
            assertThat(robot.converter.status().queue().dropped())
                    .as("the third press")
                    .isEqualTo(1);

            robot.settle();
            assertThat(robot.last().detail()).as("of the second press").isEqualTo("not acceptable in Spot");
        }
    }

    @Test
    void aFunctionLeavesItsStateHoweverManyDeferredEventsWait() throws InterruptedException {
        StateMachine mill = StateMachine.named("original")
                .initial("Idle")
                .transition("Idle", "grind", "Grinding")
                .transition("Grinding", "grind", "Idle")
                .build();
        StateMachine cleanMill = StateMachine.named("new")
                .initial("Idle")
                .transition("Idle", "grind", "Grinding")
                .transition("Grinding", "grind", "Idle")
                .transition("Idle", "clean", "Cleaning")
                .transition("Cleaning", "cleaned", "Idle")
                .defers("Cleaning", new Event("grind"))
                .build();
        CountDownLatch full = new CountDownLatch(1);
        PushMonitor panel = new PushMonitor("Panel");
        RecordingExecute device = new RecordingExecute("Mill", "grind");
        try (SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults("mill", new ManualClock()).withQueueCapacity(2))) {
            converter.addMonitor(panel);
            converter.addExecute(device);
            converter.addKnowledge(new StateKnowledge(new ModelPair(mill, cleanMill)) {
                @Override
                protected void registerNewFunctions() {
                    function("Cleaning", visit -> {
                        LiveRobot.await(full);
                        visit.raise("cleaned");
                    });
                }
            });
            converter.build();
            converter.start();
            panel.press("clean");
            LiveRobot.until(() -> converter.history().size() == 1);
            panel.press("grind");
            panel.press("grind");
            assertThatIllegalStateException().isThrownBy(() -> panel.press("grind"));
            assertThat(converter.status().queue().dropped()).isEqualTo(1);

            full.countDown();
            LiveRobot.until(() -> converter.status().events().handled() == 4);
            assertThat(device.sent()).containsExactly("grind", "grind");
        }
    }
}
