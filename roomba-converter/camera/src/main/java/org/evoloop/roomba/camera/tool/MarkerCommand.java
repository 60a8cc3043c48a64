package org.evoloop.roomba.camera.tool;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.MarkerDictionary;
import org.evoloop.roomba.camera.MarkerSpec;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Writes the starting point's marker as a file to print. */
@Command(
        name = "marker",
        description = "Writes the starting point's marker as a PDF or PNG file to print at 100 %%.",
        mixinStandardHelpOptions = true)
public final class MarkerCommand implements Callable<Integer> {
    @Option(
            names = "--out",
            required = true,
            paramLabel = "FILE",
            description = "The file to write: marker.pdf tells how to mount it, marker.png is the marker alone.")
    private Path out = Path.of("");

    @Option(
            names = "--id",
            paramLabel = "N",
            defaultValue = "0",
            description = "The marker's id in its dictionary (default: ${DEFAULT-VALUE}).")
    private int id;

    @Option(
            names = "--side",
            paramLabel = "MM",
            defaultValue = "150",
            description = "The side of its black square, in mm (default: ${DEFAULT-VALUE}).")
    private double sideMm;

    @Option(
            names = "--dictionary",
            paramLabel = "NAME",
            defaultValue = "4x4_50",
            description = "Its dictionary (default: ${DEFAULT-VALUE}); all others need OpenCV.")
    private String dictionary = "";

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it before the call
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        MarkerSpec marker = new MarkerSpec(MarkerDictionary.parse(dictionary), id, sideMm);
        String name = out.toString().toLowerCase(Locale.ROOT);
        Path folder = out.toAbsolutePath().getParent();
        if (!name.endsWith(".pdf") && !name.endsWith(".png")) {
            throw new CameraException("--out " + out + ": is neither a .pdf nor a .png file; name it marker.pdf");
        }
        if (folder == null || !Files.isDirectory(folder)) {
            throw new CameraException("--out " + out + ": there is no such folder; correct the path");
        }
        Files.write(out, name.endsWith(".pdf") ? MarkerPdf.of(marker) : MarkerPng.of(marker));
        spec.commandLine()
                .getOut()
                .printf(
                        Locale.ROOT,
                        "%s: ArUco %s, id %d, side %.1f mm; print at 100 %%, mount upright at the camera's height%n",
                        out,
                        marker.dictionary().label(),
                        marker.id(),
                        marker.sideMm());
        spec.commandLine().getOut().flush();
        return 0;
    }
}
