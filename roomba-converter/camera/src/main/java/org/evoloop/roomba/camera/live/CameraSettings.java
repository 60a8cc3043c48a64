package org.evoloop.roomba.camera.live;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.vision.FrameSize;

/**
 * The settings of a camera.
 *
 * @since 0.1
 */
public final class CameraSettings {
    /** The smallest size limit of a recording: two megabytes. */
    public static final long LEAST_RECORD_BYTES = 2_000_000;

    private static final long USUAL_RECORD_BYTES = 50_000_000;

    private final CameraSource source;
    private final MarkerSpec marker;
    private final CameraModel model;
    private final FrameSize size;
    private final int framesInARow;
    private final Duration staleAfter;
    private final Optional<Path> record;
    private final long recordLimitBytes;

    private CameraSettings(
            CameraSource source,
            MarkerSpec marker,
            CameraModel model,
            FrameSize size,
            int framesInARow,
            Duration staleAfter,
            Optional<Path> record,
            long recordLimitBytes) {
        if (recordLimitBytes < LEAST_RECORD_BYTES) {
            throw new IllegalArgumentException("the limit of a recording is " + recordLimitBytes
                    + " bytes; allowed is at least " + LEAST_RECORD_BYTES);
        }
        this.source = source;
        this.marker = marker;
        this.model = model;
        this.size = size;
        this.framesInARow = framesInARow;
        this.staleAfter = staleAfter;
        this.record = record;
        this.recordLimitBytes = recordLimitBytes;
    }

    /**
     * The default marker, 60 degrees, 640x480, two frames in a row, stalled after 300 ms, no recording, or one of 50
     * MB.
     */
    public static CameraSettings of(CameraSource source) {
        return new CameraSettings(
                source,
                MarkerSpec.DEFAULT,
                CameraModel.DEFAULT,
                FrameSize.DEFAULT,
                2,
                Duration.ofMillis(300),
                Optional.empty(),
                USUAL_RECORD_BYTES);
    }

    /** A copy with another marker. */
    public CameraSettings withMarker(MarkerSpec other) {
        return new CameraSettings(source, other, model, size, framesInARow, staleAfter, record, recordLimitBytes);
    }

    /** A copy with another camera model. */
    public CameraSettings withModel(CameraModel other) {
        return new CameraSettings(source, marker, other, size, framesInARow, staleAfter, record, recordLimitBytes);
    }

    /** A copy with another frame size. */
    public CameraSettings withSize(FrameSize other) {
        return new CameraSettings(source, marker, model, other, framesInARow, staleAfter, record, recordLimitBytes);
    }

    /** A copy that requires this many frames in a row. */
    public CameraSettings withFramesInARow(int other) {
        return new CameraSettings(source, marker, model, size, other, staleAfter, record, recordLimitBytes);
    }

    /** A copy that waits this long for a frame. */
    public CameraSettings withStaleAfter(Duration other) {
        return new CameraSettings(source, marker, model, size, framesInARow, other, record, recordLimitBytes);
    }

    /** A copy that records the camera's frames to a file, as AVI. */
    public CameraSettings withRecord(Path other) {
        return new CameraSettings(
                source, marker, model, size, framesInARow, staleAfter, Optional.of(other), recordLimitBytes);
    }

    /** A copy with a recording of at most this many bytes, from {@value #LEAST_RECORD_BYTES}. */
    public CameraSettings withRecordLimit(long bytes) {
        return new CameraSettings(source, marker, model, size, framesInARow, staleAfter, record, bytes);
    }

    /** The source of the frames. */
    public CameraSource source() {
        return source;
    }

    /** The marker to look for. */
    public MarkerSpec marker() {
        return marker;
    }

    /** The camera's model. */
    public CameraModel model() {
        return model;
    }

    /** The requested size of a device's frames. */
    public FrameSize size() {
        return size;
    }

    /** How many frames must show the marker before it is accepted, from 1. */
    public int framesInARow() {
        return framesInARow;
    }

    /** The time without a new frame after which a camera counts as stalled. */
    public Duration staleAfter() {
        return staleAfter;
    }

    /** The largest size of a recording, in bytes. */
    public long recordLimitBytes() {
        return recordLimitBytes;
    }

    /** The file of the recording, as AVI. */
    public Optional<Path> record() {
        return record;
    }
}
