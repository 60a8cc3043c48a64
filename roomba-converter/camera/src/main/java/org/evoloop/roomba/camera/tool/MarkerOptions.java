package org.evoloop.roomba.camera.tool;

import org.evoloop.roomba.camera.MarkerDictionary;
import org.evoloop.roomba.camera.MarkerSpec;
import picocli.CommandLine.Option;

/** The command-line options for the marker at the starting point. */
public final class MarkerOptions {
    @Option(
            names = "--marker-id",
            paramLabel = "N",
            defaultValue = "0",
            description = "The marker's id in its dictionary (default: ${DEFAULT-VALUE}).")
    private int id;

    @Option(
            names = "--marker-side",
            paramLabel = "MM",
            defaultValue = "150",
            description = "The side of its black square, in mm (default: ${DEFAULT-VALUE}).")
    private double sideMm;

    @Option(
            names = "--dictionary",
            paramLabel = "NAME",
            defaultValue = "4x4_50",
            description = "Its dictionary, as OpenCV names them: 4x4_50, 36h11, ... (default: ${DEFAULT-VALUE}).")
    private String dictionary = "";

    /**
     * The marker.
     *
     * @throws org.evoloop.roomba.camera.CameraException if there is no such marker
     */
    public MarkerSpec read() {
        return new MarkerSpec(MarkerDictionary.parse(dictionary), id, sideMm);
    }
}
