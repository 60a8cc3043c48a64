package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import org.evoloop.PaperPair;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Opcode;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.testkit.SimulatedRoombaExtension;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Effects and the robot's own acts are reported in the order in which they happen, on a real serial port. */
@EnabledOnOs(OS.LINUX)
@Timeout(120)
class EffectOrderTest {
    private static final double SPEED = 4;
    private static final Duration STEP_LIMIT = Duration.ofSeconds(8);
    private static final Duration PATIENCE = Duration.ofSeconds(30);

    @RegisterExtension
    final SimulatedRoombaExtension robot =
            SimulatedRoombaExtension.create().speed(SPEED).patience(PATIENCE);

    private final HeldLink.Hold hold = new HeldLink.Hold();
    private final Clock clock = new SystemClock(SPEED);
    private RoombaConverter roomba;

    @BeforeEach
    void connect() throws InterruptedException {
        StateMachine device = PaperPair.cleaningRobot().original();
        roomba = RoombaConverter.connect(
                hold.on(RoombaCommand.cable(robot.port().toString())),
                LoopConfig.defaults("roomba", clock).withStepLimit(STEP_LIMIT),
                SessionOptions.defaults().withSilenceLimit(Duration.ofSeconds(20)),
                RoombaOptions.of(
                        RobotModels.of(new ModelPair(device, device)), time -> StartPointSensor.byWheels(1000, 500)));
        roomba.converter().start();
    }

    @AfterEach
    void close() {
        hold.release();
        roomba.close();
        clock.close();
    }

    private RobotActivity truth() {
        return robot.state().activity();
    }

    private String record() {
        return roomba.converter().status().states().original().name();
    }

    private String doubt() {
        return roomba.converter().status().doubt();
    }

    private void awaitBoth(RobotActivity activity) {
        await().atMost(PATIENCE)
                .until(() ->
                        truth() == activity && record().toUpperCase(Locale.ROOT).equals(activity.name()));
    }

    private void awaitAgreement() {
        await().atMost(PATIENCE)
                .until(() ->
                        doubt().isEmpty() && record().toUpperCase(Locale.ROOT).equals(truth().name()));
    }

    private void startCleaning() throws InterruptedException {
        roomba.controller().press(RobotEvents.CLEAN);
        awaitBoth(RobotActivity.ON);
        robot.until(state -> state.oiMode() == OiMode.SAFE);
        roomba.controller().press(RobotEvents.CLEAN);
        awaitBoth(RobotActivity.CLEAN);
    }

    @Test
    void whatTheRobotHasObeyedIsRecordedThoughItsSendNeverReturns() throws Exception {
        hold.after(Opcode.SAFE.code());
        roomba.controller().press(RobotEvents.CLEAN);
        hold.await();
        awaitBoth(RobotActivity.ON);
        clock.sleep(STEP_LIMIT.plusSeconds(1));
        assertThat(doubt()).as("given up, but still known").isEmpty();
        assertThat(record()).isEqualTo(RobotEvents.STATE_ON);
        hold.release();
        roomba.converter().exchange("ExecuteCommand", "ExecuteCommand2");
        roomba.controller().press(RobotEvents.SPOT);
        awaitBoth(RobotActivity.SPOT);
    }

    @Test
    void aStepOfUnknownEffectIsResolvedByAskingTheRobot() throws Exception {
        startCleaning();
        hold.before(Opcode.CLEAN.code());
        roomba.controller().press(RobotEvents.CLEAN);
        hold.await();
        await().atMost(PATIENCE).until(() -> !doubt().isEmpty());
        assertThat(doubt()).contains("it is unknown whether Clean had its effect");
        roomba.converter().exchange("ExecuteCommand", "ExecuteCommand2");
        await().atMost(PATIENCE).until(() -> doubt().isEmpty());
        assertThat(truth()).isEqualTo(RobotActivity.CLEAN);
        assertThat(record()).isEqualTo(RobotEvents.STATE_CLEAN);
    }

    @Test
    void aRobotThatIsPausedByItsOwnButtonWhileACommandIsOnItsWay() throws Exception {
        startCleaning();
        hold.before(Opcode.CLEAN.code());
        roomba.controller().press(RobotEvents.CLEAN);
        hold.await();
        robot.press(Button.CLEAN);
        awaitBoth(RobotActivity.ON);
        hold.release();
        await().atMost(PATIENCE).until(() -> roomba.converter().status().queue().depth() == 0);
        awaitAgreement();
    }

    @Test
    void aRobotThatIsLiftedAndSetToWorkWhileACommandIsOnItsWay() throws Exception {
        roomba.controller().press(RobotEvents.CLEAN);
        awaitBoth(RobotActivity.ON);
        await().atMost(PATIENCE).until(() -> roomba.session().isUnderControl());
        hold.before(Opcode.CLEAN.code());
        roomba.controller().press(RobotEvents.CLEAN);
        hold.await();
        robot.robot().lift();
        await().atMost(PATIENCE).until(() -> !roomba.session().isUnderControl());
        robot.robot().setDown();
        robot.press(Button.SPOT);
        awaitBoth(RobotActivity.SPOT);
        hold.release();
        robot.until(state -> state.activity() == RobotActivity.ON);
        awaitAgreement();
    }

    @Test
    void theRobotsStateIsReportedFromItsFramesOrNotAtAll() throws Exception {
        ExecuteCommand asked =
                new ExecuteCommand(roomba.session(), PaperPair.cleaningRobot().original(), clock, new Resumption());
        startCleaning();
        await().atMost(PATIENCE).until(() -> asked.locate().equals(Optional.of(RobotEvents.STATE_CLEAN)));
        roomba.controller().press(RobotEvents.CLEAN);
        awaitBoth(RobotActivity.ON);
        assertThat(asked.locate()).contains(RobotEvents.STATE_ON);
        roomba.controller().press(RobotEvents.SPOT);
        awaitBoth(RobotActivity.SPOT);
        assertThat(asked.locate()).contains(RobotEvents.STATE_SPOT);
        robot.unplug();
        await().atMost(PATIENCE).until(() -> !roomba.session().isUp());
        assertThat(asked.locate()).as("no frames arrive").isEmpty();
    }
}
