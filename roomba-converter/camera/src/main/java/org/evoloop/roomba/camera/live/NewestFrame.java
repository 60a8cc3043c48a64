package org.evoloop.roomba.camera.live;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Supplier;
import org.evoloop.roomba.camera.vision.Frame;
import org.jspecify.annotations.Nullable;

/**
 * Hands the newest frame from the thread that reads to the one that looks: three rooms for frames, of which each has
 * one and the third holds the newest. Nobody waits for who looks, unless every frame counts.
 *
 * <p>Threading: thread-safe. After {@link #close}, each frame is closed as soon as its thread gives it back.
 */
final class NewestFrame {
    private static final int ROOMS = 3;

    private final boolean everyFrameCounts;
    private final Deque<Frame> empty = new ArrayDeque<>();
    private @Nullable Taken newest;
    private boolean closed;

    /** A frame, and when it came. */
    record Taken(Frame frame, long nanos) {}

    NewestFrame(Supplier<Frame> maker, boolean everyFrameCounts) {
        this.everyFrameCounts = everyFrameCounts;
        for (int i = 0; i < ROOMS; i++) {
            empty.add(maker.get());
        }
    }

    /** Room to read into; of the reading thread, until it is published or given back. */
    synchronized Frame room() throws InterruptedException {
        awaitLookedAt();
        if (closed) {
            throw new InterruptedException("closed");
        }
        return empty.remove();
    }

    /** If every frame counts: waits until all that were published have been looked at. */
    synchronized void awaitLookedAt() throws InterruptedException {
        while (everyFrameCounts && empty.size() < ROOMS && !closed) {
            wait();
        }
    }

    /** Makes it the newest; the one that was and has not been looked at is forgotten. */
    synchronized void publish(Frame frame, long nanos) {
        Taken unseen = newest;
        newest = null;
        if (unseen != null) {
            giveBack(unseen.frame());
        }
        if (closed) {
            frame.close();
        } else {
            newest = new Taken(frame, nanos);
        }
        notifyAll();
    }

    /** Waits for a frame that has not been looked at; it must be given back. */
    synchronized Taken take() throws InterruptedException {
        while (newest == null) {
            if (closed) {
                throw new InterruptedException("closed");
            }
            wait();
        }
        Taken taken = newest;
        newest = null;
        return taken;
    }

    /** Ends what {@link #take} and {@link #room} began. */
    synchronized void giveBack(Frame frame) {
        if (closed) {
            frame.close();
        } else {
            empty.add(frame);
        }
        notifyAll();
    }

    synchronized void close() {
        closed = true;
        empty.forEach(Frame::close);
        empty.clear();
        if (newest != null) {
            newest.frame().close();
            newest = null;
        }
        notifyAll();
    }
}
