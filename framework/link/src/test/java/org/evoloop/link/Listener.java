package org.evoloop.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.lang.management.ManagementFactory;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Reads a link and records what was received. */
class Listener {
    static final long PATIENCE_SECONDS = 30;

    private final ByteArrayOutputStream received = new ByteArrayOutputStream();
    private final CompletableFuture<LinkException> lost = new CompletableFuture<>();
    private volatile long threadCpuNanos;

    /** Reads on its own thread until the link ends. */
    Link listenTo(Link link) {
        Thread reader = new Thread(() -> read(link), "listener");
        reader.setDaemon(true);
        reader.start();
        return link;
    }

    /** Reads until the link ends. */
    void read(Link link) {
        byte[] buffer = new byte[1_024];
        for (int length = link.receive(buffer); length > 0; length = link.receive(buffer)) {
            received(buffer, length);
        }
        LinkException cause = link.loss();
        if (cause != null) {
            lost(cause);
        }
    }

    synchronized void received(byte[] buffer, int length) {
        assertThat(lost).as("nothing is received after a loss").isNotDone();
        received.write(buffer, 0, length);
        notifyAll();
    }

    void lost(LinkException cause) {
        threadCpuNanos = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        assertThat(lost.complete(cause)).as("a loss is reported once").isTrue();
    }

    synchronized byte[] received() {
        return received.toByteArray();
    }

    /** Waits until this many bytes have been received in total. */
    synchronized byte[] awaitReceived(int length) throws InterruptedException {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (received.size() < length && System.nanoTime() - deadline < 0) {
            TimeUnit.NANOSECONDS.timedWait(this, deadline - System.nanoTime());
        }
        assertThat(received.size()).isGreaterThanOrEqualTo(length);
        return received();
    }

    LinkException awaitLost() throws InterruptedException, ExecutionException, TimeoutException {
        return lost.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    }

    boolean isLost() {
        return lost.isDone();
    }

    /** The total processor time of the thread that reported the loss. */
    long threadCpuNanos() {
        return threadCpuNanos;
    }
}
