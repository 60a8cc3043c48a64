package org.evoloop.roomba.camera.tool;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.roomba.camera.CalibrationFile;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.vision.Calibration;
import org.evoloop.roomba.camera.vision.Chessboard;
import org.evoloop.roomba.camera.vision.OpenCv;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Measures a camera from pictures of a chessboard, and writes the result to a file. */
@Command(
        name = "calibrate",
        description = "Measures a camera from pictures of a chessboard, taken with it from many sides.",
        mixinStandardHelpOptions = true)
public final class CalibrateCommand implements Callable<Integer> {
    private static final Pattern BOARD = Pattern.compile("(\\d{1,2})x(\\d{1,2})");
    private static final int FEWEST_CORNERS = 3;

    @Option(
            names = "--images",
            required = true,
            paramLabel = "FOLDER|GLOB",
            description = "The pictures: all in a folder, or such as 'pictures/*.jpg'.")
    private String images = "";

    @Option(
            names = "--board",
            paramLabel = "CxR",
            defaultValue = "9x6",
            description = "The chessboard's inner corners, where four squares meet (default: ${DEFAULT-VALUE}).")
    private String board = "";

    @Option(
            names = "--square",
            paramLabel = "MM",
            defaultValue = "25",
            description = "The side of its squares, in mm (default: ${DEFAULT-VALUE}).")
    private double squareMm;

    @Option(names = "--out", required = true, paramLabel = "FILE", description = "The file to write.")
    private Path out = Path.of("");

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it before the call
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        Chessboard chessboard = chessboard();
        Calibration calibration = OpenCv.vision().calibrate(pictures(images), chessboard);
        CalibrationFile.write(
                out,
                calibration.model(),
                String.format(
                        Locale.ROOT,
                        "from %d pictures, reprojection error %.3f px",
                        calibration.used().size(),
                        calibration.errorPx()));
        calibration.withoutBoard().forEach(picture -> print("%s: no whole board of %s found in it%n", picture, board));
        print(
                "%d pictures used; reprojection error %.3f px%s%n",
                calibration.used().size(),
                calibration.errorPx(),
                calibration.errorPx() < 1 ? "" : ", which is much: is the board flat, are the pictures sharp?");
        print("%s written; use it with --calibration %s%n", out, out);
        return 0;
    }

    private void print(String format, Object... arguments) {
        spec.commandLine().getOut().printf(Locale.ROOT, format, arguments);
        spec.commandLine().getOut().flush();
    }

    private Chessboard chessboard() {
        Matcher parts = BOARD.matcher(board);
        if (!parts.matches()
                || Integer.parseInt(parts.group(1)) < FEWEST_CORNERS
                || Integer.parseInt(parts.group(2)) < FEWEST_CORNERS) {
            throw new CameraException("--board is " + board
                    + "; write inner corners as columns x rows, 3x3 or more, such as 9x6 for a board of 10x7 squares");
        }
        if (!(squareMm > 0 && squareMm <= 1000)) {
            throw new CameraException("--square is " + squareMm + " mm, allowed is up to 1000");
        }
        return new Chessboard(Integer.parseInt(parts.group(1)), Integer.parseInt(parts.group(2)), squareMm);
    }

    /** Sorted by name. */
    static List<Path> pictures(String images) throws IOException {
        Path named = Path.of(images);
        boolean folder = Files.isDirectory(named);
        Path place = folder ? named : named.toAbsolutePath().getParent();
        if (place == null || !Files.isDirectory(place)) {
            throw new CameraException("--images " + images + ": there is no such folder; correct the path");
        }
        String pattern = folder ? "*.{jpg,jpeg,png,JPG,JPEG,PNG}" : String.valueOf(named.getFileName());
        List<Path> pictures = new ArrayList<>();
        try (DirectoryStream<Path> found = Files.newDirectoryStream(place, pattern)) {
            found.forEach(pictures::add);
        }
        if (pictures.isEmpty()) {
            throw new CameraException("--images " + images + ": no picture has such a name; name a folder with .jpg or "
                    + ".png files, or a pattern such as 'pictures/*.jpg'");
        }
        pictures.sort(null);
        return pictures;
    }
}
