package org.evoloop.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import java.util.function.IntPredicate;
import org.evoloop.natives.Pty;

/** Reads a pseudo-terminal on its own thread and echoes on request. Ends when the terminal hangs up. */
final class Peer implements AutoCloseable {
    private final Pty pty;
    private final Listener heard = new Listener();
    private final Thread thread;
    private volatile boolean running = true;

    Peer(Pty pty, IntPredicate echoed) {
        this.pty = pty;
        this.thread = new Thread(() -> run(echoed), "peer");
        thread.start();
    }

    static Peer listening(Pty pty) {
        return new Peer(pty, length -> false);
    }

    static Peer echoing(Pty pty) {
        return new Peer(pty, length -> true);
    }

    private void run(IntPredicate echoed) {
        byte[] buffer = new byte[1_024];
        while (running) {
            int length = pty.read(buffer, Pty.LONGEST_WAIT_MILLIS);
            if (length > 0) {
                if (echoed.test(length)) {
                    pty.write(buffer, length);
                }
                heard.received(buffer, length);
            }
        }
    }

    byte[] awaitHeard(int length) throws InterruptedException {
        return heard.awaitReceived(length);
    }

    @Override
    public void close() {
        running = false;
        boolean ended = BoundedWait.uninterruptibly(TimeUnit.SECONDS.toNanos(Listener.PATIENCE_SECONDS), nanos -> {
            TimeUnit.NANOSECONDS.timedJoin(thread, nanos);
            return !thread.isAlive();
        });
        assertThat(ended).isTrue();
    }
}
