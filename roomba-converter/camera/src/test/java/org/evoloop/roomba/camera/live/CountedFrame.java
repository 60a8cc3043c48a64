package org.evoloop.roomba.camera.live;

import java.util.concurrent.atomic.AtomicInteger;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.FrameSize;

/** A frame without a picture that counts how often it was closed. */
final class CountedFrame implements Frame {
    final AtomicInteger closed = new AtomicInteger();

    @Override
    public FrameSize size() {
        return FrameSize.DEFAULT;
    }

    @Override
    public void close() {
        closed.incrementAndGet();
    }
}
