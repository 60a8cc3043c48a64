package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.LiveRobot.await;
import static org.evoloop.converter.LiveRobot.awaitDeaf;
import static org.evoloop.converter.LiveRobot.until;
import static org.evoloop.converter.Robot.at;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.InEachThreading;
import org.evoloop.loop.ThreadingModel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** One of two execute components hangs; only what it would have to send fails. */
@InEachThreading
@Timeout(60)
class StuckSenderTest {
    private final ThreadingModel threading;
    private final CountDownLatch hanging = new CountDownLatch(1);
    private final CountDownLatch atLast = new CountDownLatch(1);
    private final List<String> settled = new CopyOnWriteArrayList<>();

    StuckSenderTest(ThreadingModel threading) {
        this.threading = threading;
    }

    private final class Half extends Part {
        Half(String name, String event) {
            super(name, event);
        }

        @Override
        protected void send(Step step) {
            if (event.equals("Clean")) {
                hanging.countDown();
                awaitDeaf(atLast);
            }
        }

        @Override
        protected Optional<String> locate() {
            return Optional.of("On");
        }

        @Override
        protected void settled(Configuration now) {
            settled.add(name() + " in " + now.evolved());
        }
    }

    @Test
    void theOtherIsAskedWhereTheDeviceIsAndCarriesOutTheRest() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(new Half("Cleaner", "Clean"));
            made.converter.addExecute(new Half("Spotter", "Spot"));
        })) {
            robot.panel.press("Clean");
            await(hanging);
            settled.clear();
            robot.clock.advance(LiveRobot.STEP_LIMIT);

            HistoryEntry doubt = robot.awaitHistory(2);
            assertThat(doubt.detail()).isEqualTo("the device was found in On");
            assertThat(doubt.after()).isEqualTo(at("On", "On"));
            assertThat(robot.converter.status().doubt()).isEmpty();

            robot.press("Clean");
            assertThat(robot.awaitHistory(3).outcome()).isEqualTo(Outcome.FAILED);
            robot.press("Spot");
            assertThat(robot.states()).isEqualTo(at("On", "Move"));
            until(() -> settled.contains("Spotter in Move"));
            assertThat(settled).containsExactly("Spotter in On", "Spotter in Move");
            atLast.countDown();
        }
    }
}
