package org.evoloop.roomba.simulator.robot;

import java.util.function.Consumer;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.CommandParser;
import org.evoloop.roomba.oi.CommandParser.Parsed;
import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.body.Wheel;
import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.Pose;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A Roomba that speaks the Open Interface. It begins in standby with the interface off, at its room's start. Without a
 * call nothing happens in it: the same calls in the same order give the same bytes.
 *
 * <pre>
 *   awake ---- 5 min idle in mode Passive, or battery empty ---&gt; asleep
 *         &lt;--- CLEAN button, wake line, or dock ---------------
 * </pre>
 *
 * <p>Asleep it neither receives nor sends anything; when it wakes, its interface is off. The same holds for the
 * {@value #BOOT_MILLIS} ms in which it boots after command Reset; its boot text follows.
 *
 * <p>Threading: thread-safe, each call is atomic; it has no threads of its own. The sink is called within calls and
 * must not call back.
 *
 * @since 0.1
 */
public final class SimulatedRoomba {
    /** The robot time of one {@link #tick()}. */
    public static final int TICK_MILLIS = Body.TICK_MILLIS;

    /** How long a person holds a button down by default. */
    public static final int USUAL_PRESS_MILLIS = 150;

    private static final Logger LOG = LoggerFactory.getLogger(SimulatedRoomba.class);

    /** Clients of real robots wait 5 s after a Reset. */
    private static final int BOOT_MILLIS = 4_000;

    private static final int SLOW_BAUD = 19_200;
    private static final int TICKS_PER_SECOND = 1000 / TICK_MILLIS;

    /** How far a robot is moved back when it is taken off its dock. */
    private static final double UNDOCK_MM = 500;

    private final RobotOptions options;
    private final Consumer<byte[]> sink;
    private final Body body;
    private final SerialLine line;
    private final WakeLine wakeLine = new WakeLine();
    private CommandParser parser = new CommandParser(this::handle);
    private Firmware firmware;
    private int bootTicksLeft;
    private boolean asleep;
    private long asleepSinceTick;
    private long ticks;

    /**
     * A robot that waits to be used.
     *
     * @param sink takes what the robot sends: whole replies, frames and texts as the line leaves them, in arrays that
     *     it may keep
     */
    public SimulatedRoomba(RobotOptions options, Consumer<byte[]> sink) {
        this.options = options;
        this.sink = sink;
        this.body = new Body(options.room(), options.batteryPercent());
        this.line = new SerialLine(options);
        this.firmware = new Firmware(body, options, this::send);
    }

    /** Takes what a client sends, from the buffer's start. Replies to queries go out within this call. */
    public synchronized void receive(byte[] buffer, int length) {
        byte[] arrived = line.toRobot(buffer, length);
        for (int i = 0; i < arrived.length && isListening(); i++) {
            parser.feed(arrived[i]);
        }
    }

    private boolean isListening() {
        return !asleep && bootTicksLeft == 0;
    }

    private void handle(Parsed parsed) {
        if (parsed instanceof Parsed.Accepted accepted) {
            obey(accepted.command());
        } else if (parsed instanceof Parsed.Malformed malformed && malformed.nearest() != null) {
            LOG.trace("took the nearest for {}", parsed);
            obey(malformed.nearest());
        } else {
            LOG.trace("ignored {}", parsed);
        }
    }

    private void obey(Command command) {
        if (command instanceof Command.Reset) {
            body.stop();
            line.powerOn();
            boot();
            bootTicksLeft = BOOT_MILLIS / TICK_MILLIS;
            send(RobotText.resetting(options.firmware()));
        } else if (command instanceof Command.Baud baud && command.opcode().isAcceptedIn(firmware.mode())) {
            line.setBaud(baud.bitsPerSecond());
        } else {
            firmware.execute(command);
        }
    }

    private void boot() {
        firmware = new Firmware(body, options, this::send);
        wakeLine.powerOn();
    }

    private void send(byte[] bytes) {
        byte[] arrived = line.toClient(bytes);
        if (arrived.length > 0) {
            sink.accept(arrived);
        }
    }

    /** Lets {@value #TICK_MILLIS} ms of robot time pass; if a stream is on, its frame goes out at the end. */
    public synchronized void tick() {
        ticks++;
        if (wakeLine.tick()) {
            wakeUp();
        }
        if (asleep) {
            body.tick();
            if (body.isCharging()) {
                wakeBy("charger");
            }
        } else if (bootTicksLeft > 0) {
            body.tick();
            bootTicksLeft--;
            if (bootTicksLeft == 0) {
                send(RobotText.started(options.firmware()));
            }
        } else {
            firmware.act();
            body.tick();
            send(line.noise());
            firmware.report();
            boolean exhausted = body.battery().isEmpty() && !body.isCharging();
            if (firmware.isTired() || exhausted) {
                fallAsleep();
            }
        }
    }

    private void fallAsleep() {
        send(RobotText.fallingAsleep());
        body.stop();
        body.setAwake(false);
        body.allowCharger(true);
        asleep = true;
        asleepSinceTick = ticks;
        // Asleep, its program has ended; what it held is gone.
        boot();
        parser = new CommandParser(this::handle);
    }

    private void wakeBy(String waker) {
        if (asleep && (!body.battery().isEmpty() || body.isCharging())) {
            asleep = false;
            body.setAwake(true);
            boot();
            send(RobotText.waking(waker, (ticks - asleepSinceTick) / TICKS_PER_SECOND));
        }
    }

    /**
     * Somebody presses one of the robot's own buttons. It shows for as many of the ticks to come as the time covers,
     * and the robot obeys at once. A button that is still down is let go for a moment first, when its time is over.
     * Asleep, CLEAN wakes the robot and turns it on, and the others do nothing; while it boots all of them do nothing.
     *
     * @param durationMillis how long it is held; at least one tick
     */
    public synchronized void press(Button button, int durationMillis) {
        if (asleep && button == Button.CLEAN) {
            wakeBy("key");
        }
        if (isListening()) {
            firmware.press(button, durationMillis);
        }
    }

    /** As {@link #press(Button, int)} for {@value #USUAL_PRESS_MILLIS} ms. */
    public void press(Button button) {
        press(button, USUAL_PRESS_MILLIS);
    }

    /**
     * The client pulls the line to the BRC pin low, or lets it go high again. Low for 50 ms wakes the robot, or begins
     * its idle time anew; three pulses of 50 to 500 ms in the time from 2 to 20 s after power-on or waking make it go
     * to 19200 baud. A sleepy robot has no such line.
     */
    public synchronized void wakeLine(boolean low) {
        if (!options.sleepy() && wakeLine.set(low)) {
            line.setBaud(SLOW_BAUD);
        }
    }

    /** As one pulse of the wake line that is too long to count for 19200 baud, all at once. */
    public synchronized void wakeUp() {
        if (!options.sleepy()) {
            wakeBy("key");
            firmware.stayAwake();
        }
    }

    /**
     * Tells at what rate the client's port runs; unless it is the robot's own, both hear garbage.
     *
     * @param bitsPerSecond 0, as at first, is always the right one
     */
    public synchronized void clientBaud(int bitsPerSecond) {
        line.setClientBaud(bitsPerSecond);
    }

    /** At what rate the robot's own port runs, in bit/s. */
    public synchronized int baud() {
        return line.baud();
    }

    /** Somebody holds the robot up in the air. */
    public synchronized void lift() {
        body.setLifted(true);
    }

    /** Somebody sets the robot down where it was. */
    public synchronized void setDown() {
        body.setLifted(false);
    }

    /**
     * Somebody carries the robot elsewhere; in the air or on the floor, as it was.
     *
     * @throws IllegalArgumentException if there is no room for it
     */
    public synchronized void place(Pose pose) {
        if (!body.room().isFree(pose)) {
            throw new IllegalArgumentException(
                    "there is no room for the robot at " + pose.describe() + "; something solid is in the way");
        }
        body.place(pose);
    }

    /** Somebody puts the robot onto its dock; if there is none, somebody pushes one under the robot. */
    public synchronized void dock() {
        body.setLifted(false);
        body.room().dock().ifPresentOrElse(body::place, () -> body.moveDock(body.pose()));
    }

    /**
     * Somebody pulls the robot backwards off its dock.
     *
     * @throws IllegalArgumentException if it is not on one, or there is no room behind it
     */
    public synchronized void undock() {
        if (!body.surroundings().docked()) {
            throw new IllegalArgumentException("the robot is not on a dock");
        }
        place(body.pose().at(body.pose().ahead(-UNDOCK_MM, 0)));
    }

    /** Somebody hangs the room's marker elsewhere; if there is none, a usual one. */
    public synchronized void moveMarker(Pose pose) {
        body.setMarker(body.room().marker().map(marker -> marker.movedTo(pose)).orElseGet(() -> Marker.at(pose)));
    }

    /**
     * Somebody hangs a cloth over the marker, or takes it off.
     *
     * @throws IllegalArgumentException if there is no marker
     */
    public synchronized void coverMarker(boolean cloth) {
        Marker marker = body.room()
                .marker()
                .orElseThrow(() -> new IllegalArgumentException(
                        "there is no marker in the room; hang one up with 'move-marker X Y HEADING'"));
        body.setMarker(marker.covered(cloth));
    }

    /** The truth at this moment. */
    public synchronized RobotState state() {
        Wheel left = body.left();
        Wheel right = body.right();
        return new RobotState(
                ticks * TICK_MILLIS,
                firmware.activity(),
                firmware.mode(),
                body.pose(),
                left.velocityMmPerS(),
                right.velocityMmPerS(),
                firmware.pressed(),
                firmware.reporter().isStreaming(),
                body.surroundings(),
                asleep,
                body.battery().percent(),
                body.isCharging(),
                line.baud());
    }
}
