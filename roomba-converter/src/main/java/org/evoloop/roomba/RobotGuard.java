package org.evoloop.roomba;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import org.evoloop.converter.DeviceLink;
import org.evoloop.function.Reading;
import org.evoloop.link.Link;
import org.evoloop.link.SerialSettings;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.service.DeviceGuard;
import org.evoloop.service.GuardedDevice;
import org.jspecify.annotations.Nullable;

/**
 * Stops the robot and puts it into Passive mode when this program has ended or is not running, so that its buttons and
 * safety features work as usual.
 *
 * <p>The guard process opens the port only at that moment. jSerialComm locks the port with {@code flock}, which only
 * affects programs that check the lock; the guard ignores it.
 *
 * <p>Threading: as {@link GuardedDevice}; all other methods from any thread.
 */
final class RobotGuard implements GuardedDevice, AutoCloseable {
    private final SerialSettings settings;
    private final DeviceGuard guard;
    private volatile @Nullable GuardedLink link;
    private volatile @Nullable RoombaSession session;

    /** @throws IllegalArgumentException if the guard process cannot be started */
    RobotGuard(String port) {
        settings = new SerialSettings(port);
        try {
            guard = DeviceGuard.start(this);
        } catch (IOException failure) {
            throw new IllegalArgumentException(
                    "nothing would stop the robot if this program were killed: " + failure.getMessage()
                            + "; install bash and util-linux, or go without with --no-guard",
                    failure);
        }
    }

    /** Wraps the cable so that it sends nothing after the robot has been stopped. */
    IntFunction<Link> cable(IntFunction<Link> cable) {
        return baud -> {
            GuardedLink opened = new GuardedLink(cable.apply(baud), guard::maySend);
            link = opened;
            return opened;
        };
    }

    /** Sets the session that knows whether the robot is under control. Returns its link, with the guard's status. */
    DeviceLink watch(RoombaSession watched) {
        session = watched;
        return new DeviceLink() {
            @Override
            public boolean isUp() {
                return watched.isUp();
            }

            @Override
            public List<Reading> readings() {
                return watched.readings();
            }

            @Override
            public Optional<Instant> downSince() {
                return watched.downSince();
            }

            @Override
            public String describe() {
                return watched.describe() + ", " + guard.describe();
            }
        };
    }

    @Override
    public String makeSafeCommand() {
        String path = "'" + settings.path().toString().replace("'", "'\\''") + "'";
        // The port keeps the baud rate at which this program found the robot, even after the program has ended.
        return "rate=$(stty -F " + path + " speed) && { [ \"$rate\" = 19200 ] || rate=" + settings.baud()
                + "; } && stty -F "
                + path + " \"$rate\" raw -echo cs8 -parenb -cstopb -crtscts clocal && printf '" + octal(stop()) + "' > "
                + path;
    }

    /**
     * The bytes that stop the robot. An unfinished command consumes at most as many of them as the longest command has;
     * the robot executes the rest. A robot that works by itself ignores them.
     */
    private static byte[] stop() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.writeBytes(new ActuatorCommand.DriveDirect(0, 0).bytes());
        bytes.writeBytes(new ActuatorCommand.DriveDirect(0, 0).bytes());
        for (int rest = RoombaSession.STREAM.size() + 2; rest >= 0; rest--) {
            bytes.writeBytes(new Command.Start().bytes());
        }
        return bytes.toByteArray();
    }

    private static String octal(byte[] bytes) {
        StringBuilder text = new StringBuilder();
        for (byte each : bytes) {
            text.append(String.format(Locale.ROOT, "\\%03o", each & 0xFF));
        }
        return text.toString();
    }

    @Override
    public boolean isActive() {
        RoombaSession watched = session;
        return watched != null && watched.mayBeUnderControl();
    }

    @Override
    public void madeSafe(String reason) {
        RoombaSession watched = session;
        if (watched != null) {
            watched.stoppedByOthers(reason);
        }
        GuardedLink current = link;
        if (current != null) {
            current.lose(reason);
        }
    }

    @Override
    public void close() {
        guard.close();
    }
}
