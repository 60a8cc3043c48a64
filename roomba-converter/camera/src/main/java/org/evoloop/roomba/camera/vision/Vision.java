package org.evoloop.roomba.camera.vision;

import java.nio.file.Path;
import java.util.List;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.MarkerDictionary;
import org.evoloop.roomba.camera.MarkerSpec;

/**
 * The part of OpenCV used here. The objects that it returns hold native memory and must be closed.
 *
 * <p>Threading: thread-safe; the objects that it returns belong to one thread at a time.
 *
 * @since 0.1
 */
public interface Vision {

    /** OpenCV's version, such as 4.6.0. */
    String version();

    /** An empty frame buffer. */
    Frame newFrame();

    /**
     * Opens a source; this may take some seconds.
     *
     * @param wanted the requested size of a device's frames; other sources have a fixed size
     * @throws CameraException if it cannot be opened
     */
    FrameReader open(CameraSource source, FrameSize wanted);

    /** A finder of this marker in pictures of this camera; for one thread, and to be closed. */
    MarkerFinder finder(MarkerSpec marker, CameraModel model);

    /**
     * Starts a recording as AVI.
     *
     * @param framesPerSecond the recording's rate; it plays in real time whatever the camera's rate is
     * @param mostBytes the recording ends before the file exceeds this size
     * @throws CameraException if the file cannot be written
     */
    FrameRecorder recorder(Path file, int framesPerSecond, long mostBytes);

    /**
     * The picture as JPEG, smaller if it is wider than {@code mostWidthPx}.
     *
     * @throws IllegalArgumentException if the frame is empty
     */
    byte[] jpeg(Frame frame, int mostWidthPx);

    /**
     * The cells of a marker, border included, from the top row and the left; true is white.
     *
     * @throws CameraException if the dictionary has no such id
     */
    boolean[][] markerCells(MarkerDictionary dictionary, int id);

    /**
     * Measures a camera from pictures of a chessboard.
     *
     * @throws CameraException if too few pictures show the whole board
     */
    Calibration calibrate(List<Path> pictures, Chessboard board);
}
