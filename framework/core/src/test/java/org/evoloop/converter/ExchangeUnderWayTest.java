package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;
import static org.evoloop.converter.LiveRobot.await;
import static org.evoloop.converter.LiveRobot.awaitDeaf;
import static org.evoloop.converter.LiveRobot.take;
import static org.evoloop.converter.LiveRobot.until;
import static org.evoloop.converter.Robot.at;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.ComponentStatus.Activity;
import org.evoloop.loop.InEachThreading;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.ThreadingModel;
import org.evoloop.statemachine.ModelException;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Components are exchanged and removed while a converter runs. */
@InEachThreading
@Timeout(60)
class ExchangeUnderWayTest {
    private final ThreadingModel threading;

    ExchangeUnderWayTest(ThreadingModel threading) {
        this.threading = threading;
    }

    private final CountDownLatch hanging = new CountDownLatch(1);
    private final CountDownLatch atLast = new CountDownLatch(1);

    /** A robot on the way from cleaning to spot cleaning, already paused, whose device hangs on the spot command. */
    private LiveRobot inTheMiddleOfTheDetour(LiveRobot.Taking hangs) throws InterruptedException {
        LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.device("Device", step -> {
                if (step.event().name().equals("Spot")) {
                    hangs.take(step);
                }
            }));
        });
        robot.press("Clean", "Clean", "Clean").awaitSpotWait();
        robot.panel.press("Clean");
        await(hanging);
        robot.sent.clear();
        return robot;
    }

    @Test
    void aComponentThatIsExchangedInTheMiddleOfADetourLeavesTheRestToTheNextPress() throws InterruptedException {
        try (LiveRobot robot = inTheMiddleOfTheDetour(step -> {
            hanging.countDown();
            atLast.await();
        })) {
            robot.converter.exchange("Device", robot.device("Spare"));

            HistoryEntry failed = robot.awaitHistory(4);
            assertThat(failed.outcome()).isEqualTo(Outcome.FAILED);
            assertThat(failed.detail()).isEqualTo("Device.execute: was interrupted: it did not return within 50 ms");
            assertThat(failed.after()).isEqualTo(at("On", "SpotWait"));
            assertThat(robot.awaitHistory(5).occurrence().label()).isEqualTo("in doubt");

            robot.press("Clean");
            assertThat(take(robot.sent)).isEqualTo("Spare:Spot");
            assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
        }
    }

    @Test
    void theStateThatAnExchangePreventedFromBeingLeftIsEnteredAnew() throws InterruptedException {
        try (LiveRobot robot = inTheMiddleOfTheDetour(step -> {
            hanging.countDown();
            atLast.await();
        })) {
            robot.converter.exchange("Device", robot.device("Spare"));
            robot.awaitSpotWait();
            robot.awaitHistory(5);
            robot.clock.advance(Duration.ofMillis(4999));
            robot.press("Spot");
            assertThat(robot.states()).isEqualTo(at("On", "SpotWait"));
            robot.clock.advance(Duration.ofMillis(1));
            robot.awaitStates("On", "On");
        }
    }

    @Test
    void aDeafComponentThatWasExchangedReturnsIntoTheVoid() throws InterruptedException {
        try (LiveRobot robot = inTheMiddleOfTheDetour(step -> {
            hanging.countDown();
            awaitDeaf(atLast);
        })) {
            robot.converter.exchange("Device", robot.device("Spare"));
            robot.awaitHistory(5);
            robot.press("Clean");
            assertThat(take(robot.sent)).isEqualTo("Spare:Spot");

            atLast.countDown();
            assertThat(take(robot.sent)).isEqualTo("Device:Spot");
            // Earlier, the report would be impossible.
            robot.awaitStates("Spot", "Spot");
            robot.panel.ended("endSpot");
            robot.press("Clean");
            robot.awaitStates("Clean", "Clean");
            assertThat(robot.converter.history())
                    .extracting(HistoryEntry::outcome)
                    .doesNotContain(Outcome.STALE);
        }
    }

    @Test
    void theSystemFollowsALateEffectThoughNothingElseHappens() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.device("Device", step -> {
                hanging.countDown();
                awaitDeaf(atLast);
            }));
        })) {
            robot.panel.press("Clean");
            await(hanging);
            robot.converter.exchange("Device", robot.device("Spare"));
            assertThat(robot.awaitHistory(2).detail())
                    .isEqualTo("the device cannot tell where it is; it is taken to be in Off");

            atLast.countDown();
            assertThat(robot.awaitHistory(3).occurrence().label()).isEqualTo("found On");
            assertThat(robot.states()).isEqualTo(at("On", "On"));
            assertThat(robot.converter.status().doubt()).isEmpty();
        }
    }

    @Test
    void aDeafAnalyzeThatWasExchangedCannotMixUpTheEventsOfItsSuccessor() throws InterruptedException {
        CountDownLatch returned = new CountDownLatch(1);
        EventAnalyze deaf = new EventAnalyze() {
            @Override
            protected @Nullable Analysis analyze(Occurrence occurrence) {
                hanging.countDown();
                awaitDeaf(atLast);
                try {
                    return super.analyze(occurrence);
                } finally {
                    returned.countDown();
                }
            }
        };
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addAnalyze(deaf);
            made.converter.addExecute(made.device("Device"));
        })) {
            robot.panel.press("Spot");
            await(hanging);
            CountDownLatch analyzed = new CountDownLatch(1);
            CountDownLatch planning = new CountDownLatch(1);
            robot.converter.exchange(deaf.name(), new EventAnalyze() {
                @Override
                protected @Nullable Analysis analyze(Occurrence occurrence) {
                    Analysis analysis = super.analyze(occurrence);
                    analyzed.countDown();
                    awaitDeaf(planning);
                    return analysis;
                }
            });
            assertThat(robot.awaitHistory(1).outcome()).isEqualTo(Outcome.FAILED);
            robot.panel.press("Clean");
            await(analyzed);
            atLast.countDown();
            await(returned);
            planning.countDown();

            assertThat(robot.awaitHistory(2).occurrence().label()).isEqualTo("Clean");
            assertThat(robot.states()).isEqualTo(at("On", "On"));
        }
    }

    @Test
    void aRefusedChangeDoesNotHoldTheLoopUpThatItHasInterrupted() throws InterruptedException {
        try (LiveRobot robot = inTheMiddleOfTheDetour(step -> {
            hanging.countDown();
            atLast.await();
        })) {
            assertThatThrownBy(() -> robot.converter.addPlan(new EventPlan() {}))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("there is a component of the role PLAN already, EventPlan");
            assertThat(robot.awaitHistory(4).outcome()).isEqualTo(Outcome.FAILED);
            robot.awaitHistory(5);
            robot.press("Spot");
            assertThat(robot.awaitHistory(6).outcome()).isEqualTo(Outcome.IGNORED);
        }
    }

    @Test
    void aMonitorThatHangsIsReplacedAndItsSuccessorReports() throws InterruptedException {
        CountDownLatch monitoring = new CountDownLatch(1);
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addMonitor(new EventMonitor("Hanging") {
                @Override
                protected @Nullable Occurrence getEvent() throws InterruptedException {
                    monitoring.countDown();
                    new CountDownLatch(1).await();
                    return null;
                }
            });
            made.converter.addExecute(made.device("Device"));
        })) {
            await(monitoring);
            PushMonitor successor = new PushMonitor("Successor");
            robot.converter.exchange("Hanging", successor);
            successor.press("Clean");
            robot.press("Clean");
            robot.awaitStates("Clean", "Clean");
            assertThat(robot.converter.status().components())
                    .filteredOn(component -> component.name().equals("Successor"))
                    .extracting(ComponentStatus::activity)
                    .containsExactly(Activity.WAITING);
        }
    }

    @Test
    void sparesAreExchangedByName() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none())) {
            robot.converter.addSpare("spareDevice", () -> robot.device("Second"));
            robot.converter.addSpare("sparePanel", () -> new PushMonitor("SecondPanel"));
            assertThat(robot.converter.spares()).containsExactly("spareDevice", "sparePanel");

            robot.converter.exchange("Device", "spareDevice");
            robot.press("Clean", "Clean");
            assertThat(take(robot.sent)).isEqualTo("Second:Clean");

            assertThatThrownBy(() -> robot.converter.exchange("Second", "spareWheel"))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("no spare is named spareWheel; there are spareDevice, sparePanel");
            assertThatThrownBy(() -> robot.converter.exchange("Second", "sparePanel"))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("Second is a component of the role EXECUTE");
            assertThatThrownBy(() -> robot.converter.exchange("First", "spareDevice"))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("no component is named First; there are Panel,");
            robot.press("Clean");
            assertThat(robot.states()).isEqualTo(at("Clean", "SpotWait"));
        }
    }

    @Test
    void removingWhatDecisionsNeedIsRefused() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.new Device("Cleaner", Set.of("Clean"), step -> {}));
            made.converter.addExecute(made.new Device("Spotter", Set.of("Spot"), step -> {}));
        })) {
            String noWay = "no plan in (On, Move): event arriveSpot leads to Spot, but with the device in On no events "
                    + "that can be sent take it there (sendable: Clean)";
            assertThatThrownBy(() -> robot.converter.remove("Spotter"))
                    .isInstanceOf(ModelException.class)
                    .hasMessageStartingWith("the model 'new' cannot be carried out:\n  ")
                    .hasMessageContaining(noWay);
            assertThatThrownBy(() ->
                            robot.converter.exchange("Spotter", robot.new Device("Other", Set.of("Clean"), step -> {})))
                    .isInstanceOf(ModelException.class)
                    .hasMessageContaining(noWay);
            assertThatThrownBy(() -> robot.converter.exchange(
                            "Spotter", robot.new Device("Other", Set.of("Spot", "Dock"), step -> {})))
                    .isInstanceOf(ModelException.class)
                    .hasMessageContaining(
                            "Other can send Dock, which is not an event of the original model 'original'");
            assertThatThrownBy(() -> robot.converter.addExecute(robot.new Device("Third", Set.of("Max"), step -> {})))
                    .isInstanceOf(ModelException.class)
                    .hasMessageContaining("Third can send Max");

            robot.press("Clean", "Clean", "Clean", "Clean");
            assertThat(robot.sent).containsExactly("Cleaner:Clean", "Cleaner:Clean", "Cleaner:Clean", "Spotter:Spot");
        }
    }

    @Test
    void nothingIsPlannedForARemovedComponentAlthoughItsThreadHasNotEnded() throws InterruptedException {
        ManualClock clock = new ManualClock();
        try (SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults("lamp", clock).withThreading(threading).withJoinLimit(Duration.ofSeconds(30)))) {
            twoWays(converter);
            PushMonitor remote = new PushMonitor("Remote") {
                @Override
                protected Set<String> spontaneousEvents() {
                    return Set.of("fast");
                }
            };
            converter.addMonitor(remote);
            converter.build();
            converter.start();
            remote.press("go");
            await(hanging);
            clock.advance(Duration.ofSeconds(30));
            until(() -> converter.history().size() == 2);

            Thread removing = new Thread(() -> converter.remove("Fast"));
            removing.start();
            until(() -> converter.status().components().stream()
                    .noneMatch(component -> component.name().equals("Fast")));
            remote.press("go");
            until(() -> converter.history().size() == 3);
            HistoryEntry next = converter.history().get(2);
            atLast.countDown();
            removing.join();

            assertThat(next.outcome()).isEqualTo(Outcome.HANDLED);
            assertThat(next.after()).isEqualTo(at("On", "On"));
        }
    }

    /** A lamp that can be switched on in two ways; the component for the first one hangs. */
    private void twoWays(SystemEventConverter converter) {
        converter.addKnowledge(new StateKnowledge(new ModelPair(
                machine("original", "Off fast -> On", "Off slow -> On", "On slow -> Off"),
                machine("new", "Off go -> On", "Off fast -> On", "Off slow -> On", "On slow -> Off"))));
        converter.addExecute(new EventExecute("Slow") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("slow");
            }

            @Override
            protected void send(Step step) {}

            @Override
            protected Optional<String> locate() {
                return Optional.of("Off");
            }
        });
        converter.addExecute(new EventExecute("Fast") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("fast");
            }

            @Override
            protected void send(Step step) {
                hanging.countDown();
                awaitDeaf(atLast);
            }
        });
    }

    @Test
    void theOnlyComponentOfARoleIsExchangedNotRemoved() {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none())) {
            for (String needed : new String[] {"EventAnalyze", "EventPlan", "Device"}) {
                assertThatThrownBy(() -> robot.converter.remove(needed))
                        .isInstanceOf(IllegalStateException.class)
                        .hasMessageContaining("exchange it instead");
            }
            assertThatThrownBy(() -> robot.converter.remove("Nobody")).isInstanceOf(IllegalArgumentException.class);
            robot.press("Clean");
            assertThat(robot.states()).isEqualTo(at("On", "On"));
        }
    }

    @Test
    void anExecuteThatFailsCanBeExchangedBetweenTwoEvents() throws InterruptedException {
        AtomicBoolean broken = new AtomicBoolean(true);
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.device("Device", step -> {
                if (broken.get()) {
                    throw new IOException("the cable is out");
                }
            }));
        })) {
            robot.press("Clean");
            robot.converter.exchange("Device", robot.device("Device"));
            robot.press("Clean");
            assertThat(robot.states()).isEqualTo(at("On", "On"));
            assertThat(robot.component("Device").failures())
                    .as("a new component starts with a clean record")
                    .isZero();
        }
    }
}
