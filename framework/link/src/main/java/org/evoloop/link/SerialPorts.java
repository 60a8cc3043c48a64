package org.evoloop.link;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.link.LinkException.Fault;
import org.evoloop.natives.NativeLibraries;

/**
 * Finds and opens serial ports.
 *
 * <p>Threading: thread-safe. jSerialComm keeps one native list and one last error for all ports, so there is one lock.
 */
final class SerialPorts {
    private static final Object LIBRARY = new Object();
    private static final int DATA_BITS = 8;
    private static boolean loaded;

    private SerialPorts() {}

    /** Loads the library if it is not loaded yet; throws {@link LinkException} if that fails. */
    static void load() {
        synchronized (LIBRARY) {
            if (loaded) {
                return;
            }
            try {
                HangupSignal.keptDuring(NativeLibraries::loadSerial);
            } catch (IOException failure) {
                throw new LinkException(Fault.REFUSED, String.valueOf(failure.getMessage()));
            }
            loaded = true;
        }
    }

    static void addShutdownHook(Thread hook) {
        load();
        SerialPort.addShutdownHook(hook);
    }

    static List<String> available() {
        load();
        synchronized (LIBRARY) {
            return Stream.of(SerialPort.getCommPorts())
                    .map(SerialPort::getSystemPortPath)
                    .sorted()
                    .toList();
        }
    }

    /** Opens the port, with empty buffers and its wake line at rest. */
    static SerialPort open(SerialSettings settings) {
        Path device = device(settings);
        load();
        synchronized (LIBRARY) {
            SerialPort port = port(settings, device);
            port.setComPortParameters(settings.baud(), DATA_BITS, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
            port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED);
            port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, 0, 0);
            settings.wakeSignal().drive(port, false);
            port.flushIOBuffers();
            if (!port.openPort()) {
                throw SerialFaults.notOpened(settings, device, port.getLastErrorCode());
            }
            return port;
        }
    }

    private static SerialPort port(SerialSettings settings, Path device) {
        try {
            return SerialPort.getCommPort(device.toString());
        } catch (SerialPortInvalidPortException justGone) {
            throw SerialFaults.noSuchPort(settings);
        }
    }

    /**
     * The device itself. It is resolved anew for each link, because a symbolic link may have changed. jSerialComm would
     * treat a path that does not exist as the port of the same name in {@code /dev}.
     */
    private static Path device(SerialSettings settings) {
        Path device;
        try {
            device = settings.path().toRealPath();
        } catch (AccessDeniedException hidden) {
            throw SerialFaults.noPermission(settings, settings.path());
        } catch (IOException | InvalidPathException missing) {
            throw SerialFaults.noSuchPort(settings);
        }
        if (Files.isDirectory(device) || Files.isRegularFile(device)) {
            throw SerialFaults.notASerialPort(settings);
        }
        return device;
    }
}
