package org.evoloop.link;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Random;
import org.evoloop.link.LinkException.Fault;
import org.jspecify.annotations.Nullable;

/**
 * One end of a cable in memory, for deterministic tests on one thread. Bytes sent by one end can be received by the
 * other at once; {@link #receive} does not wait. Bytes to a closed end are lost, as on a real line.
 *
 * <p>The cable can be faulty: {@link #hangUp()}, {@link #setReading} and {@link #setNoise}.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class MemoryLink implements Link {
    private final String description;
    // One lock for both ends: with one each, two ends that send at once would wait for each other.
    private final Object cable;
    private final WakeLine wakeLine;
    private final MemoryLink peer;

    /** Bytes that have arrived but were not received yet. */
    private final Deque<byte[]> arrived = new ArrayDeque<>();

    private @Nullable LinkException end;
    private boolean reading = true;
    private @Nullable Noise noise;
    private Random random = new Random(0);

    /** The two ends of one cable. */
    public record Pair(MemoryLink converter, MemoryLink device) {}

    /**
     * The noise on a cable.
     *
     * @param seed the same seed has the same effect on the same bytes
     * @param dropRate the share of bytes that are lost, from 0 to 1
     * @param corruptRate the share of the others that arrive with one bit flipped, from 0 to 1
     */
    public record Noise(long seed, double dropRate, double corruptRate) {}

    private MemoryLink(WakeLine wake) {
        this.description = "memory link of the converter";
        this.cable = new Object();
        this.wakeLine = wake;
        this.peer = new MemoryLink(this);
    }

    private MemoryLink(MemoryLink converter) {
        this.description = "memory link of the device";
        this.cable = converter.cable;
        this.wakeLine = WakeLine.NONE;
        this.peer = converter;
    }

    /** A cable without a wake line. */
    public static Pair pair() {
        return pair(WakeLine.NONE);
    }

    /**
     * A cable.
     *
     * @param wake the device's wake pin, which the converter's end drives
     */
    public static Pair pair(WakeLine wake) {
        MemoryLink converter = new MemoryLink(wake);
        return new Pair(converter, converter.peer);
    }

    @Override
    public int receive(byte[] buffer) {
        synchronized (cable) {
            byte[] bytes = arrived.poll();
            if (bytes == null) {
                return end == null ? 0 : ENDED;
            }
            int length = Math.min(bytes.length, buffer.length);
            System.arraycopy(bytes, 0, buffer, 0, length);
            if (length < bytes.length) {
                arrived.addFirst(Arrays.copyOfRange(bytes, length, bytes.length));
            }
            return length;
        }
    }

    @Override
    public @Nullable LinkException loss() {
        synchronized (cable) {
            return end == null || end.fault() == Fault.CLOSED ? null : end;
        }
    }

    @Override
    public void send(byte[] bytes) {
        synchronized (cable) {
            if (end != null) {
                throw end;
            }
            if (!peer.reading) {
                end = new LinkException(Fault.NOT_READING, description + ": the other end takes no bytes");
                throw end;
            }
            byte[] arriving = disturbed(bytes);
            if (peer.end == null && arriving.length > 0) {
                peer.arrived.add(arriving);
            }
        }
    }

    private byte[] disturbed(byte[] bytes) {
        byte[] arriving = bytes.clone();
        if (noise == null) {
            return arriving;
        }
        int length = 0;
        for (byte sent : bytes) {
            if (random.nextDouble() >= noise.dropRate()) {
                boolean corrupt = random.nextDouble() < noise.corruptRate();
                arriving[length++] = corrupt ? (byte) (sent ^ 1 << random.nextInt(Byte.SIZE)) : sent;
            }
        }
        return Arrays.copyOf(arriving, length);
    }

    /** Pulls the cable: each end that is open is lost. */
    public void hangUp() {
        synchronized (cable) {
            loseByHangUp();
            peer.loseByHangUp();
        }
    }

    private void loseByHangUp() {
        if (end == null) {
            end = new LinkException(Fault.HUNG_UP, description + " hung up");
        }
    }

    /** Sets whether this end accepts bytes; if not, the other end is lost as soon as it sends some. */
    public void setReading(boolean reads) {
        synchronized (cable) {
            reading = reads;
        }
    }

    /** Adds noise to the bytes that this end sends from now on. */
    public void setNoise(Noise newNoise) {
        synchronized (cable) {
            noise = newNoise;
            random = new Random(newNoise.seed());
        }
    }

    @Override
    public WakeLine wakeLine() {
        return low -> {
            synchronized (cable) {
                return end == null && wakeLine.setLow(low);
            }
        };
    }

    @Override
    public String description() {
        return description;
    }

    @Override
    public void close() {
        synchronized (cable) {
            if (end == null) {
                end = new LinkException(Fault.CLOSED, description + " is closed");
                arrived.clear();
            }
        }
    }
}
