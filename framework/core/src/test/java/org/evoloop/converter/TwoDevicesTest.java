package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A door with a motor and a lock, each behind an execute component of its own, and two monitors. */
@Timeout(60)
class TwoDevicesTest {
    private static final ModelPair DOOR = new ModelPair(
            StateMachine.named("original")
                    .initial("locked")
                    .transition("locked", "wake", "awake")
                    .transition("awake", "unlock", "unlocked")
                    .transition("unlocked", "open", "opened")
                    .transition("opened", "close", "unlocked")
                    .transition("unlocked", "lock", "locked")
                    .build(),
            StateMachine.named("new")
                    .initial("locked")
                    .transition("locked", "wake", "awake")
                    .transition("awake", "unlock", "unlocked")
                    .transition("unlocked", "open", "opened")
                    .transition("opened", "close", "unlocked")
                    .transition("unlocked", "lock", "locked")
                    .transition("locked", "visitor", "opened")
                    .transition("awake", "visitor", "opened")
                    .transition("opened", "gone", "locked")
                    .build());

    private final BlockingQueue<String> sent = new LinkedBlockingQueue<>();
    private final PushMonitor bell = new PushMonitor("Bell");
    private final PushMonitor remote = new PushMonitor("Remote");
    private final SystemEventConverter converter = new SystemEventConverter(
            LoopConfig.defaults("door", new ManualClock()).withQueueCapacity(10));
    private final List<String> settled = new CopyOnWriteArrayList<>();
    private volatile boolean jammed;
    private volatile String unsettled = "";
    private volatile @Nullable Error missing;
    private volatile @Nullable Event unanswered;

    private final class Part extends EventExecute {
        private final Set<String> sendable;

        Part(String name, String... sendable) {
            super(name);
            this.sendable = Set.of(sendable);
        }

        @Override
        protected Set<String> sendableEvents() {
            return sendable;
        }

        @Override
        protected void settled(Configuration now) throws IOException {
            settled.add(name() + " in " + now.original());
            if (name().equals(unsettled)) {
                failFor(missing);
                throw new IOException(name() + " does not settle");
            }
        }

        @Override
        protected Optional<String> locate() throws IOException {
            if (name().equals("Motor")) {
                failFor(missing);
                throw new IOException("the motor has no power");
            }
            return Optional.of("awake");
        }

        @Override
        protected void send(Step step) throws IOException {
            if (jammed && name().equals("Lock")) {
                throw new IOException("jammed");
            }
            if (step.trigger().equals(unanswered)) {
                throw new UnknownEffectException("no answer");
            }
            // The device's state when the event is sent: the knowledge has followed every earlier event.
            sent.add(name() + ":" + step.event() + " in "
                    + converter.knowledge().getOriginalState() + " = " + step.source());
        }
    }

    private static void failFor(@Nullable Error cause) {
        if (cause != null) {
            throw cause;
        }
    }

    @BeforeEach
    void build() {
        converter.addMonitor(bell);
        converter.addMonitor(remote);
        converter.addExecute(new Part("Motor", "wake", "open", "close"));
        converter.addExecute(new Part("Lock", "unlock", "lock"));
        converter.addKnowledge(new StateKnowledge(DOOR));
        converter.build();
        converter.start();
    }

    @AfterEach
    void close() {
        converter.close();
    }

    private HistoryEntry press(PushMonitor monitor, String event) {
        int before = converter.history().size();
        monitor.press(event);
        LiveRobot.until(() -> converter.history().size() > before);
        return converter.history().get(before);
    }

    @Test
    void theEventsOfOnePlanGoToTheirComponentsInOrder() {
        HistoryEntry visitor = press(bell, "visitor");
        assertThat(visitor.detail()).isEqualTo("wake, unlock, open");
        assertThat(press(remote, "gone").detail()).isEqualTo("close, lock");
        assertThat(sent)
                .containsExactly(
                        "Motor:wake in locked = locked",
                        "Lock:unlock in awake = awake",
                        "Motor:open in unlocked = unlocked",
                        "Motor:close in opened = opened",
                        "Lock:lock in unlocked = unlocked");
        assertThat(converter.knowledge().configuration()).isEqualTo(at("locked", "locked"));
    }

    @Test
    void aPlanThatBreaksOffAtTheSecondComponentContinuesFromThere() {
        jammed = true;
        HistoryEntry failed = press(bell, "visitor");
        assertThat(failed.outcome()).isEqualTo(Outcome.FAILED);
        assertThat(failed.detail()).isEqualTo("Lock.execute: jammed");
        assertThat(failed.after()).isEqualTo(at("awake", "locked"));

        jammed = false;
        assertThat(press(bell, "visitor").detail()).isEqualTo("unlock, open");
        assertThat(converter.knowledge().configuration()).isEqualTo(at("opened", "opened"));
    }

    @Test
    void whatEachMonitorReportsStaysInOrder() {
        for (String event : List.of("wake", "unlock", "open", "close", "lock")) {
            remote.press(event);
            bell.push(bell.fromController("nonsense"));
        }
        LiveRobot.until(() -> converter.history().size() == 10);
        assertThat(converter.history())
                .filteredOn(entry -> entry.outcome() == Outcome.HANDLED)
                .extracting(HistoryEntry::detail)
                .containsExactly("wake", "unlock", "open", "close", "lock");
        assertThat(converter.status().events()).isEqualTo(new ConverterStatus.EventCounts(10, 5, 5, 0, 0, 0, 0, 0, 0));
    }

    @Test
    void theSecondIsAskedWhereTheDeviceIsAlsoIfTheFirstFailsToTell() {
        unanswered = new Event("wake");
        remote.press("wake");
        LiveRobot.until(() -> converter.history().size() == 2);
        assertThat(converter.history())
                .extracting(HistoryEntry::outcome)
                .containsExactly(Outcome.FAILED, Outcome.HANDLED);
        assertThat(converter.knowledge().configuration()).isEqualTo(at("awake", "awake"));
        assertThat(converter.status().doubt()).isEmpty();
        assertThat(converter.status().components())
                .extracting(ComponentStatus::lastFailure)
                .contains("Motor.locate: the motor has no power");
    }

    @Test
    void whatTheFirstLacksToBeAskedOrToSettleDoesNotConcernTheSecond() {
        missing = new NoClassDefFoundError("org/motor/Driver");
        unsettled = "Motor";
        press(remote, "wake");
        LiveRobot.until(() -> settled.size() == 4);
        assertThat(settled).endsWith("Motor in awake", "Lock in awake");

        unanswered = new Event("unlock");
        remote.press("unlock");
        LiveRobot.until(() -> converter.history().size() == 3);
        assertThat(converter.history().get(2).outcome()).isEqualTo(Outcome.HANDLED);
        assertThat(converter.status().doubt()).isEmpty();
        assertThat(converter.status().components())
                .extracting(ComponentStatus::lastFailure)
                .contains("Motor.locate: org/motor/Driver");
    }

    @Test
    void bothSettleAfterEachEventAlsoIfOneFailsToDoSo() {
        press(remote, "wake");
        LiveRobot.until(() -> settled.size() == 4);
        unsettled = "Motor";
        press(remote, "unlock");
        LiveRobot.until(() -> settled.size() == 6);
        assertThat(settled)
                .containsExactly(
                        "Motor in locked",
                        "Lock in locked",
                        "Motor in awake",
                        "Lock in awake",
                        "Lock in unlocked",
                        "Motor in unlocked");
        press(remote, "open");
        LiveRobot.until(() -> settled.size() == 8);
        assertThat(settled).endsWith("Motor in opened", "Lock in opened");
        assertThat(converter.status().components())
                .extracting(ComponentStatus::lastFailure)
                .contains("Motor.settled: Motor does not settle");
    }
}
