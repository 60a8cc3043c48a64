package org.evoloop.roomba.camera.tool;

import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.roomba.camera.CalibrationFile;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.live.CameraSettings;
import org.evoloop.roomba.camera.vision.FrameSize;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The command-line options for a camera and what it looks for, except for the choice of the camera. */
public final class CameraOptions {
    private static final long BYTES_PER_MB = 1_000_000;
    private static final Pattern SIZE = Pattern.compile("(\\d{2,5})x(\\d{2,5})");

    @Option(
            names = {"--field-of-view", "--camera-fov"},
            paramLabel = "DEGREES",
            description = "The camera's horizontal field of view (default: 60); a calibration is better.")
    private @Nullable Double fieldOfViewDegrees;

    @Option(
            names = {"--calibration", "--camera-calibration"},
            paramLabel = "FILE",
            description = "What 'calibrate' has measured; instead of --field-of-view.")
    private @Nullable Path calibration;

    @Option(
            names = "--camera-size",
            paramLabel = "WxH",
            defaultValue = "640x480",
            description = "The frames to ask a device for (default: ${DEFAULT-VALUE}).")
    private String size = "";

    @Option(names = "--record", paramLabel = "FILE.avi", description = "Records what the camera sees and finds.")
    private @Nullable Path record;

    @Option(
            names = "--record-limit",
            paramLabel = "MB",
            description = "How large the recording may become, from 2 (default: 50); it ends there.")
    private @Nullable Integer recordLimit;

    @Mixin
    private final MarkerOptions marker = new MarkerOptions();

    /**
     * The settings for this camera.
     *
     * @throws CameraException if options are contradictory or invalid, or the calibration cannot be used
     */
    public CameraSettings read(CameraSource source) {
        CameraSettings settings = CameraSettings.of(source)
                .withMarker(marker.read())
                .withModel(model())
                .withSize(size());
        Path file = record;
        Integer limit = recordLimit;
        if (file == null) {
            if (limit != null) {
                throw new CameraException("--record-limit goes with --record; give both or neither");
            }
            return settings;
        }
        if (limit != null && limit * BYTES_PER_MB < CameraSettings.LEAST_RECORD_BYTES) {
            throw new CameraException("--record-limit is " + limit + ", allowed is at least 2 MB");
        }
        CameraSettings recorded = settings.withRecord(file);
        return limit == null ? recorded : recorded.withRecordLimit(limit * BYTES_PER_MB);
    }

    private CameraModel model() {
        Path measured = calibration;
        Double degrees = fieldOfViewDegrees;
        if (measured != null && degrees != null) {
            throw new CameraException("--calibration and --field-of-view say the same thing; give one of them");
        }
        if (measured != null) {
            return CalibrationFile.read(measured);
        }
        return degrees == null ? CameraModel.DEFAULT : new CameraModel.FieldOfView(degrees);
    }

    private FrameSize size() {
        Matcher parts = SIZE.matcher(size);
        if (!parts.matches()) {
            throw new CameraException("--camera-size is " + size + "; write width x height, such as 640x480");
        }
        return new FrameSize(Integer.parseInt(parts.group(1)), Integer.parseInt(parts.group(2)));
    }
}
