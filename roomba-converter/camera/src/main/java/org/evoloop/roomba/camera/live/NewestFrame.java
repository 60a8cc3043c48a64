package org.evoloop.roomba.camera.live;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Supplier;
import org.evoloop.roomba.camera.vision.Frame;
import org.jspecify.annotations.Nullable;

/**
 * Passes the newest frame from the reading thread to the processing thread. There are three buffers: each thread uses
 * one, and the third holds the newest frame. The reading thread waits for the processing thread only if every frame
 * must be processed.
 *
 * <p>Threading: thread-safe. After {@link #close}, each frame is closed as soon as its thread returns it.
 */
final class NewestFrame {
    private static final int ROOMS = 3;

    private final boolean everyFrameCounts;
    private final Deque<Frame> empty = new ArrayDeque<>();
    private @Nullable Taken newest;
    private boolean closed;

    /** A frame, and when it arrived. */
    record Taken(Frame frame, long nanos) {}

    NewestFrame(Supplier<Frame> maker, boolean everyFrameCounts) {
        this.everyFrameCounts = everyFrameCounts;
        for (int i = 0; i < ROOMS; i++) {
            empty.add(maker.get());
        }
    }

    /** A buffer to read into; it belongs to the reading thread until it is published or returned. */
    synchronized Frame room() throws InterruptedException {
        awaitLookedAt();
        if (closed) {
            throw new InterruptedException("closed");
        }
        return empty.remove();
    }

    /** If every frame must be processed: waits until all published frames have been. */
    synchronized void awaitLookedAt() throws InterruptedException {
        while (everyFrameCounts && empty.size() < ROOMS && !closed) {
            wait();
        }
    }

    /** Makes this the newest frame; an unprocessed previous one is dropped. */
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

    /** Waits for an unprocessed frame; it must be returned with {@link #giveBack}. */
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

    /** Returns a frame obtained from {@link #take} or {@link #room}. */
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
