package org.evoloop.roomba.camera.live;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.vision.FrameSize;

/**
 * How to look.
 *
 * @since 0.1
 */
public final class CameraSettings {
    private final CameraSource source;
    private final MarkerSpec marker;
    private final CameraModel model;
    private final FrameSize size;
    private final int framesInARow;
    private final Duration staleAfter;
    private final Optional<Path> record;

    private CameraSettings(
            CameraSource source,
            MarkerSpec marker,
            CameraModel model,
            FrameSize size,
            int framesInARow,
            Duration staleAfter,
            Optional<Path> record) {
        this.source = source;
        this.marker = marker;
        this.model = model;
        this.size = size;
        this.framesInARow = framesInARow;
        this.staleAfter = staleAfter;
        this.record = record;
    }

    /** The usual marker, 60 degrees, 640x480, two frames in a row, stalled after 300 ms, no recording. */
    public static CameraSettings of(CameraSource source) {
        return new CameraSettings(
                source,
                MarkerSpec.DEFAULT,
                CameraModel.DEFAULT,
                FrameSize.DEFAULT,
                2,
                Duration.ofMillis(300),
                Optional.empty());
    }

    /** The same that looks for another marker. */
    public CameraSettings withMarker(MarkerSpec other) {
        return new CameraSettings(source, other, model, size, framesInARow, staleAfter, record);
    }

    /** The same of another camera. */
    public CameraSettings withModel(CameraModel other) {
        return new CameraSettings(source, marker, other, size, framesInARow, staleAfter, record);
    }

    /** The same that asks for frames of another size. */
    public CameraSettings withSize(FrameSize other) {
        return new CameraSettings(source, marker, model, other, framesInARow, staleAfter, record);
    }

    /** The same that believes what so many frames show. */
    public CameraSettings withFramesInARow(int other) {
        return new CameraSettings(source, marker, model, size, other, staleAfter, record);
    }

    /** The same that waits so long for a frame. */
    public CameraSettings withStaleAfter(Duration other) {
        return new CameraSettings(source, marker, model, size, framesInARow, other, record);
    }

    /** The same that writes what the camera sees to a file, as AVI. */
    public CameraSettings withRecord(Path other) {
        return new CameraSettings(source, marker, model, size, framesInARow, staleAfter, Optional.of(other));
    }

    /** Where the frames come from. */
    public CameraSource source() {
        return source;
    }

    /** What is looked for. */
    public MarkerSpec marker() {
        return marker;
    }

    /** How the camera maps the room to its frames. */
    public CameraModel model() {
        return model;
    }

    /** The size that is wanted of a device's frames. */
    public FrameSize size() {
        return size;
    }

    /** How many frames must show the marker before it is believed, from 1. */
    public int framesInARow() {
        return framesInARow;
    }

    /** How long a camera may be silent: without a new frame for so long, a camera has stalled. */
    public Duration staleAfter() {
        return staleAfter;
    }

    /** Where to write what the camera sees, as AVI. */
    public Optional<Path> record() {
        return record;
    }
}
