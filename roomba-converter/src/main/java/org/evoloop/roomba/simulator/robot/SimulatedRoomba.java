package org.evoloop.roomba.simulator.robot;

import java.util.function.Consumer;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.CommandParser;
import org.evoloop.roomba.oi.CommandParser.Parsed;
import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.body.Pose;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A Roomba that speaks the Open Interface. It begins in standby with the interface off, at the origin. Without a call
 * nothing happens in it: the same calls in the same order give the same bytes.
 *
 * <p>Threading: thread-safe, each call is atomic; it has no threads of its own. The sink is called within calls and must
 * not call back.
 */
public final class SimulatedRoomba {
    /** The robot time of one {@link #tick()}. */
    public static final int TICK_MILLIS = Body.TICK_MILLIS;

    /** How long a person holds a button down if nothing else is said. */
    public static final int USUAL_PRESS_MILLIS = 150;

    private static final Logger LOG = LoggerFactory.getLogger(SimulatedRoomba.class);

    private final RobotOptions options;
    private final Consumer<byte[]> sink;
    private final Body body = new Body();
    private final CommandParser parser = new CommandParser(this::handle);
    private Firmware firmware;
    private long ticks;

    /**
     * A robot that waits to be used.
     *
     * @param sink takes what the robot sends: whole replies and frames, in arrays that it may keep
     */
    public SimulatedRoomba(RobotOptions options, Consumer<byte[]> sink) {
        this.options = options;
        this.sink = sink;
        this.firmware = new Firmware(body, options, sink);
    }

    /** Takes what a client sends, from the buffer's start. Replies to queries go out within this call. */
    public synchronized void receive(byte[] buffer, int length) {
        parser.feed(buffer, 0, length);
    }

    private void handle(Parsed parsed) {
        if (!(parsed instanceof Parsed.Accepted accepted)) {
            LOG.trace("ignored {}", parsed);
        } else if (accepted.command() instanceof Command.Reset) {
            body.stop();
            firmware = new Firmware(body, options, sink);
            sink.accept(BootText.bytes());
        } else {
            firmware.execute(accepted.command());
        }
    }

    /** Lets {@value #TICK_MILLIS} ms of robot time pass; if a stream is on, its frame goes out at the end. */
    public synchronized void tick() {
        ticks++;
        firmware.act();
        body.tick();
        firmware.report();
    }

    /**
     * Somebody presses one of the robot's own buttons. It shows for as many of the ticks to come as the time covers, and
     * the robot obeys at once. A button that is still down is only held on.
     *
     * @param durationMillis how long it is held; at least one tick
     */
    public synchronized void press(Button button, int durationMillis) {
        firmware.press(button, durationMillis);
    }

    /** As {@link #press(Button, int)} for {@value #USUAL_PRESS_MILLIS} ms. */
    public void press(Button button) {
        press(button, USUAL_PRESS_MILLIS);
    }

    /** The truth at this moment. */
    public synchronized RobotState state() {
        Pose pose = body.pose();
        return new RobotState(
                ticks * TICK_MILLIS,
                firmware.activity(),
                firmware.mode(),
                pose.xMm(),
                pose.yMm(),
                pose.headingDeg(),
                body.left().velocityMmPerS(),
                body.right().velocityMmPerS(),
                firmware.pressed(),
                firmware.reporter().isStreaming());
    }
}
