package org.evoloop.roomba.camera;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoublePredicate;
import java.util.stream.Collectors;
import org.evoloop.roomba.camera.CameraModel.Calibrated;
import org.evoloop.roomba.camera.CameraModel.Intrinsics;

/**
 * A calibration as text: a name and its numbers on each line; {@code #} begins a comment. All except {@code distortion}
 * are required, once.
 *
 * <pre>
 * width 640
 * height 480
 * focal 554.3 554.1
 * center 319.6 240.2
 * distortion 0.02 -0.11 0 0 0.05
 * </pre>
 *
 * @since 0.1
 */
public final class CalibrationFile {
    private static final Map<String, Integer> NUMBERS =
            Map.of("width", 1, "height", 1, "focal", 2, "center", 2, "distortion", 5);

    private final Path file;
    private final Map<String, double[]> lines = new HashMap<>();

    private CalibrationFile(Path file) {
        this.file = file;
    }

    /**
     * Reads a calibration.
     *
     * @throws CameraException if the file is not a calibration; the message names the line
     */
    public static Calibrated read(Path file) {
        return new CalibrationFile(file).parse();
    }

    private Calibrated parse() {
        List<String> text;
        try {
            text = Files.readAllLines(file);
        } catch (CharacterCodingException binary) {
            throw new CameraException(file + ": is not text; write it with: calibrate", binary);
        } catch (IOException unreadable) {
            throw new CameraException(
                    file + ": " + (Files.exists(file) ? "cannot be read" : "does not exist") + "; correct the path",
                    unreadable);
        }
        for (int line = 0; line < text.size(); line++) {
            parseLine(line + 1, text.get(line).replaceFirst("#.*", "").strip());
        }
        int width = (int) number("width", 0, side -> side == Math.rint(side) && side >= 16 && side <= 16384);
        int height = (int) number("height", 0, side -> side == Math.rint(side) && side >= 16 && side <= 16384);
        return new Calibrated(
                width,
                height,
                new Intrinsics(
                        number("focal", 0, focal -> focal > 0),
                        number("focal", 1, focal -> focal > 0),
                        number("center", 0, x -> x > 0 && x < width),
                        number("center", 1, y -> y > 0 && y < height),
                        Arrays.stream(lines.getOrDefault("distortion", new double[0]))
                                .boxed()
                                .toList()));
    }

    private void parseLine(int line, String content) {
        if (content.isEmpty()) {
            return;
        }
        String[] words = content.split("\\s+", -1);
        Integer wanted = NUMBERS.get(words[0]);
        if (wanted == null) {
            throw new CameraException(file + ": line " + line + ": " + words[0]
                    + " is unknown; allowed are width, height, focal, center and distortion");
        }
        if (words.length != wanted + 1) {
            throw new CameraException(file + ": line " + line + ": " + words[0] + " takes "
                    + (wanted == 1 ? "one number" : wanted + " numbers") + ", there are " + (words.length - 1));
        }
        double[] numbers = new double[wanted];
        for (int i = 0; i < wanted; i++) {
            numbers[i] = parseNumber(line, words[i + 1]);
        }
        if (lines.put(words[0], numbers) != null) {
            throw new CameraException(file + ": line " + line + ": " + words[0] + " is there twice; remove one");
        }
    }

    private double parseNumber(int line, String word) {
        double number;
        try {
            number = Double.parseDouble(word);
        } catch (NumberFormatException notANumber) {
            number = Double.NaN;
        }
        if (!Double.isFinite(number)) {
            throw new CameraException(file + ": line " + line + ": " + word + " is not a number");
        }
        return number;
    }

    private double number(String name, int index, DoublePredicate allowed) {
        double[] numbers = lines.get(name);
        if (numbers == null) {
            throw new CameraException(file + ": has no " + name + "; write the file with: calibrate");
        }
        if (!allowed.test(numbers[index])) {
            throw new CameraException(file + ": " + name + " " + numbers[index] + " is impossible; calibrate again");
        }
        return numbers[index];
    }

    /**
     * Writes a file that {@link #read} can read.
     *
     * @param comment one line for people
     */
    public static void write(Path file, Calibrated model, String comment) throws IOException {
        Intrinsics numbers = model.intrinsics();
        StringBuilder text = new StringBuilder(String.format(
                Locale.ROOT,
                "# %s%nwidth %d%nheight %d%nfocal %.3f %.3f%ncenter %.3f %.3f%n",
                comment,
                model.width(),
                model.height(),
                numbers.focalX(),
                numbers.focalY(),
                numbers.centerX(),
                numbers.centerY()));
        if (!numbers.distortion().isEmpty()) {
            text.append("distortion ")
                    .append(numbers.distortion().stream()
                            .map(number -> String.format(Locale.ROOT, "%.6f", number))
                            .collect(Collectors.joining(" ")))
                    .append(System.lineSeparator());
        }
        Files.writeString(file, text);
    }
}
