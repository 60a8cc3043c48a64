package org.evoloop.roomba.camera.opencv;

import org.opencv.core.Core;
import org.opencv.core.Mat;
import org.opencv.core.MatOfDouble;

/**
 * Detects unusable frames that the decoder reports as good: JPEG files that end early, whose lower part is a uniform
 * medium gray, and frames with another size than the first.
 */
final class Damage implements AutoCloseable {
    /** The height of a row of blocks in a JPEG file. */
    private static final int ROWS = 16;

    private static final double GRAY = 128;
    private static final double ROUNDING = 1.5;

    private final MatOfDouble mean = new MatOfDouble();
    private final MatOfDouble deviation = new MatOfDouble();
    private int width;
    private int height;

    boolean isIn(Mat frame) {
        if (width == 0) {
            width = frame.cols();
            height = frame.rows();
        }
        return frame.cols() != width || frame.rows() != height || endsInGray(frame);
    }

    private boolean endsInGray(Mat frame) {
        Mat end = frame.rowRange(Math.max(0, frame.rows() - ROWS), frame.rows());
        try {
            Core.meanStdDev(end, mean, deviation);
        } finally {
            end.release();
        }
        for (int channel = 0; channel < mean.rows(); channel++) {
            if (Math.abs(mean.get(channel, 0)[0] - GRAY) > ROUNDING || deviation.get(channel, 0)[0] > ROUNDING) {
                return false;
            }
        }
        return true;
    }

    @Override
    public void close() {
        mean.release();
        deviation.release();
    }
}
