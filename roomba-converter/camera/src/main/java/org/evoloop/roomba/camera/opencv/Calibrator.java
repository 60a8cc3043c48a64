package org.evoloop.roomba.camera.opencv;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraModel.Calibrated;
import org.evoloop.roomba.camera.CameraModel.Intrinsics;
import org.evoloop.roomba.camera.vision.Calibration;
import org.evoloop.roomba.camera.vision.Chessboard;
import org.evoloop.roomba.camera.vision.FrameSize;
import org.jspecify.annotations.Nullable;
import org.opencv.calib3d.Calib3d;
import org.opencv.core.Mat;
import org.opencv.core.MatOfPoint2f;
import org.opencv.core.MatOfPoint3f;
import org.opencv.core.Point3;
import org.opencv.core.Size;
import org.opencv.core.TermCriteria;
import org.opencv.imgcodecs.Imgcodecs;
import org.opencv.imgproc.Imgproc;

/** Collects chessboard pictures and computes the camera's parameters. */
final class Calibrator implements AutoCloseable {
    private static final TermCriteria FINE = new TermCriteria(TermCriteria.EPS + TermCriteria.COUNT, 30, 0.01);
    private static final TermCriteria CONVERGED = new TermCriteria(TermCriteria.EPS + TermCriteria.COUNT, 100, 1e-9);

    private final Chessboard board;
    private final MatOfPoint3f corners = new MatOfPoint3f();
    private final List<Mat> found = new ArrayList<>();
    private final List<Path> used = new ArrayList<>();
    private final List<Path> withoutBoard = new ArrayList<>();
    private @Nullable FrameSize size;

    Calibrator(Chessboard board) {
        this.board = board;
        List<Point3> points = new ArrayList<>();
        for (int row = 0; row < board.rows(); row++) {
            for (int column = 0; column < board.columns(); column++) {
                points.add(new Point3(column * board.squareMm(), row * board.squareMm(), 0));
            }
        }
        corners.fromList(points);
    }

    void add(Path picture) {
        Mat gray = Imgcodecs.imread(picture.toString(), Imgcodecs.IMREAD_GRAYSCALE);
        MatOfPoint2f seen = new MatOfPoint2f();
        boolean kept = false;
        try {
            if (gray.empty()) {
                throw new CameraException(picture + ": is not a picture that can be read; remove it");
            }
            FrameSize its = new FrameSize(gray.cols(), gray.rows());
            if (size == null) {
                size = its;
            } else if (!size.equals(its)) {
                throw new CameraException(
                        picture + ": is " + its + ", the pictures before are " + size + "; use frames of one size");
            }
            kept = Calib3d.findChessboardCorners(gray, new Size(board.columns(), board.rows()), seen);
            if (kept) {
                Imgproc.cornerSubPix(gray, seen, new Size(5, 5), new Size(-1, -1), FINE);
                found.add(seen);
            }
            (kept ? used : withoutBoard).add(picture);
        } finally {
            gray.release();
            if (!kept) {
                seen.release();
            }
        }
    }

    Calibration solve() {
        FrameSize frames = size;
        if (frames == null || used.size() < Calibration.FEWEST_PICTURES) {
            throw new CameraException("only " + used.size() + " pictures show the whole chessboard of "
                    + board.columns() + "x" + board.rows() + " inner corners, and calibrating takes "
                    + Calibration.FEWEST_PICTURES
                    + withoutBoard.stream()
                            .map(Path::toString)
                            .collect(Collectors.joining(", ", "; without it: ", "; take more, in even light")));
        }
        Mat camera = new Mat();
        Mat distortion = new Mat();
        List<Mat> boards = new ArrayList<>();
        List<Mat> rotations = new ArrayList<>();
        List<Mat> translations = new ArrayList<>();
        try {
            found.forEach(seen -> boards.add(corners));
            double error = Calib3d.calibrateCamera(
                    boards,
                    found,
                    new Size(frames.width(), frames.height()),
                    camera,
                    distortion,
                    rotations,
                    translations,
                    0,
                    CONVERGED);
            return new Calibration(
                    new Calibrated(frames.width(), frames.height(), intrinsics(camera, distortion)),
                    error,
                    used,
                    withoutBoard);
        } finally {
            camera.release();
            distortion.release();
            rotations.forEach(Mat::release);
            translations.forEach(Mat::release);
        }
    }

    private static Intrinsics intrinsics(Mat camera, Mat distortion) {
        List<Double> coefficients = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            coefficients.add(
                    distortion.total() > i ? distortion.get(i / distortion.cols(), i % distortion.cols())[0] : 0);
        }
        return new Intrinsics(
                camera.get(0, 0)[0], camera.get(1, 1)[0], camera.get(0, 2)[0], camera.get(1, 2)[0], coefficients);
    }

    @Override
    public void close() {
        corners.release();
        found.forEach(Mat::release);
    }
}
