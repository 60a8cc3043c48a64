package org.evoloop.roomba;

import java.io.ByteArrayOutputStream;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.evoloop.learn.Heard;
import org.evoloop.learn.LearnedDevice;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;
import org.evoloop.link.MemoryLink;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/**
 * A Roomba that nobody has a model of: its buttons are pressed over its serial line, and its frames show whether it brushes,
 * drives or rests. The estimate of its activity is not used, since that knows the rules that are to be learned. The same calls
 * always have the same result.
 */
final class ButtonedRoomba implements LearnedDevice, AutoCloseable {
    private static final Duration TICK = Duration.ofMillis(SimulatedRoomba.TICK_MILLIS);

    /** How many frames in a row must show the same: a robot that starts to work shows it within a second. */
    private static final int STEADY = 100;

    private static final int PATIENCE = 1_000;
    private static final int BRUSHING_MILLI_AMPS = 20;
    private static final int MOVING_FRAMES = 10;
    private static final int RESETS = 4;

    final ManualClock clock = new ManualClock();
    private final ByteArrayOutputStream robotSays = new ByteArrayOutputStream();
    private final SimulatedRoomba robot = new SimulatedRoomba(RobotOptions.defaults(), robotSays::writeBytes);
    private final MemoryLink.Noise noise;
    private final RoombaSession session;
    private MemoryLink.@Nullable Pair cable;
    private int sent;
    private @Nullable SensorValues last;
    private int framesSinceMoved = MOVING_FRAMES;
    private String shown = "";
    private long shownSince;
    private int steady;

    /** @param lost the part of all bytes that is lost, both ways */
    ButtonedRoomba(double lost, long seed) {
        noise = new MemoryLink.Noise(seed, lost, 0);
        session =
                new RoombaSession(this::plugIn, clock, SessionOptions.defaults().withoutWaiting());
        session.addListener(new SessionListener() {
            @Override
            public void received(Telemetry telemetry) {
                look(telemetry.values());
            }
        });
        session.open();
        settle();
        // A session takes control of a robot that it meets; under control, the buttons are only reported.
        session.rest();
    }

    private Link plugIn(int baud) {
        MemoryLink.Pair fresh = MemoryLink.pair();
        fresh.device().setNoise(noise);
        fresh.converter().setNoise(noise);
        cable = fresh;
        return fresh.converter();
    }

    private void look(SensorValues values) {
        SensorValues before = last;
        last = values;
        boolean moved = before != null
                && (before.leftEncoderCounts() != values.leftEncoderCounts()
                        || before.rightEncoderCounts() != values.rightEncoderCounts());
        framesSinceMoved = moved ? 0 : framesSinceMoved + 1;
        boolean brushes = Math.abs(values.mainBrushMilliAmps()) > BRUSHING_MILLI_AMPS
                || Math.abs(values.sideBrushMilliAmps()) > BRUSHING_MILLI_AMPS;
        String now = brushes ? "brushes" : framesSinceMoved < MOVING_FRAMES ? "drives" : "rests";
        if (now.equals(shown)) {
            steady++;
        } else {
            shown = now;
            shownSince = clock.nanoTime();
            steady = 0;
        }
    }

    private void tick() {
        robot.tick();
        obey();
        byte[] bytes = robotSays.toByteArray();
        robotSays.reset();
        MemoryLink.Pair current = cable;
        if (bytes.length > 0 && current != null) {
            current.device().send(bytes);
        }
        clock.advance(TICK);
        session.poll();
        obey();
    }

    private void obey() {
        MemoryLink.Pair current = cable;
        if (current != null) {
            byte[] buffer = new byte[1_024];
            for (int length = current.device().receive(buffer);
                    length > 0;
                    length = current.device().receive(buffer)) {
                robot.receive(buffer, length);
            }
        }
    }

    /** Until the frames have shown the same for a time. */
    private void settle() {
        steady = 0;
        for (int i = 0; i < PATIENCE; i++) {
            tick();
            if (steady >= STEADY) {
                return;
            }
        }
        throw new LostException("the robot is never quiet");
    }

    private void send(Command command) {
        try {
            session.send(command);
        } catch (LinkException | RobotException gone) {
            throw new LostException(String.valueOf(gone.getMessage()));
        }
    }

    @Override
    public Heard reset() {
        // Any of these bytes may be lost.
        for (int i = 0; i < RESETS; i++) {
            send(new Command.Power());
            tick();
            send(new Command.Start());
            tick();
        }
        settle();
        return Heard.accepted(shown);
    }

    @Override
    public Heard press(String event) {
        sent++;
        send(new ActuatorCommand.Buttons(Set.of(Button.valueOf(event.toUpperCase(Locale.ROOT)))));
        settle();
        return Heard.accepted(shown);
    }

    @Override
    public Heard await(Duration longest) {
        long begin = shownSince;
        String before = shown;
        while (clock.nanoTime() - begin < longest.toNanos()) {
            tick();
            if (!shown.equals(before)) {
                Duration lasted = Duration.ofNanos(shownSince - begin);
                settle();
                return new Heard(Heard.Reply.ACCEPTED, List.of(), shown, lasted);
            }
        }
        return Heard.silent(shown);
    }

    @Override
    public int sent() {
        return sent;
    }

    @Override
    public void close() {
        session.close();
        clock.close();
    }
}
