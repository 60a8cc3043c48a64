package org.evoloop.roomba.camera.opencv;

import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.FrameReader;
import org.evoloop.roomba.camera.vision.FrameSize;
import org.opencv.core.Mat;
import org.opencv.core.MatOfInt;
import org.opencv.videoio.VideoCapture;
import org.opencv.videoio.Videoio;

/** A source opened by OpenCV with a chosen backend: trying all of them takes long and prints warnings. */
final class CaptureReader implements FrameReader {
    /** How long a server may send nothing, in ms; without this limit, a read from a hanging server never returns. */
    private static final int NETWORK_TIMEOUT_MILLIS = 4000;

    private final VideoCapture capture;
    private final Damage damage = new Damage();
    private boolean closed;

    private CaptureReader(VideoCapture capture) {
        this.capture = capture;
    }

    static CaptureReader open(CameraSource source, FrameSize wanted) {
        source.obstacle().ifPresent(obstacle -> {
            throw new CameraException("camera " + source + " " + obstacle);
        });
        MatOfInt settings = settings(source, wanted);
        try {
            VideoCapture capture = new VideoCapture(source.text(), backend(source), settings);
            if (!capture.isOpened()) {
                capture.release();
                throw new CameraException("camera " + source + " cannot be opened; " + remedy(source));
            }
            return new CaptureReader(capture);
        } finally {
            settings.release();
        }
    }

    private static int backend(CameraSource source) {
        return switch (source.kind()) {
            case DEVICE -> Videoio.CAP_V4L2;
            case URL, FILE -> Videoio.CAP_FFMPEG;
            case IMAGE_SEQUENCE -> Videoio.CAP_IMAGES;
            case SIMULATED ->
                throw new CameraException("camera sim is the simulated robot's; it goes with a simulated robot only");
        };
    }

    private static MatOfInt settings(CameraSource source, FrameSize wanted) {
        return switch (source.kind()) {
            // One buffer, if the driver supports that: buffered frames are outdated when they are read.
            case DEVICE ->
                new MatOfInt(
                        Videoio.CAP_PROP_FRAME_WIDTH,
                        wanted.width(),
                        Videoio.CAP_PROP_FRAME_HEIGHT,
                        wanted.height(),
                        Videoio.CAP_PROP_BUFFERSIZE,
                        1);
            case URL ->
                new MatOfInt(
                        Videoio.CAP_PROP_OPEN_TIMEOUT_MSEC,
                        NETWORK_TIMEOUT_MILLIS,
                        Videoio.CAP_PROP_READ_TIMEOUT_MSEC,
                        NETWORK_TIMEOUT_MILLIS);
            case FILE, IMAGE_SEQUENCE, SIMULATED -> new MatOfInt();
        };
    }

    private static String remedy(CameraSource source) {
        return switch (source.kind()) {
            case DEVICE ->
                "is it a camera (v4l2-ctl --list-devices), and does no other program have it (fuser " + source.text()
                        + ")?";
            case URL -> "does exactly that address answer with Motion JPEG, not with a page that shows it?";
            case FILE -> "is it a video or a picture?";
            case IMAGE_SEQUENCE, SIMULATED -> "are there pictures of that name, numbered without gaps?";
        };
    }

    @Override
    public Received read(Frame into) {
        Mat mat = MatFrame.of(into);
        if (!capture.read(mat) || mat.empty()) {
            return Received.NOTHING;
        }
        return damage.isIn(mat) ? Received.DAMAGED : Received.FRAME;
    }

    @Override
    public void close() {
        if (!closed) {
            closed = true;
            capture.release();
            damage.close();
        }
    }
}
