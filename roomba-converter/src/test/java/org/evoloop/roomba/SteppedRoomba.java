package org.evoloop.roomba;

import java.io.ByteArrayOutputStream;
import java.time.Duration;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import org.evoloop.PaperPair;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.link.ForwardingLink;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;
import org.evoloop.link.MemoryLink;
import org.evoloop.link.WakeLine;
import org.evoloop.loop.LoopConfig;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/**
 * The whole Roomba converter and a simulated robot on one thread under a manual clock: the same calls always have the
 * same result.
 */
final class SteppedRoomba implements AutoCloseable {
    private static final Duration TICK = Duration.ofMillis(SimulatedRoomba.TICK_MILLIS);

    final ManualClock clock = new ManualClock();
    final SimulatedRoomba robot;
    final RoombaConverter roomba;
    private final RoombaSession session;
    private final ByteArrayOutputStream robotSays = new ByteArrayOutputStream();
    private MemoryLink.@Nullable Pair cable;
    private MemoryLink.@Nullable Noise noise;
    private boolean plugged = true;
    private boolean muted;
    private boolean pulledByCommand;

    SteppedRoomba() {
        this(RobotOptions.defaults());
    }

    SteppedRoomba(RobotOptions options) {
        this(options, Scenario.START_X_MM, Scenario.START_Y_MM);
    }

    /** A robot with these options for the simulation and the session. */
    SteppedRoomba(RobotOptions options, SessionOptions session) {
        this(
                options,
                session,
                PaperPair.cleaningRobot(),
                MoveOptions.defaults(),
                (robot, clock) -> StartPointSensor.byWheels(Scenario.START_X_MM, Scenario.START_Y_MM));
    }

    /** A robot with another starting point. */
    SteppedRoomba(RobotOptions options, double startXMm, double startYMm) {
        this(
                options,
                PaperPair.cleaningRobot(),
                MoveOptions.defaults(),
                (robot, clock) -> StartPointSensor.byWheels(startXMm, startYMm));
    }

    /** A robot with another sensor for its starting point. */
    SteppedRoomba(
            RobotOptions options,
            ModelPair models,
            MoveOptions move,
            BiFunction<SimulatedRoomba, ManualClock, StartPointSensor> sensor) {
        this(options, SessionOptions.defaults(), models, move, sensor);
    }

    private SteppedRoomba(
            RobotOptions options,
            SessionOptions sessionOptions,
            ModelPair models,
            MoveOptions move,
            BiFunction<SimulatedRoomba, ManualClock, StartPointSensor> sensor) {
        robot = new SimulatedRoomba(options, robotSays::writeBytes);
        StartPointSensor startPoint = sensor.apply(robot, clock);
        session = new RoombaSession(this::plugIn, clock, sessionOptions.withoutWaiting());
        roomba = RoombaConverter.build(
                LoopConfig.defaults("roomba", clock).withoutThreads(),
                session,
                RoombaOptions.of(RobotModels.of(models), opened -> startPoint).withMove(move));
        session.open();
        advance(Duration.ofMillis(500));
        roomba.converter().start();
    }

    private Link plugIn(int baud) {
        if (!plugged) {
            throw new LinkException(LinkException.Fault.NO_SUCH_PORT, "the cable is out; plug it in");
        }
        obey();
        MemoryLink.Pair fresh = MemoryLink.pair();
        cable = fresh;
        disturb(noise);
        return new ForwardingLink(fresh.converter()) {
            @Override
            public void send(byte[] bytes) {
                super.send(bytes);
                if (pulledByCommand) {
                    pulledByCommand = false;
                    unplug();
                }
            }

            @Override
            public WakeLine wakeLine() {
                return low -> {
                    robot.wakeLine(low);
                    return true;
                };
            }
        };
    }

    /** Pulls the cable. */
    void unplug() {
        obey();
        plugged = false;
        MemoryLink.Pair current = cable;
        if (current != null) {
            current.converter().hangUp();
        }
        session.poll();
    }

    void replug() {
        pulledByCommand = false;
        plugged = true;
    }

    /** Unplugs the cable as soon as the robot has received the next command, before a frame can show its effect. */
    void unplugWithTheNextCommand() {
        pulledByCommand = true;
    }

    /** Unplugs the cable in the middle of a frame. */
    void unplugWithinAFrame() {
        robot.tick();
        byte[] bytes = robotSays.toByteArray();
        robotSays.reset();
        robotSays.write(bytes, 0, bytes.length / 2);
        deliver();
        unplug();
    }

    /** From now on the robot's bytes are lost, or arrive again; the cable stays plugged in. */
    SteppedRoomba mute(boolean nothingArrives) {
        muted = nothingArrives;
        return this;
    }

    /** The robot's end stops accepting bytes; the sender notices, and opens a new link. */
    void stall() {
        MemoryLink.Pair current = cable;
        if (current != null) {
            current.device().setReading(false);
        }
    }

    /**
     * Sets the noise in both directions, null for none. Commands are lost but not changed: one bit turns a Spot (134)
     * into a Clean (135), and the two look the same from outside.
     */
    void disturb(MemoryLink.@Nullable Noise nextNoise) {
        noise = nextNoise;
        MemoryLink.Pair current = cable;
        if (current != null) {
            MemoryLink.Noise set = nextNoise == null ? new MemoryLink.Noise(0, 0, 0) : nextNoise;
            current.device().setNoise(set);
            current.converter().setNoise(new MemoryLink.Noise(set.seed(), set.dropRate(), 0));
        }
    }

    /** Lets time pass for robot and converter. */
    SteppedRoomba advance(Duration duration) {
        for (long left = duration.toNanos(); left > 0; left -= TICK.toNanos()) {
            robot.tick();
            deliver();
            clock.advance(TICK);
            deliver();
            settle();
        }
        return this;
    }

    /** The robot receives what it was sent. It does not notice that its cable is unplugged. */
    private void obey() {
        MemoryLink.Pair current = cable;
        if (current != null) {
            byte[] buffer = new byte[1_024];
            MemoryLink end = current.device();
            for (int length = end.receive(buffer); length > 0; length = end.receive(buffer)) {
                robot.receive(buffer, length);
            }
        }
    }

    private void deliver() {
        obey();
        byte[] bytes = robotSays.toByteArray();
        robotSays.reset();
        MemoryLink.Pair current = cable;
        if (bytes.length > 0 && plugged && !muted && current != null) {
            try {
                current.device().send(bytes);
            } catch (LinkException pulled) {
                // Bytes that a robot sends into an unplugged cable are lost.
                robotSays.reset();
            }
        }
        session.poll();
        obey();
    }

    private void settle() {
        try {
            roomba.observe();
            while (roomba.converter().step()) {
                deliver();
                roomba.observe();
            }
            deliver();
        } catch (InterruptedException unexpected) {
            throw new AssertionError(unexpected);
        }
    }

    /** Lets time pass until a condition holds; fails if it does not within {@code limit}. */
    SteppedRoomba until(BooleanSupplier holds, Duration limit) {
        for (long ticks = limit.dividedBy(TICK); !holds.getAsBoolean(); ticks--) {
            if (ticks == 0) {
                throw new AssertionError("never came to hold: " + states() + ", " + truth() + ", "
                        + roomba.converter().history());
            }
            advance(TICK);
        }
        return this;
    }

    /** A button of the robot is pressed for a typical time, and some time passes until it is up again. */
    SteppedRoomba robotPress(Button button) {
        robot.press(button);
        return advance(Duration.ofMillis(2 * SimulatedRoomba.USUAL_PRESS_MILLIS));
    }

    /** A button of the external controller is pressed. */
    SteppedRoomba press(String event) {
        roomba.controller().press(event);
        settle();
        return this;
    }

    static Configuration at(String original, String evolved) {
        return new Configuration(new State(original), new State(evolved));
    }

    HistoryEntry last() {
        return roomba.converter().history().get(roomba.converter().history().size() - 1);
    }

    Configuration states() {
        return roomba.converter().knowledge().configuration();
    }

    RobotState truth() {
        return robot.state();
    }

    @Override
    public void close() {
        roomba.close();
        obey();
        clock.close();
    }
}
