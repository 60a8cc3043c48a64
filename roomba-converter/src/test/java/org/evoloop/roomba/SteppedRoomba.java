package org.evoloop.roomba;

import java.io.ByteArrayOutputStream;
import java.time.Duration;
import org.evoloop.PaperPair;
import org.evoloop.evolution.Configuration;
import org.evoloop.loop.LoopConfig;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.link.MemoryLink;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/**
 * The whole Roomba converter and a simulated robot on one thread under a manual clock: the same calls always end the same
 * way.
 */
final class SteppedRoomba implements AutoCloseable {
    private static final Duration TICK = Duration.ofMillis(SimulatedRoomba.TICK_MILLIS);

    final ManualClock clock = new ManualClock();
    final SimulatedRoomba robot;
    final RoombaConverter roomba;
    private final ByteArrayOutputStream robotSays = new ByteArrayOutputStream();
    private MemoryLink.@Nullable Pair cable;
    private MemoryLink.@Nullable Noise noise;
    private boolean plugged = true;

    SteppedRoomba(RobotOptions options) {
        robot = new SimulatedRoomba(options, robotSays::writeBytes);
        RoombaSession session =
                new RoombaSession(this::plugIn, clock, SessionOptions.defaults().withoutWaiting());
        roomba = RoombaConverter.build(
                LoopConfig.defaults("roomba", clock).withoutThreads(),
                session,
                new RoombaConverter.Options(
                        PaperPair.cleaningRobot(), StartPointSensor.byWheels(400, 100), Duration.ofSeconds(5)));
        session.open();
        advance(Duration.ofMillis(500));
        roomba.converter().start();
    }

    private Link plugIn(int baud) {
        if (!plugged) {
            throw new LinkException(LinkException.Fault.NO_SUCH_PORT, "the cable is out; plug it in");
        }
        MemoryLink.Pair fresh = MemoryLink.pair();
        fresh.robot().open(new Link.Receiver() {
            @Override
            public void received(byte[] buffer, int length) {
                robot.receive(buffer, length);
            }

            @Override
            public void lost(LinkException cause) {
                // A robot does not notice that its cable is pulled.
            }
        });
        cable = fresh;
        disturb(noise);
        return fresh.converter();
    }

    /** Pulls the cable. */
    void unplug() {
        plugged = false;
        MemoryLink.Pair current = cable;
        if (current != null) {
            current.converter().hangUp();
        }
    }

    void replug() {
        plugged = true;
    }

    /**
     * Disturbs both directions from now on, null for not at all. Commands are lost but not changed: one bit makes a Spot
     * (134) a Clean (135), and the two look alike from outside.
     */
    void disturb(MemoryLink.@Nullable Noise nextNoise) {
        noise = nextNoise;
        MemoryLink.Pair current = cable;
        if (current != null) {
            MemoryLink.Noise set = nextNoise == null ? new MemoryLink.Noise(0, 0, 0) : nextNoise;
            current.robot().setNoise(set);
            current.converter().setNoise(new MemoryLink.Noise(set.seed(), set.dropRate(), 0));
        }
    }

    /** Lets time pass for robot and converter. */
    void advance(Duration duration) {
        for (long left = duration.toNanos(); left > 0; left -= TICK.toNanos()) {
            robot.tick();
            deliver();
            clock.advance(TICK);
            deliver();
            settle();
        }
    }

    private void deliver() {
        byte[] bytes = robotSays.toByteArray();
        robotSays.reset();
        MemoryLink.Pair current = cable;
        if (bytes.length > 0 && plugged && current != null) {
            try {
                current.robot().send(bytes);
            } catch (LinkException pulled) {
                // What a robot says into a pulled cable nobody hears.
                robotSays.reset();
            }
        }
    }

    private void settle() {
        try {
            roomba.observe();
            while (roomba.converter().step()) {
                deliver();
                roomba.observe();
            }
        } catch (InterruptedException unexpected) {
            throw new AssertionError(unexpected);
        }
    }

    /** One of the robot's own buttons is pressed, long enough to be seen. */
    void robotButton(Button button) {
        robot.press(button);
        advance(Duration.ofMillis(200));
    }

    /** A button of the external controller is pressed. */
    void controllerButton(String event) {
        roomba.controller().press(event);
        advance(TICK);
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
        clock.close();
    }
}
