package org.evoloop.roomba.camera;

import java.util.List;

/**
 * How a camera maps directions to pixels: by its field of view, or calibrated.
 *
 * <p>All lengths are in pixels; x runs to the right, y down, from the middle of the upper left pixel.
 *
 * @since 0.1
 */
public sealed interface CameraModel {

    /** The field of view of most webcams. */
    CameraModel DEFAULT = new FieldOfView(60);

    /**
     * The model for frames of this size.
     *
     * @throws CameraException if it does not apply to this size
     */
    Intrinsics forSize(int width, int height);

    /**
     * The parameters of the pinhole model.
     *
     * @param distortion k1, k2, p1, p2, k3 as in OpenCV, or empty
     */
    record Intrinsics(double focalX, double focalY, double centerX, double centerY, List<Double> distortion) {
        public Intrinsics {
            distortion = List.copyOf(distortion);
        }
    }

    /**
     * Square pixels, the optical axis in the middle, no distortion.
     *
     * @param horizontalDegrees between the left and the right edge of the frame, 20 to 150
     */
    record FieldOfView(double horizontalDegrees) implements CameraModel {
        public FieldOfView {
            if (!(horizontalDegrees >= 20 && horizontalDegrees <= 150)) {
                throw new CameraException(
                        "the camera's field of view is " + horizontalDegrees + " degrees, allowed is 20 to 150");
            }
        }

        @Override
        public Intrinsics forSize(int width, int height) {
            double focal = width / 2.0 / Math.tan(Math.toRadians(horizontalDegrees / 2));
            return new Intrinsics(focal, focal, (width - 1) / 2.0, (height - 1) / 2.0, List.of());
        }
    }

    /**
     * Measured for frames of one size; scaled for other sizes with the same aspect ratio.
     *
     * @param width the width of the frames it was measured with
     * @param height their height
     */
    record Calibrated(int width, int height, Intrinsics intrinsics) implements CameraModel {
        private static final double SAME_SHAPE = 0.01;

        @Override
        public Intrinsics forSize(int frameWidth, int frameHeight) {
            double scaleX = (double) frameWidth / width;
            double scaleY = (double) frameHeight / height;
            if (Math.abs(scaleX / scaleY - 1) > SAME_SHAPE) {
                throw new CameraException("the calibration is for frames of " + width + "x" + height
                        + ", the camera sends " + frameWidth + "x" + frameHeight
                        + "; calibrate with frames of that shape");
            }
            return new Intrinsics(
                    intrinsics.focalX() * scaleX,
                    intrinsics.focalY() * scaleY,
                    (intrinsics.centerX() + 0.5) * scaleX - 0.5,
                    (intrinsics.centerY() + 0.5) * scaleY - 0.5,
                    intrinsics.distortion());
        }
    }
}
