package org.evoloop.link;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.link.LinkException.Fault;

/** The faults of a serial port, with messages that say how to fix them. */
final class SerialFaults {
    /**
     * Linux error numbers, as passed on by jSerialComm, which also uses 2 for a port that this program has already
     * opened.
     */
    private static final int EPERM = 1;

    private static final int ENOENT = 2;
    private static final int EIO = 5;
    private static final int ENXIO = 6;
    private static final int EAGAIN = 11;
    private static final int EACCES = 13;
    private static final int EBUSY = 16;
    private static final int ENODEV = 19;
    private static final int ENOTTY = 25;

    private SerialFaults() {}

    /** Explains why the system did not open a device. */
    static LinkException notOpened(SerialSettings settings, Path device, int error) {
        return switch (error) {
            case ENOENT -> Files.exists(device) ? busy(settings, device) : noSuchPort(settings);
            case EAGAIN, EBUSY -> busy(settings, device);
            case EACCES, EPERM -> noPermission(settings, device);
            case ENOTTY -> notASerialPort(settings);
            case EIO, ENXIO, ENODEV -> hungUp(settings);
            default ->
                new LinkException(
                        Fault.REFUSED,
                        settings + " cannot be set up (system error " + error
                                + "); try another baud rate, or unplug the cable and plug it in again");
        };
    }

    static LinkException noSuchPort(SerialSettings settings) {
        return new LinkException(Fault.NO_SUCH_PORT, settings + " does not exist; plug the cable in, or " + choice());
    }

    static LinkException notASerialPort(SerialSettings settings) {
        return new LinkException(Fault.NOT_A_SERIAL_PORT, settings.port() + " is not a serial port; " + choice());
    }

    static LinkException busy(SerialSettings settings, Path device) {
        List<String> holders = holders(device);
        String who = holders.isEmpty()
                ? "another program, such as a terminal program, ModemManager or a second converter"
                : String.join(", ", holders);
        return new LinkException(Fault.BUSY, settings + " is in use by " + who + "; end it first");
    }

    static LinkException noPermission(SerialSettings settings, Path device) {
        String user = System.getProperty("user.name", "?");
        return new LinkException(
                Fault.NO_PERMISSION, settings + " may not be used by " + user + "; " + waysIn(device, user));
    }

    /** A device belongs to a group, dialout on Debian and the Raspberry Pi, unless the system's console runs on it. */
    private static String waysIn(Path device, String user) {
        String group = "dialout";
        try {
            PosixFileAttributes attributes = Files.readAttributes(device, PosixFileAttributes.class);
            if (!attributes.permissions().contains(PosixFilePermission.GROUP_WRITE)) {
                return "it is reserved for " + attributes.owner().getName()
                        + ", as a serial console is: switch that off (on a Raspberry Pi with raspi-config),"
                        + " or use another port";
            }
            group = attributes.group().getName();
        } catch (IOException | UnsupportedOperationException hidden) {
            // Assume the usual group.
        }
        return "run 'sudo usermod -aG " + group + " " + user + "', then log out and in again";
    }

    static LinkException hungUp(SerialSettings settings) {
        return new LinkException(
                Fault.HUNG_UP, settings + " hung up: the cable was pulled or the other end is gone; plug it in again");
    }

    static LinkException notReading(SerialSettings settings) {
        return new LinkException(
                Fault.NOT_READING,
                settings + " took no more bytes for " + settings.sendLimitMillis()
                        + " ms; check that the device at the other end is running");
    }

    static LinkException closed(SerialSettings settings) {
        return new LinkException(Fault.CLOSED, settings + " is not open");
    }

    private static String choice() {
        List<String> ports = SerialPorts.available();
        return ports.isEmpty()
                ? "check the adapter: this computer shows no serial port"
                : "choose one of: " + String.join(", ", ports);
    }

    /** The processes that have the device open, as far as this user can see them. */
    private static List<String> holders(Path device) {
        try (Stream<Path> processes = Files.list(Path.of("/proc"))) {
            return processes
                    .filter(process -> process.getFileName().toString().chars().allMatch(Character::isDigit))
                    .filter(process -> holds(process, device))
                    .map(SerialFaults::name)
                    .toList();
        } catch (IOException unknown) {
            return List.of();
        }
    }

    private static boolean holds(Path process, Path device) {
        try (Stream<Path> descriptors = Files.list(process.resolve("fd"))) {
            return descriptors.anyMatch(descriptor -> pointsTo(descriptor, device));
        } catch (IOException | UncheckedIOException hiddenOrGone) {
            return false;
        }
    }

    private static boolean pointsTo(Path descriptor, Path device) {
        try {
            // Each container numbers its own pseudo-terminals, so equal paths may be different devices.
            return Files.readSymbolicLink(descriptor).equals(device)
                    && (!device.startsWith("/dev/pts") || Files.isSameFile(descriptor, device));
        } catch (IOException gone) {
            return false;
        }
    }

    private static String name(Path process) {
        String id = process.getFileName().toString();
        if (id.equals(Long.toString(ProcessHandle.current().pid()))) {
            return "this program";
        }
        try {
            return Files.readString(process.resolve("comm")).strip() + " (process " + id + ")";
        } catch (IOException gone) {
            return "process " + id;
        }
    }
}
