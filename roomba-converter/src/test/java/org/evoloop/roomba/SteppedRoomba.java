package org.evoloop.roomba;

import java.io.ByteArrayOutputStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.link.MemoryLink;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;
import org.evoloop.xmi.XmiFile;

/**
 * The whole Roomba converter and a simulated robot on one thread, joined by a cable in memory: nothing happens unless a
 * test lets time pass, and the same test always runs the same way.
 */
final class SteppedRoomba implements AutoCloseable {
    private static final Duration TICK = Duration.ofMillis(SimulatedRoomba.TICK_MILLIS);

    final ManualClock clock = new ManualClock();
    final MemoryLink.Pair cable = MemoryLink.pair();
    final RoombaConverter roomba;
    private final ByteArrayOutputStream fromRobot = new ByteArrayOutputStream();
    final SimulatedRoomba robot;

    SteppedRoomba() {
        this(RobotOptions.defaults());
    }

    SteppedRoomba(RobotOptions robotOptions) {
        // The robot must not be called back while it sends: what it says is delivered after each tick.
        robot = new SimulatedRoomba(robotOptions, fromRobot::writeBytes);
        cable.robot().open(new Link.Receiver() {
            @Override
            public void received(byte[] buffer, int length) {
                robot.receive(buffer, length);
            }

            @Override
            public void lost(LinkException cause) {}
        });
        XmiFile models = XmiFile.read(Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml"));
        RoombaConverter.Options options = new RoombaConverter.Options(
                new ModelPair(models.pick("original"), models.pick("new")),
                StartPointSensor.byWheels(Scenario.START_X_MM, Scenario.START_Y_MM),
                Duration.ofSeconds(5));
        RoombaSession session = new RoombaSession(cable.converter(), clock, false);
        roomba = RoombaConverter.build(LoopConfig.defaults("roomba", clock).withoutThreads(), session, options);
        session.open();
        tick();
        roomba.converter().start();
    }

    /** A button of the external controller is pressed. */
    SteppedRoomba press(String event) {
        roomba.controller().press(event);
        settle();
        return this;
    }

    /** A button of the robot is pressed for as long as people do, and some time passes until it is up again. */
    SteppedRoomba robotPress(Button button) {
        robot.press(button);
        return advance(Duration.ofMillis(2 * SimulatedRoomba.USUAL_PRESS_MILLIS));
    }

    /** Lets time pass, in ticks of the robot. */
    SteppedRoomba advance(Duration duration) {
        for (long ticks = duration.dividedBy(TICK); ticks > 0; ticks--) {
            tick();
        }
        return this;
    }

    /** Lets time pass until something holds, which it must within {@code limit}. */
    SteppedRoomba until(BooleanSupplier holds, Duration limit) {
        for (long ticks = limit.dividedBy(TICK); !holds.getAsBoolean(); ticks--) {
            if (ticks == 0) {
                throw new AssertionError("never came to hold: " + states() + ", " + truth() + ", "
                        + roomba.converter().history());
            }
            tick();
        }
        return this;
    }

    private void tick() {
        clock.advance(TICK);
        robot.tick();
        byte[] said = fromRobot.toByteArray();
        fromRobot.reset();
        cable.robot().send(said);
        settle();
    }

    private void settle() {
        try {
            observe();
            while (roomba.converter().step()) {
                observe();
            }
        } catch (InterruptedException stop) {
            throw new AssertionError("nothing interrupts a test", stop);
        }
    }

    private void observe() throws InterruptedException {
        roomba.converter().observe(roomba.monitor());
        roomba.converter().observe(roomba.controller());
    }

    Configuration states() {
        return roomba.converter().knowledge().configuration();
    }

    static Configuration at(String original, String evolved) {
        return new Configuration(new State(original), new State(evolved));
    }

    HistoryEntry last() {
        return roomba.converter().history().get(roomba.converter().history().size() - 1);
    }

    RobotState truth() {
        return robot.state();
    }

    @Override
    public void close() {
        roomba.close();
    }
}
