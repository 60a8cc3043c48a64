package org.evoloop.roomba.camera.opencv;

import java.nio.file.Path;
import java.util.List;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.MarkerDictionary;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.vision.Calibration;
import org.evoloop.roomba.camera.vision.Chessboard;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.FrameReader;
import org.evoloop.roomba.camera.vision.FrameRecorder;
import org.evoloop.roomba.camera.vision.FrameSize;
import org.evoloop.roomba.camera.vision.MarkerFinder;
import org.evoloop.roomba.camera.vision.Vision;
import org.opencv.core.Core;

/** OpenCV, loaded. */
public final class OpenCvVision implements Vision {

    /** @param library the native library that belongs to these classes */
    public OpenCvVision(String library) {
        // Called from this class, so that the library is bound to the class loader of OpenCV's classes.
        System.load(library);
        // OpenCV's own threads would take the converter's cores.
        Core.setNumThreads(1);
    }

    @Override
    public String version() {
        return Core.getVersionString();
    }

    @Override
    public Frame newFrame() {
        return new MatFrame();
    }

    @Override
    public FrameReader open(CameraSource source, FrameSize wanted) {
        return CaptureReader.open(source, wanted);
    }

    @Override
    public MarkerFinder finder(MarkerSpec marker, CameraModel model) {
        return new ArucoFinder(marker, model);
    }

    @Override
    public FrameRecorder recorder(Path file, int framesPerSecond, long mostBytes) {
        return new AviRecorder(file, framesPerSecond, mostBytes);
    }

    @Override
    public byte[] jpeg(Frame frame, int mostWidthPx) {
        return Jpeg.of(MatFrame.of(frame), mostWidthPx);
    }

    @Override
    public boolean[][] markerCells(MarkerDictionary dictionary, int id) {
        return Aruco.of(dictionary).cells(id);
    }

    @Override
    public Calibration calibrate(List<Path> pictures, Chessboard board) {
        try (Calibrator calibrator = new Calibrator(board)) {
            pictures.forEach(calibrator::add);
            return calibrator.solve();
        }
    }
}
