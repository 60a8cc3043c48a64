package org.evoloop.roomba.camera.opencv;

import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.FrameSize;
import org.opencv.core.Mat;

/** A frame in OpenCV's format: blue, green and red, or gray. */
record MatFrame(Mat mat) implements Frame {
    MatFrame() {
        this(new Mat());
    }

    static Mat of(Frame frame) {
        return ((MatFrame) frame).mat;
    }

    @Override
    public FrameSize size() {
        return new FrameSize(mat.cols(), mat.rows());
    }

    @Override
    public void close() {
        mat.release();
    }
}
