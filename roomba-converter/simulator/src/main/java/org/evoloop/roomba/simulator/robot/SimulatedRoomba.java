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
 * A Roomba that speaks the Open Interface. It starts in standby with the interface off, at its room's start. It
 * changes only during calls: the same calls in the same order give the same bytes.
 *
 * <pre>
 *   awake ---- 5 min idle in mode Passive, or battery empty ---&gt; asleep
 *         &lt;--- CLEAN button, wake line, or dock ---------------
 * </pre>
 *
 * <p>Asleep it neither receives nor sends anything; when it wakes, its interface is off. The same holds for the
 * {@value #BOOT_MILLIS} ms in which it boots after command Reset; then it sends its boot text.
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
     * A robot in standby.
     *
     * @param sink receives what the robot sends: whole replies, frames and texts as changed by the line, in arrays that
     *     it may keep
     */
    public SimulatedRoomba(RobotOptions options, Consumer<byte[]> sink) {
        this.options = options;
        this.sink = sink;
        this.body = new Body(options.room(), options.batteryPercent());
        this.line = new SerialLine(options);
        this.firmware = new Firmware(body, options, this::send);
    }

    /** Receives what a client sends, from the buffer's start. Replies to queries are sent within this call. */
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

    /** Simulates {@value #TICK_MILLIS} ms of robot time; if a stream is on, its frame is sent at the end. */
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
        // Sleep has ended its program; its state is lost.
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
     * Presses one of the robot's own buttons. The button stays down for the ticks within this time, and the robot
     * reacts at once. A button that is already down is released for a moment first. Asleep, CLEAN wakes the robot and
     * switches it on, and the others do nothing; while it boots no button does anything.
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
     * Pulls the line to the BRC pin low, or lets it go high again. Low for 50 ms wakes the robot, or restarts its idle
     * time; three pulses of 50 to 500 ms between 2 and 20 s after power-on or waking switch it to 19200 baud. A sleepy
     * robot has no such line.
     */
    public synchronized void wakeLine(boolean low) {
        if (!options.sleepy() && wakeLine.set(low)) {
            line.setBaud(SLOW_BAUD);
        }
    }

    /** Sends one pulse on the wake line, too long to count for 19200 baud, in a single call. */
    public synchronized void wakeUp() {
        if (!options.sleepy()) {
            wakeBy("key");
            firmware.stayAwake();
        }
    }

    /**
     * Sets the rate of the client's port; unless it equals the robot's, both receive garbage.
     *
     * @param bitsPerSecond 0, the initial value, always matches
     */
    public synchronized void clientBaud(int bitsPerSecond) {
        line.setClientBaud(bitsPerSecond);
    }

    /** The rate of the robot's own port, in bit/s. */
    public synchronized int baud() {
        return line.baud();
    }

    /** Lifts the robot off the floor. */
    public synchronized void lift() {
        body.setLifted(true);
    }

    /** Sets the robot down where it was lifted. */
    public synchronized void setDown() {
        body.setLifted(false);
    }

    /**
     * Moves the robot elsewhere; it stays in the air or on the floor.
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

    /** Puts the robot onto its dock; if the room has none, a dock is added at the robot. */
    public synchronized void dock() {
        body.setLifted(false);
        body.room().dock().ifPresentOrElse(body::place, () -> body.moveDock(body.pose()));
    }

    /**
     * Pulls the robot backwards off its dock.
     *
     * @throws IllegalArgumentException if it is not on one, or there is no room behind it
     */
    public synchronized void undock() {
        if (!body.surroundings().docked()) {
            throw new IllegalArgumentException("the robot is not on a dock");
        }
        place(body.pose().at(body.pose().ahead(-UNDOCK_MM, 0)));
    }

    /** Moves the room's marker; if there is none, adds a default one. */
    public synchronized void moveMarker(Pose pose) {
        body.setMarker(body.room().marker().map(marker -> marker.movedTo(pose)).orElseGet(() -> Marker.at(pose)));
    }

    /**
     * Covers the marker with a cloth, or uncovers it.
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

    /** The robot's current true state. */
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
