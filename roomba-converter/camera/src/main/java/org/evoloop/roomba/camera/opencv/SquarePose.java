package org.evoloop.roomba.camera.opencv;

import java.util.List;
import java.util.Optional;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.CameraModel.Intrinsics;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.vision.Detection.Corner;
import org.evoloop.roomba.camera.vision.FrameSize;
import org.jspecify.annotations.Nullable;
import org.opencv.calib3d.Calib3d;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.MatOfDouble;
import org.opencv.core.MatOfPoint2f;
import org.opencv.core.MatOfPoint3f;
import org.opencv.core.Point;
import org.opencv.core.Point3;

/**
 * The position of a square of known size, computed from its corners in a frame. Its centre is precise, its orientation
 * is not: far away, a square turned left and one turned right have nearly the same corners.
 */
final class SquarePose implements AutoCloseable {
    private final CameraModel model;
    private final MatOfPoint3f square;
    private final MatOfPoint2f image = new MatOfPoint2f();
    private final Mat camera = new Mat(3, 3, CvType.CV_64F);
    private final MatOfDouble distortion = new MatOfDouble();
    private final Mat rotation = new Mat();
    private final Mat translation = new Mat();
    private @Nullable FrameSize prepared;

    SquarePose(double sideMm, CameraModel model) {
        this.model = model;
        double half = sideMm / 2;
        // The order and axes that IPPE_SQUARE requires.
        square = new MatOfPoint3f(
                new Point3(-half, half, 0),
                new Point3(half, half, 0),
                new Point3(half, -half, 0),
                new Point3(-half, -half, 0));
    }

    Optional<Sighting> sighting(List<Corner> corners, int width, int height) {
        prepare(new FrameSize(width, height));
        image.fromList(corners.stream()
                .map(corner -> new Point(corner.x(), corner.y()))
                .toList());
        boolean solved = Calib3d.solvePnP(
                square, image, camera, distortion, rotation, translation, false, Calib3d.SOLVEPNP_IPPE_SQUARE);
        double right = solved ? translation.get(0, 0)[0] : Double.NaN;
        double ahead = solved ? translation.get(2, 0)[0] : Double.NaN;
        if (!Double.isFinite(right) || !(ahead > 0)) {
            return Optional.empty();
        }
        // The camera is mounted horizontally, so leaving out the height projects onto the floor.
        return Optional.of(new Sighting(Math.hypot(right, ahead), Math.atan2(-right, ahead)));
    }

    private void prepare(FrameSize size) {
        if (size.equals(prepared)) {
            return;
        }
        Intrinsics numbers = model.forSize(size.width(), size.height());
        camera.put(0, 0, numbers.focalX(), 0, numbers.centerX(), 0, numbers.focalY(), numbers.centerY(), 0, 0, 1);
        distortion.fromList(numbers.distortion());
        prepared = size;
    }

    @Override
    public void close() {
        for (Mat mat : List.of(square, image, camera, distortion, rotation, translation)) {
            mat.release();
        }
    }
}
