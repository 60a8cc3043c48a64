package org.evoloop.link;

import java.nio.file.Path;

/**
 * A serial port and its settings. Always 8 data bits, no parity, one stop bit and no flow control.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class SerialSettings {
    /** The rate of most devices with a single rate. */
    public static final int DEFAULT_BAUD = 115_200;

    /** Long enough for a busy computer. */
    public static final int DEFAULT_SEND_LIMIT_MILLIS = 1_000;

    /** A start bit, eight data bits and a stop bit. */
    private static final long BITS_PER_BYTE = 10;

    private final String port;
    private final int baud;
    private final WakeSignal wakeSignal;
    private final int sendLimitMillis;

    /**
     * A port at {@value #DEFAULT_BAUD} baud, on an adapter whose RTS wakes the device.
     *
     * @param port a path such as {@code /dev/ttyUSB0}, which may be a symbolic link, or a bare name such as {@code
     *     ttyUSB0}
     * @throws IllegalArgumentException if the port has no name
     */
    public SerialSettings(String port) {
        this(port, DEFAULT_BAUD, WakeSignal.RTS, DEFAULT_SEND_LIMIT_MILLIS);
    }

    private SerialSettings(String port, int baud, WakeSignal wakeSignal, int sendLimitMillis) {
        if (port.isBlank()) {
            throw new IllegalArgumentException("the serial port has no name; give one such as /dev/ttyUSB0");
        }
        requirePositive("baud", baud);
        requirePositive("sendLimitMillis", sendLimitMillis);
        this.port = port;
        this.baud = baud;
        this.wakeSignal = wakeSignal;
        this.sendLimitMillis = sendLimitMillis;
    }

    /** A copy with another rate. */
    public SerialSettings withBaud(int newBaud) {
        return new SerialSettings(port, newBaud, wakeSignal, sendLimitMillis);
    }

    /** A copy with another output that wakes the device. */
    public SerialSettings withWakeSignal(WakeSignal newWakeSignal) {
        return new SerialSettings(port, baud, newWakeSignal, sendLimitMillis);
    }

    /** A copy with another limit. */
    public SerialSettings withSendLimitMillis(int newSendLimitMillis) {
        return new SerialSettings(port, baud, wakeSignal, newSendLimitMillis);
    }

    /** The port as given. */
    public String port() {
        return port;
    }

    /** The rate in baud. */
    public int baud() {
        return baud;
    }

    /** The output that wakes the device. */
    public WakeSignal wakeSignal() {
        return wakeSignal;
    }

    /**
     * How much longer than the transmission time of its bytes a send may take before the link counts as lost, in
     * milliseconds.
     */
    public int sendLimitMillis() {
        return sendLimitMillis;
    }

    /** The path of the port; a bare name is in {@code /dev}. */
    public Path path() {
        return port.indexOf('/') < 0 ? Path.of("/dev", port) : Path.of(port);
    }

    /** The port without its folder, for thread names; {@code pts/3} keeps its folder. */
    String shortName() {
        return port.startsWith("/dev/") ? port.substring("/dev/".length()) : port.substring(port.lastIndexOf('/') + 1);
    }

    /** The transmission time of this number of bytes. */
    long lineNanos(int bytes) {
        return bytes * BITS_PER_BYTE * 1_000_000_000L / baud;
    }

    @Override
    public String toString() {
        return "serial port " + port + " at " + baud + " baud";
    }

    private static void requirePositive(String name, int value) {
        if (value <= 0) {
            throw new IllegalArgumentException(name + " is " + value + " and must be greater than 0");
        }
    }
}
