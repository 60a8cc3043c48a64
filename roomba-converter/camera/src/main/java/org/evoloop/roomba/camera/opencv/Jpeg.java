package org.evoloop.roomba.camera.opencv;

import org.opencv.core.Mat;
import org.opencv.core.MatOfByte;
import org.opencv.core.MatOfInt;
import org.opencv.core.Size;
import org.opencv.imgcodecs.Imgcodecs;
import org.opencv.imgproc.Imgproc;

/** Encodes pictures as JPEG. */
final class Jpeg {
    /** A picture of 640x480 takes about 40 kB, and its marker is still sharp. */
    private static final int QUALITY_PERCENT = 75;

    private Jpeg() {}

    static byte[] of(Mat picture, int mostWidthPx) {
        if (picture.empty()) {
            throw new IllegalArgumentException("there is no picture in the frame");
        }
        if (picture.cols() <= mostWidthPx) {
            return encoded(picture);
        }
        Mat smaller = new Mat();
        try {
            long height = Math.max(1, Math.round((double) picture.rows() * mostWidthPx / picture.cols()));
            Imgproc.resize(picture, smaller, new Size(mostWidthPx, height), 0, 0, Imgproc.INTER_AREA);
            return encoded(smaller);
        } finally {
            smaller.release();
        }
    }

    private static byte[] encoded(Mat picture) {
        MatOfByte file = new MatOfByte();
        MatOfInt quality = new MatOfInt(Imgcodecs.IMWRITE_JPEG_QUALITY, QUALITY_PERCENT);
        try {
            Imgcodecs.imencode(".jpg", picture, file, quality);
            return file.toArray();
        } finally {
            file.release();
            quality.release();
        }
    }
}
