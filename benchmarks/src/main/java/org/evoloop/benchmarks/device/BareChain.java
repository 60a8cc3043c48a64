package org.evoloop.benchmarks.device;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.benchmarks.ring.HandOff;
import org.evoloop.link.Link;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;
import org.evoloop.natives.Pty;

/**
 * The minimum latency from a byte read to a byte written on this computer: over the same serial link, at the rate of
 * the robot's frames, but with only threads that sleep and wake each other. Alternates between no thread in between and
 * as many as a button press passes through.
 */
public final class BareChain {
    private static final int THREADS = 3;
    private static final int FRAME_BYTES = 8;
    private static final int FRAME_MILLIS = 15;
    private static final int FRAMES_PER_MARK = 20;
    private static final byte MARK = 1;

    private BareChain() {}

    /**
     * Prints the medians and the 99th percentiles in microseconds.
     *
     * @param arguments how many times each path is measured
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        int wanted = Integer.parseInt(arguments[0]);
        try (Pty pty = Pty.open()) {
            try (SerialLink link =
                    SerialLink.open(new SerialSettings(pty.slavePath().toString()))) {
                List<Way> ways = List.of(new Way(link, 0, wanted), new Way(link, THREADS, wanted));
                daemon("reader", () -> read(link, ways));
                Thread robot = daemon("robot", () -> play(pty));
                for (Way way : ways) {
                    way.done.await();
                }
                robot.interrupt();
                robot.join();
                Latencies.print("direct", ways.get(0).nanos);
                Latencies.print("threads", ways.get(1).nanos);
            }
        }
    }

    /** Sends frames endlessly, some of them with a mark. */
    private static void play(Pty pty) {
        byte[] taken = new byte[FRAME_BYTES];
        try {
            for (int frame = 1; ; frame++) {
                byte[] bytes = new byte[FRAME_BYTES];
                bytes[0] = frame % FRAMES_PER_MARK == 0 ? MARK : 0;
                pty.write(bytes, bytes.length);
                pty.read(taken, 0);
                Thread.sleep(FRAME_MILLIS);
            }
        } catch (InterruptedException over) {
            Thread.currentThread().interrupt();
        }
    }

    private static Thread daemon(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    /** Sends each mark along the next path. */
    private static void read(Link link, List<Way> ways) {
        byte[] buffer = new byte[1_024];
        int turn = 0;
        for (int length = link.receive(buffer); length > 0; length = link.receive(buffer)) {
            long now = System.nanoTime();
            for (int index = 0; index < length; index++) {
                if (buffer[index] == MARK) {
                    ways.get(turn++ % ways.size()).go(now);
                }
            }
        }
    }

    /** A path from the reader's thread through a number of other threads to the link. */
    private static final class Way {
        private static final Object TOKEN = new Object();
        private static final byte[] ANSWER = {(byte) 135};

        private final Link link;
        private final Histogram nanos = Latencies.histogram();
        private final CountDownLatch done;
        private final HandOff[] slots;
        private volatile long begunNanos;

        Way(Link link, int threads, int wanted) {
            this.link = link;
            this.done = new CountDownLatch(wanted);
            this.slots = new HandOff[threads];
            for (int index = 0; index < threads; index++) {
                slots[index] = HandOff.Kind.PARKING_SLOT.make();
            }
            for (int index = 0; index < threads; index++) {
                int mine = index;
                daemon("relay-" + index, () -> relay(mine));
            }
        }

        void go(long now) {
            begunNanos = now;
            pass(0);
        }

        private void pass(int to) {
            try {
                if (to < slots.length) {
                    slots[to].give(TOKEN);
                } else {
                    link.send(ANSWER);
                    nanos.recordValue(System.nanoTime() - begunNanos);
                    done.countDown();
                }
            } catch (InterruptedException nobodyDoes) {
                Thread.currentThread().interrupt();
            }
        }

        private void relay(int mine) {
            try {
                while (slots[mine].take() == TOKEN) {
                    pass(mine + 1);
                }
            } catch (InterruptedException nobodyDoes) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
