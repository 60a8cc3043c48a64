package org.evoloop.roomba.link;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Queue;
import java.util.Random;
import org.evoloop.roomba.link.LinkException.Fault;
import org.jspecify.annotations.Nullable;

/**
 * One end of a cable in memory, for tests that run on one thread and always run the same way. What one end sends the
 * other's receiver has before the send returns; only what a receiver sends while it is being told something waits until
 * that is done, so that no receiver is entered twice. To an end that is not open bytes are lost, as on a real line.
 *
 * <p>The cable can be faulty: {@link #hangUp()}, {@link #setReading} and {@link #setNoise}.
 *
 * <p>Threading: thread-safe; one thread at a time is let into the cable, and the receivers run on it. An exception of
 * a receiver reaches whoever sent.
 */
public final class MemoryLink implements Link {
    private final String description;
    private final Cable cable;
    private final WakeLine wakeLine;
    private final MemoryLink peer;
    private @Nullable Receiver receiver;
    private @Nullable LinkException end;
    private boolean reading = true;
    private @Nullable Noise noise;
    private Random random = new Random(0);

    /** The two ends of one cable. */
    public record Pair(MemoryLink converter, MemoryLink robot) {}

    /**
     * What happens to bytes under way.
     *
     * @param seed the same seed does the same to the same bytes
     * @param dropRate which share of the bytes is lost, from 0 to 1
     * @param corruptRate which share of the others arrives with one bit flipped, from 0 to 1
     */
    public record Noise(long seed, double dropRate, double corruptRate) {}

    /** What is under way, in the order in which it was sent. */
    private static final class Cable {
        private final Queue<Runnable> deliveries = new ArrayDeque<>();
        private boolean delivering;

        void deliver(Runnable delivery) {
            deliveries.add(delivery);
            if (delivering) {
                return;
            }
            delivering = true;
            try {
                for (Runnable next = deliveries.poll(); next != null; next = deliveries.poll()) {
                    next.run();
                }
            } finally {
                delivering = false;
            }
        }
    }

    private MemoryLink(WakeLine brc) {
        this.description = "memory link of the converter";
        this.cable = new Cable();
        this.wakeLine = brc;
        this.peer = new MemoryLink(this);
    }

    private MemoryLink(MemoryLink converter) {
        this.description = "memory link of the robot";
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
     * @param brc the robot's BRC pin, which the converter's end drives
     */
    public static Pair pair(WakeLine brc) {
        MemoryLink converter = new MemoryLink(brc);
        return new Pair(converter, converter.peer);
    }

    @Override
    public void open(Receiver newReceiver) {
        synchronized (cable) {
            if (receiver != null || end != null) {
                throw new IllegalStateException(description + " has been opened or closed before; make a new one");
            }
            receiver = newReceiver;
        }
    }

    @Override
    public void send(byte[] bytes) {
        synchronized (cable) {
            requireOpen();
            if (!peer.reading) {
                throw lose(new LinkException(Fault.NOT_READING, description + ": the other end takes no bytes"));
            }
            byte[] arriving = disturbed(bytes);
            cable.deliver(() -> peer.arrive(arriving));
        }
    }

    private void requireOpen() {
        if (end != null) {
            throw end;
        }
        if (receiver == null) {
            throw new LinkException(Fault.CLOSED, description + " is not open");
        }
    }

    private void arrive(byte[] bytes) {
        if (receiver != null && end == null && bytes.length > 0) {
            receiver.received(bytes, bytes.length);
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

    private LinkException lose(LinkException cause) {
        end = cause;
        Receiver told = receiver;
        if (told != null) {
            cable.deliver(() -> told.lost(cause));
        }
        return cause;
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
            lose(new LinkException(Fault.HUNG_UP, description + " hung up"));
        }
    }

    /** Whether this end takes bytes; if not, the other is lost as soon as it sends some. */
    public void setReading(boolean reads) {
        synchronized (cable) {
            reading = reads;
        }
    }

    /** Disturbs what this end sends from now on. */
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
                return receiver != null && end == null && wakeLine.setLow(low);
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
            }
        }
    }
}
