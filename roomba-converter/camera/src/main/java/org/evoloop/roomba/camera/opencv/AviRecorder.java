package org.evoloop.roomba.camera.opencv;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.vision.Detection;
import org.evoloop.roomba.camera.vision.Detection.Corner;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.FrameRecorder;
import org.jspecify.annotations.Nullable;
import org.opencv.core.Mat;
import org.opencv.core.Point;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.imgproc.Imgproc;
import org.opencv.videoio.VideoWriter;
import org.opencv.videoio.Videoio;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes AVI up to a size limit: as MPEG-4 if OpenCV was built with FFmpeg, as in Debian, else as Motion JPEG, which
 * OpenCV can always encode.
 */
final class AviRecorder implements FrameRecorder {
    private static final Scalar OUTLINE = new Scalar(0, 255, 0);
    private static final Scalar TEXT = new Scalar(255, 255, 255);
    private static final Scalar SHADOW = new Scalar(0, 0, 0);
    private static final int LINE_HEIGHT_PX = 18;

    /** For Motion JPEG: marker and captions stay legible, at half the size of OpenCV's default. */
    private static final int QUALITY_PERCENT = 60;

    private static final int INDEX_ENTRY_BYTES = 16;

    /** The most that the encoder may hold in its buffer: a frame of 1920x1080 takes less. */
    private static final int LARGEST_FRAME_BYTES = 1_000_000;

    private static final Logger LOG = LoggerFactory.getLogger(AviRecorder.class);

    /** The longest pause between frames that is recorded as a still picture, in seconds. */
    private static final long LONGEST_STILL_SECONDS = 10;

    private final Path file;
    private final int framesPerSecond;
    private final long mostBytes;
    private final Mat drawn = new Mat();
    private final Mat fitted = new Mat();
    private @Nullable VideoWriter writer;
    private Size size = new Size();
    private boolean full;
    private long nextNanos;
    private long frames;

    AviRecorder(Path file, int framesPerSecond, long mostBytes) {
        Path folder = file.toAbsolutePath().getParent();
        if (!file.toString().endsWith(".avi")
                || folder == null
                || !Files.isWritable(folder)
                || Files.isDirectory(file)) {
            throw unwritable(file);
        }
        this.file = file;
        this.framesPerSecond = framesPerSecond;
        this.mostBytes = mostBytes;
    }

    @Override
    public void write(Frame frame, long takenNanos, Optional<Detection> detection, List<String> captions) {
        if (full) {
            return;
        }
        Mat seen = MatFrame.of(frame);
        VideoWriter open = writer == null ? open(seen, takenNanos) : writer;
        if (takenNanos < nextNanos) {
            return;
        }
        if (seen.channels() == 1) {
            Imgproc.cvtColor(seen, drawn, Imgproc.COLOR_GRAY2BGR);
        } else {
            seen.copyTo(drawn);
        }
        detection.ifPresent(this::outline);
        for (int line = 0; line < captions.size(); line++) {
            caption(captions.get(line), (line + 1) * LINE_HEIGHT_PX);
        }
        Mat whole = drawn;
        if (drawn.cols() != (int) size.width || drawn.rows() != (int) size.height) {
            Imgproc.resize(drawn, fitted, size);
            whole = fitted;
        }
        long betweenNanos = 1_000_000_000L / framesPerSecond;
        long due = Math.min((takenNanos - nextNanos) / betweenNanos + 1, LONGEST_STILL_SECONDS * framesPerSecond);
        for (long i = 0; i < due; i++) {
            open.write(whole);
        }
        nextNanos += ((takenNanos - nextNanos) / betweenNanos + 1) * betweenNanos;
        endIfFull(due);
    }

    /** There must be room left for buffered frames and the index. */
    private void endIfFull(long written) {
        frames += written;
        long room = LARGEST_FRAME_BYTES + frames * INDEX_ENTRY_BYTES;
        if (file.toFile().length() + room > mostBytes) {
            full = true;
            LOG.warn(
                    "recording {} has reached its limit of {} MB; --record-limit MB sets another",
                    file,
                    mostBytes / 1_000_000);
            close();
        }
    }

    private VideoWriter open(Mat first, long takenNanos) {
        size = first.size();
        nextNanos = takenNanos;
        VideoWriter opened = opened(Videoio.CAP_FFMPEG, "XVID");
        if (!opened.isOpened()) {
            opened.release();
            opened = opened(Videoio.CAP_OPENCV_MJPEG, "MJPG");
            opened.set(Videoio.VIDEOWRITER_PROP_QUALITY, QUALITY_PERCENT);
        }
        if (!opened.isOpened()) {
            opened.release();
            throw new CameraException(file
                    + ": cannot be written as a recording; its name must end with .avi, in a folder that is there");
        }
        writer = opened;
        return opened;
    }

    private VideoWriter opened(int backend, String codec) {
        char[] name = codec.toCharArray();
        return new VideoWriter(
                file.toString(),
                backend,
                VideoWriter.fourcc(name[0], name[1], name[2], name[3]),
                framesPerSecond,
                size,
                true);
    }

    private static CameraException unwritable(Path file) {
        return new CameraException(
                file
                        + ": cannot be written as a recording; its name must end with .avi, in a folder that may be written to");
    }

    private void outline(Detection detection) {
        List<Corner> corners = detection.corners();
        for (int i = 0; i < corners.size(); i++) {
            Corner next = corners.get((i + 1) % corners.size());
            Imgproc.line(drawn, point(corners.get(i)), point(next), OUTLINE, 2);
        }
        Imgproc.circle(drawn, point(corners.get(0)), 4, OUTLINE, -1);
    }

    private static Point point(Corner corner) {
        return new Point(corner.x(), corner.y());
    }

    private void caption(String text, int yPx) {
        Point at = new Point(6, yPx);
        Imgproc.putText(drawn, text, at, Imgproc.FONT_HERSHEY_SIMPLEX, 0.5, SHADOW, 3);
        Imgproc.putText(drawn, text, at, Imgproc.FONT_HERSHEY_SIMPLEX, 0.5, TEXT, 1);
    }

    @Override
    public void close() {
        if (writer != null) {
            writer.release();
            writer = null;
        }
        drawn.release();
        fitted.release();
    }
}
