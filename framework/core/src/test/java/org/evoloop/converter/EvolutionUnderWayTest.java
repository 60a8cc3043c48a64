package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.evoloop.PaperModels;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.InEachThreading;
import org.evoloop.loop.QueueStatus;
import org.evoloop.loop.ThreadingModel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Models are replaced while events go through the loop. */
@InEachThreading
@Timeout(60)
class EvolutionUnderWayTest {
    private static final int SWAPS = 20;

    private final ThreadingModel threading;

    EvolutionUnderWayTest(ThreadingModel threading) {
        this.threading = threading;
    }

    /** A robot without the detour from cleaning to spot cleaning. */
    private static StateKnowledge simple() {
        return new StateKnowledge(new ModelPair(
                PaperModels.cleaningRobot().original(),
                machine(
                        "simple",
                        "Off Clean -> On",
                        "On Clean -> Clean",
                        "Clean Clean -> On",
                        "On Spot -> Spot",
                        "Spot endSpot -> On")));
    }

    @Test
    void itWaitsUntilAStateThatHasNoSuccessorIsLeft() throws Exception {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none())) {
            robot.press("Clean", "Clean", "Clean").awaitSpotWait();
            CompletableFuture<Evolution.Result> evolved =
                    CompletableFuture.supplyAsync(() -> robot.converter.evolve(Evolution.to(simple())));
            robot.clock.advance(Duration.ofSeconds(5));
            assertThat(evolved.get().before()).hasToString("(On, On)");
            robot.press("Spot");
            robot.awaitStates("Spot", "Spot");
        }
    }

    @Test
    void itGivesUpWhenItsTimeIsOver() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        try (LiveRobot robot = new LiveRobot(threading, visit -> begun.countDown())) {
            robot.press("Clean", "Spot");
            LiveRobot.await(begun);
            robot.awaitStates("On", "Move");
            assertThatThrownBy(
                            () -> robot.converter.evolve(Evolution.to(simple()).withDeadline(Duration.ZERO)))
                    .isInstanceOf(EvolutionException.class)
                    .hasMessage(
                            "the converter robot has not evolved to 'simple' within 0 s: the next new model has no state"
                                    + " Move; map it: state Move -> STATE");
            assertThat(robot.converter.knowledge().models().evolved().name()).isEqualTo("new");
        }
    }

    @Test
    void noEventOfMovesAndNoneOfThoseThatAreUnderWayIsLost() throws Exception {
        AtomicBoolean enough = new AtomicBoolean();
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none())) {
            CompletableFuture<Long> pressing = CompletableFuture.supplyAsync(() -> {
                long presses = 0;
                while (!enough.get()) {
                    presses++;
                    try {
                        robot.panel.press("Clean");
                    } catch (IllegalStateException full) {
                        assertThat(full).hasMessageContaining("full queue");
                    }
                }
                return presses;
            });
            for (int swap = 0; swap < SWAPS; swap++) {
                robot.converter.evolve(Evolution.to(simple()).withDeadline(Duration.ofDays(1)));
                robot.converter.rollBack();
            }
            enough.set(true);
            long presses = pressing.get();
            LiveRobot.until(() -> robot.converter.status().queue().depth() == 0);
            robot.converter.stop();
            ConverterStatus status = robot.converter.status();
            QueueStatus queue = status.queue();
            assertThat(status.events().handled()
                            + status.events().ignored()
                            + status.events().stale()
                            + status.events().failed()
                            + queue.dropped())
                    .isEqualTo(presses);
        }
    }
}
