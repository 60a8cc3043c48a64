package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.InEachThreading;
import org.evoloop.loop.ThreadingModel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Events wait in the queue, not at the device: while a step is being prepared or sent, nothing else begins, and the
 * order is kept.
 */
@InEachThreading
@Timeout(60)
class BackPressureTest {
    private final ThreadingModel threading;

    BackPressureTest(ThreadingModel threading) {
        this.threading = threading;
    }

    @Test
    void nothingBeginsWhileAStepIsMadeReadyForAndSent() {
        LinkedBlockingQueue<Integer> depths = new LinkedBlockingQueue<>();
        try (LiveRobot robot = new LiveRobot(
                threading,
                NewFunction.none(),
                8,
                made -> made.converter.addExecute(new EventExecute("Device") {
                    @Override
                    protected Set<String> sendableEvents() {
                        return Set.of("Clean", "Spot");
                    }

                    @Override
                    protected void awaitReady(Step step) {
                        pressOnceMore();
                    }

                    @Override
                    protected void send(Step step) {
                        pressOnceMore();
                    }

                    private void pressOnceMore() {
                        made.panel.press("timeout");
                        depths.add(made.converter.status().queue().depth());
                    }
                }))) {
            robot.panel.press("Clean");
            robot.awaitHistory(3);

            assertThat(depths).as("how many waited after each press").containsExactly(1, 2);
        }
    }

    /** A robot that sends its first step until {@code proceed}. */
    private LiveRobot sending(int queueCapacity, CountDownLatch proceed) throws InterruptedException {
        CountDownLatch sending = new CountDownLatch(1);
        LiveRobot robot = new LiveRobot(
                threading,
                NewFunction.none(),
                queueCapacity,
                made -> made.converter.addExecute(made.device("Device", step -> {
                    sending.countDown();
                    LiveRobot.await(proceed);
                })));
        robot.panel.press("Clean");
        LiveRobot.await(sending);
        return robot;
    }

    @Test
    void firstComeIsFirstServed() throws InterruptedException {
        CountDownLatch proceed = new CountDownLatch(1);
        try (LiveRobot robot = sending(8, proceed)) {
            List<String> pressed =
                    List.of("timeout", "Clean", "arriveSpot", "Clean", "timeout", "arriveSpot", "Clean", "timeout");
            pressed.forEach(robot.panel::press);
            proceed.countDown();
            robot.awaitHistory(9);

            assertThat(robot.converter.history().subList(1, 9))
                    .extracting(entry -> entry.occurrence().label())
                    .containsExactlyElementsOf(pressed);
        }
    }

    @Test
    void aPressForWhichThereIsNoRoomFails() throws InterruptedException {
        CountDownLatch proceed = new CountDownLatch(1);
        try (LiveRobot robot = sending(1, proceed)) {
            robot.panel.press("timeout");

            for (int again = 0; again < 2; again++) {
                assertThatIllegalStateException()
                        .isThrownBy(() -> robot.panel.press("Clean"))
                        .withMessage("the converter robot has a full queue, so Clean is dropped; try again when it has "
                                + "handled the events that wait");
            }
            proceed.countDown();
            robot.awaitHistory(4);

            assertThat(robot.converter.status().queue().dropped()).isEqualTo(2);
        }
    }
}
