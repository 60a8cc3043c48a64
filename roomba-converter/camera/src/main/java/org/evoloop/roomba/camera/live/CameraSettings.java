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
 * @param size wanted of a device's frames
 * @param framesInARow how many must show the marker before it is believed, from 1
 * @param staleAfter without a new frame for so long, a camera has stalled
 * @param record where to write what the camera sees, as AVI
 * @since 0.1
 */
public record CameraSettings(
        CameraSource source,
        MarkerSpec marker,
        CameraModel model,
        FrameSize size,
        int framesInARow,
        Duration staleAfter,
        Optional<Path> record) {

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

    /** The same, with another marker. */
    public CameraSettings withMarker(MarkerSpec other) {
        return new CameraSettings(source, other, model, size, framesInARow, staleAfter, record);
    }

    /** The same, with another model. */
    public CameraSettings withModel(CameraModel other) {
        return new CameraSettings(source, marker, other, size, framesInARow, staleAfter, record);
    }

    /** The same, with another size. */
    public CameraSettings withSize(FrameSize other) {
        return new CameraSettings(source, marker, model, other, framesInARow, staleAfter, record);
    }

    /** The same, with another number of frames. */
    public CameraSettings withFramesInARow(int other) {
        return new CameraSettings(source, marker, model, size, other, staleAfter, record);
    }

    /** The same, with another time after which it has stalled. */
    public CameraSettings withStaleAfter(Duration other) {
        return new CameraSettings(source, marker, model, size, framesInARow, other, record);
    }

    /** The same, with a recording. */
    public CameraSettings withRecord(Path other) {
        return new CameraSettings(source, marker, model, size, framesInARow, staleAfter, Optional.of(other));
    }
}
