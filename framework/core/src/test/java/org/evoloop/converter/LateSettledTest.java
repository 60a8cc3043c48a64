package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.LiveRobot.await;
import static org.evoloop.converter.LiveRobot.awaitDeaf;
import static org.evoloop.converter.LiveRobot.take;
import static org.evoloop.converter.LiveRobot.until;
import static org.evoloop.converter.Robot.at;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Outcome;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.loop.ComponentStatus.Activity;
import org.evoloop.loop.InEachThreading;
import org.evoloop.loop.ThreadingModel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Code that returns late from a hook does not touch what is to be done for the events that have followed. */
@InEachThreading
@Timeout(60)
class LateSettledTest {
    private final ThreadingModel threading;
    private final CountDownLatch hanging = new CountDownLatch(1);
    private final CountDownLatch atLast = new CountDownLatch(1);
    private final List<String> settled = new CopyOnWriteArrayList<>();

    /** What happens when a component settles. */
    private volatile Settling settling = (name, now) -> {};

    LateSettledTest(ThreadingModel threading) {
        this.threading = threading;
    }

    private interface Settling {
        void at(String name, Configuration now) throws InterruptedException;
    }

    private final class Half extends Part {
        Half(String name, String event) {
            super(name, event);
        }

        @Override
        protected void settled(Configuration now) throws InterruptedException {
            settled.add(name() + " " + now);
            settling.at(name(), now);
        }
    }

    private LiveRobot robot() {
        return new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(new Half("Cleaner", "Clean"));
            made.converter.addExecute(new Half("Spotter", "Spot"));
        });
    }

    @Test
    void theNextEventSettlesInItsOwnStateOnly() throws InterruptedException {
        try (LiveRobot robot = robot()) {
            settling = (name, now) -> {
                hanging.countDown();
                awaitDeaf(atLast);
            };
            robot.panel.press("Clean");
            await(hanging);
            robot.clock.advance(LiveRobot.STEP_LIMIT);
            settled.clear();
            settling = (name, now) -> {};
            atLast.countDown();
            until(() -> robot.component("Cleaner").activity() != Activity.STUCK);

            robot.press("Clean");
            until(() -> settled.size() >= 2);
            robot.press("Spot");
            assertThat(settled).startsWith("Cleaner (Clean, Clean)", "Spotter (Clean, Clean)");
        }
    }

    @Test
    void everyComponentSettlesAlthoughAPlanComponentReturnsMeanwhile() throws InterruptedException {
        List<Thread> planning = new CopyOnWriteArrayList<>();
        EventPlan deaf = new EventPlan("Deaf") {
            @Override
            protected ChangePlan plan(Analysis analysis) {
                planning.add(Thread.currentThread());
                hanging.countDown();
                awaitDeaf(atLast);
                return new ChangePlan(analysis.occurrence(), analysis.decision());
            }
        };
        try (LiveRobot robot = robot()) {
            robot.press("Clean", "Clean", "Clean").awaitSpotWait();
            robot.converter.exchange("EventPlan", deaf);
            robot.panel.press("Clean");
            await(hanging);
            robot.converter.exchange("Deaf", new EventPlan());
            robot.awaitHistory(4);
            settled.clear();
            settling = (name, now) -> {
                atLast.countDown();
                planning.get(0).join();
            };

            robot.press("Clean");
            until(() -> robot.component("Cleaner").activity() != Activity.WORKING
                    && robot.component("Spotter").activity() != Activity.WORKING
                    && settled.size() >= 2);
            assertThat(settled).containsExactly("Spotter (Spot, Spot)", "Cleaner (Spot, Spot)");
        }
    }

    @Test
    void anEndingThatReturnsAfterTheNextStartTakesNoStepAway() throws InterruptedException {
        CountDownLatch leaving = new CountDownLatch(1);
        CountDownLatch mayLeave = new CountDownLatch(1);
        List<Thread> ending = new CopyOnWriteArrayList<>();
        List<Visit> moves = new CopyOnWriteArrayList<>();
        try (LiveRobot robot = new LiveRobot(threading, visit -> {
            boolean first = moves.isEmpty();
            visit.onEnd(() -> {
                ending.add(Thread.currentThread());
                (first ? hanging : leaving).countDown();
                awaitDeaf(first ? atLast : mayLeave);
            });
            moves.add(visit);
        })) {
            robot.press("Clean", "Spot");
            until(() -> moves.size() == 1);
            until(robot.converter::stop);
            robot.converter.start();
            until(() -> moves.size() == 2);
            moves.get(1).finish("arriveSpot");
            await(leaving);
            atLast.countDown();
            ending.get(0).join();
            mayLeave.countDown();

            assertThat(robot.awaitHistory(3).outcome()).isEqualTo(Outcome.HANDLED);
            assertThat(take(robot.sent)).isEqualTo("Device:Clean");
            assertThat(take(robot.sent)).isEqualTo("Device:Spot");
            assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
        }
    }
}
