package org.evoloop.roomba.camera.opencv;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.vision.Detection;
import org.evoloop.roomba.camera.vision.Detection.Corner;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.MarkerFinder;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.MatOfPoint2f;
import org.opencv.core.Point;
import org.opencv.core.Size;
import org.opencv.core.TermCriteria;
import org.opencv.imgproc.Imgproc;

/** Finds an ArUco marker. */
final class ArucoFinder implements MarkerFinder {
    /** Removes most of the noise, and the false marker candidates it causes: detection is five times faster. */
    private static final Size BLUR = new Size(3, 3);

    /** As part of a cell; beyond that are other cells' corners, and the edge of the white border. */
    private static final double SEARCHED_PART_OF_CELL = 0.5;

    private static final int WIDEST_SEARCH_PX = 5;
    private static final Size NO_HOLE = new Size(-1, -1);
    private static final TermCriteria ENOUGH = new TermCriteria(TermCriteria.EPS + TermCriteria.COUNT, 30, 0.01);

    private final MarkerSpec marker;
    private final Aruco.Detector detector;
    private final SquarePose pose;
    private final Mat picture = new Mat();
    private final Mat gray = new Mat();
    private final Mat smooth = new Mat();
    private final Mat ids = new Mat();
    private final MatOfPoint2f rough = new MatOfPoint2f();
    private boolean closed;

    ArucoFinder(MarkerSpec marker, CameraModel model) {
        this.marker = marker;
        detector = Aruco.of(marker.dictionary()).detector();
        pose = new SquarePose(marker.sideMm(), model);
    }

    @Override
    public Optional<Detection> detect(Frame frame) {
        return detect(MatFrame.of(frame));
    }

    @Override
    public Optional<Sighting> find(byte[] pixels, int width, int height) {
        int channels = pixels.length == width * height ? 1 : 3;
        if (width <= 0 || height <= 0 || pixels.length != channels * width * height) {
            throw new IllegalArgumentException(
                    pixels.length + " bytes are neither a gray nor a color picture of " + width + "x" + height);
        }
        picture.create(height, width, channels == 1 ? CvType.CV_8UC1 : CvType.CV_8UC3);
        picture.put(0, 0, pixels);
        return detect(picture).map(Detection::sighting);
    }

    private Optional<Detection> detect(Mat seen) {
        if (closed) {
            throw new IllegalStateException("the finder is closed");
        }
        if (seen.channels() == 1) {
            Imgproc.GaussianBlur(seen, smooth, BLUR, 0);
        } else {
            Imgproc.cvtColor(seen, gray, Imgproc.COLOR_BGR2GRAY);
            Imgproc.GaussianBlur(gray, smooth, BLUR, 0);
        }
        List<Mat> found = new ArrayList<>();
        try {
            detector.detect(smooth, found, ids);
            return nearest(found)
                    .map(this::refined)
                    .flatMap(corners -> pose.sighting(corners, seen.cols(), seen.rows())
                            .map(sighting -> new Detection(marker.id(), corners, sighting)));
        } finally {
            found.forEach(Mat::release);
        }
    }

    private Optional<List<Corner>> nearest(List<Mat> found) {
        List<Corner> nearest = List.of();
        for (int i = 0; i < found.size(); i++) {
            if ((int) ids.get(i, 0)[0] == marker.id()) {
                List<Corner> corners = corners(found.get(i));
                if (area(corners) > area(nearest)) {
                    nearest = corners;
                }
            }
        }
        return Optional.of(nearest).filter(corners -> !corners.isEmpty());
    }

    private static List<Corner> corners(Mat row) {
        float[] numbers = new float[8];
        row.get(0, 0, numbers);
        List<Corner> corners = new ArrayList<>();
        for (int i = 0; i < numbers.length; i += 2) {
            corners.add(new Corner(numbers[i], numbers[i + 1]));
        }
        return corners;
    }

    /** Refines corners to subpixel precision. Done here because OpenCV releases differ in the search window. */
    private List<Corner> refined(List<Corner> corners) {
        double cellPx = Math.sqrt(area(corners) / 2) / (marker.dictionary().cells() + 2);
        int around = (int) Math.max(1, Math.min(WIDEST_SEARCH_PX, Math.round(cellPx * SEARCHED_PART_OF_CELL)));
        rough.fromList(corners.stream()
                .map(corner -> new Point(corner.x(), corner.y()))
                .toList());
        Imgproc.cornerSubPix(smooth, rough, new Size(around, around), NO_HOLE, ENOUGH);
        return rough.toList().stream()
                .map(point -> new Corner(point.x, point.y))
                .toList();
    }

    /** Twice the area enclosed by the corners. */
    private static double area(List<Corner> corners) {
        double sum = 0;
        for (int i = 0; i < corners.size(); i++) {
            Corner here = corners.get(i);
            Corner next = corners.get((i + 1) % corners.size());
            sum += here.x() * next.y() - next.x() * here.y();
        }
        return Math.abs(sum);
    }

    @Override
    public void close() {
        closed = true;
        picture.release();
        gray.release();
        smooth.release();
        ids.release();
        rough.release();
        pose.close();
    }
}
