package org.evoloop.roomba.simulator.robot;

import java.util.Arrays;
import java.util.Random;

/**
 * The line between robot and client: unequal rates turn bytes into garbage, and a bad cable loses and changes some.
 * Each direction has its own random numbers, so that traffic in one does not affect the other.
 */
final class SerialLine {
    private static final double NOISE_PER_TICK = 0.1;
    private static final int LONGEST_NOISE = 4;

    private final RobotOptions options;
    private final Random toRobotChance;
    private final Random toClientChance;
    private final Random noiseChance;
    private int baud;
    private int clientBaud;

    SerialLine(RobotOptions options) {
        this.options = options;
        this.toRobotChance = new Random(options.seed());
        this.toClientChance = new Random(options.seed() + 1);
        this.noiseChance = new Random(options.seed() + 2);
        this.baud = options.baud();
    }

    void powerOn() {
        baud = options.baud();
    }

    int baud() {
        return baud;
    }

    void setBaud(int bitsPerSecond) {
        baud = bitsPerSecond;
    }

    /** Sets the rate of the client's port; 0 always matches. */
    void setClientBaud(int bitsPerSecond) {
        clientBaud = bitsPerSecond;
    }

    byte[] toRobot(byte[] bytes, int length) {
        byte[] read = ratesAgree() ? Arrays.copyOf(bytes, length) : Uart.read(bytes, length, clientBaud, baud);
        return travel(read, toRobotChance);
    }

    byte[] toClient(byte[] bytes) {
        return travel(ratesAgree() ? bytes : Uart.read(bytes, bytes.length, baud, clientBaud), toClientChance);
    }

    private boolean ratesAgree() {
        return clientBaud == 0 || clientBaud == baud;
    }

    private byte[] travel(byte[] bytes, Random chance) {
        byte[] arrived = new byte[bytes.length];
        int count = 0;
        for (byte octet : bytes) {
            if (chance.nextDouble() >= options.dropShare()) {
                boolean changed = chance.nextDouble() < options.corruptShare();
                arrived[count++] = changed ? other(octet, chance) : octet;
            }
        }
        return Arrays.copyOf(arrived, count);
    }

    private static byte other(byte octet, Random chance) {
        return (byte) (octet ^ (1 + chance.nextInt(255)));
    }

    /** Stray bytes for the time between two ticks; usually none. */
    byte[] noise() {
        if (!options.noise() || noiseChance.nextDouble() >= NOISE_PER_TICK) {
            return new byte[0];
        }
        byte[] stray = new byte[1 + noiseChance.nextInt(LONGEST_NOISE)];
        noiseChance.nextBytes(stray);
        return stray;
    }
}
