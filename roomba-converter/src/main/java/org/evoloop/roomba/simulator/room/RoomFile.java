package org.evoloop.roomba.simulator.room;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * Reads a {@link Room} from a text file. Every line is one thing; lengths are in mm, angles in degrees counterclockwise
 * from the x axis. Empty lines do not count, nor does what follows a {@code #}:
 *
 * <pre>
 *   wall     X Y  X Y            # a rectangle by two opposite corners: walls around a room
 *   wall     X Y  X Y  X Y ...   # or a polygon by its corners
 *   obstacle X Y  X Y  ...       # something solid, a rectangle or a polygon likewise
 *   cliff    X Y  X Y  ...       # where there is no floor, likewise
 *   dock     X Y HEADING         # where a docked robot stands and looks; the dock itself is 176 mm ahead
 *   start    X Y HEADING         # where it begins; if not told, on the dock, or without one at 0 0 0
 * </pre>
 */
public final class RoomFile {
    private static final double FARTHEST_MM = 100_000;

    private final List<Shape> shapes = new ArrayList<>();
    private @Nullable Pose dock;
    private @Nullable Pose start;

    private RoomFile() {}

    /**
     * Reads the file.
     *
     * @throws IllegalArgumentException if it cannot be read or understood; the message names the file, the line and what
     *     would be right
     */
    public static Room read(Path file) {
        try {
            return parse(file.toString(), Files.readAllLines(file));
        } catch (CharacterCodingException binary) {
            throw new IllegalArgumentException(file + ": is not a text file in UTF-8", binary);
        } catch (IOException failure) {
            throw new IllegalArgumentException(
                    file + ": cannot be read; it must be an existing, readable text file", failure);
        }
    }

    /**
     * Reads these lines.
     *
     * @param name of the file, for messages
     * @throws IllegalArgumentException as for {@link #read}
     */
    static Room parse(String name, List<String> lines) {
        RoomFile file = new RoomFile();
        for (int number = 1; number <= lines.size(); number++) {
            try {
                file.parse(lines.get(number - 1));
            } catch (IllegalArgumentException mistake) {
                throw new IllegalArgumentException(name + ", line " + number + ": " + mistake.getMessage(), mistake);
            }
        }
        try {
            return file.room();
        } catch (IllegalArgumentException mistake) {
            throw new IllegalArgumentException(
                    name + ": " + mistake.getMessage() + "; add or change the line 'start X Y HEADING'", mistake);
        }
    }

    private Room room() {
        Pose begin = start != null ? start : dock != null ? dock : Pose.ORIGIN;
        return Room.of(shapes, dock, begin);
    }

    private void parse(String line) {
        List<String> words = Arrays.stream(line.replaceFirst("#.*", "").trim().split("\\s+"))
                .filter(word -> !word.isEmpty())
                .toList();
        if (words.isEmpty()) {
            return;
        }
        List<Double> numbers =
                words.subList(1, words.size()).stream().map(RoomFile::number).toList();
        switch (words.get(0)) {
            case "wall", "obstacle", "cliff" -> shapes.add(shape(words.get(0), numbers));
            case "dock" -> dock = pose("dock", dock, numbers);
            case "start" -> start = pose("start", start, numbers);
            default ->
                throw new IllegalArgumentException(
                        "'" + words.get(0) + "' is unknown; a line begins with wall, obstacle, cliff, dock or start");
        }
    }

    private static double number(String word) {
        double number;
        try {
            number = Double.parseDouble(word);
        } catch (NumberFormatException noNumber) {
            throw new IllegalArgumentException("'" + word + "' is not a number", noNumber);
        }
        if (!(Math.abs(number) <= FARTHEST_MM)) {
            throw new IllegalArgumentException(
                    "'" + word + "' is too far away; allowed is -" + (int) FARTHEST_MM + " to " + (int) FARTHEST_MM);
        }
        return number;
    }

    private static Shape shape(String kindName, List<Double> numbers) {
        if (numbers.size() < 4 || numbers.size() % 2 != 0) {
            throw new IllegalArgumentException(kindName + " has " + numbers.size()
                    + " numbers; it needs two corners (a rectangle) or more (a polygon), each as X Y");
        }
        Shape.Kind kind = Shape.Kind.valueOf(kindName.toUpperCase(Locale.ROOT));
        List<Point> corners = new ArrayList<>();
        for (int i = 0; i < numbers.size(); i += 2) {
            corners.add(new Point(numbers.get(i), numbers.get(i + 1)));
        }
        return corners.size() == 2 ? Shape.rectangle(kind, corners.get(0), corners.get(1)) : new Shape(kind, corners);
    }

    private static Pose pose(String name, @Nullable Pose earlier, List<Double> numbers) {
        if (earlier != null) {
            throw new IllegalArgumentException("there is a " + name + " already; remove one of the two");
        }
        if (numbers.size() != 3) {
            throw new IllegalArgumentException(
                    name + " has " + numbers.size() + " numbers; it needs three: X Y HEADING");
        }
        return new Pose(numbers.get(0), numbers.get(1), Math.toRadians(numbers.get(2)));
    }
}
