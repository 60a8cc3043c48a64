package org.evoloop.roomba.simulator.room;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Reads a {@link Room} from a text file. Every line is one object; lengths are in mm, angles in degrees
 * counterclockwise from the x axis. Empty lines and text after {@code #} are ignored:
 *
 * <pre>
 *   wall     X Y  X Y            # a rectangle by two opposite corners: walls around a room
 *   wall     X Y  X Y  X Y ...   # or a polygon by its corners
 *   obstacle X Y  X Y  ...       # something solid, a rectangle or a polygon likewise
 *   cliff    X Y  X Y  ...       # where there is no floor, likewise
 *   dock     X Y HEADING         # where a docked robot stands and its heading; the dock itself is 176 mm ahead
 *   start    X Y HEADING         # where the robot starts; by default on the dock, or without one at 0 0 0
 *   marker   X Y HEADING         # an upright tag of 4x4_50 with id 0 and 150 mm wide, its middle 150 mm above X Y
 *   marker   X Y HEADING ID SIDE HEIGHT   # with other values; the last ones may be omitted
 *   marker   X Y HEADING solid            # one that is an obstacle, also after ID, SIDE and HEIGHT
 * </pre>
 *
 * <p>After its corners a wall or an obstacle may have {@code color RRGGBB}, in hexadecimal, and {@code height MM}.
 *
 * @since 0.1
 */
public final class RoomFile {
    private static final String LIVING_ROOM = "living-room.txt";
    private static final double FARTHEST_MM = 100_000;

    /** The words that may follow the corners of a wall or an obstacle. */
    private static final Set<String> LOOKS = Set.of("color", "height");

    /** The word that may follow a marker's numbers. */
    private static final String SOLID = "solid";

    private final List<Shape> shapes = new ArrayList<>();
    private @Nullable Pose dock;
    private @Nullable Pose start;
    private @Nullable Marker marker;

    private RoomFile() {}

    /**
     * Reads the file.
     *
     * @throws IllegalArgumentException if it cannot be read or understood; the message names the file, the line and
     *     what would be right
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

    /** The name of the room that comes with the simulator. */
    public static final String LIVING_ROOM_NAME = "living-room";

    /**
     * The room that an option names: {@value #LIVING_ROOM_NAME}, or a file.
     *
     * @throws IllegalArgumentException as {@link #read}
     */
    public static Room named(String name) {
        return name.equals(LIVING_ROOM_NAME) ? livingRoom() : read(Path.of(name));
    }

    /** The living room that comes with the simulator: much furniture, a dock, and a marker behind the robot's back. */
    public static Room livingRoom() {
        try (InputStream file = RoomFile.class.getResourceAsStream(LIVING_ROOM)) {
            byte[] text = Objects.requireNonNull(file, LIVING_ROOM).readAllBytes();
            return parse(
                    LIVING_ROOM,
                    new String(text, StandardCharsets.UTF_8).lines().toList());
        } catch (IOException brokenJar) {
            throw new UncheckedIOException(brokenJar);
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
        return Room.of(shapes, dock, begin, marker);
    }

    private void parse(String line) {
        List<String> words = Arrays.stream(line.replaceFirst("#.*", "").trim().split("\\s+"))
                .filter(word -> !word.isEmpty())
                .toList();
        if (words.isEmpty()) {
            return;
        }
        String kind = words.get(0);
        List<String> values = words.subList(1, words.size());
        switch (kind) {
            case "wall", "obstacle", "cliff" -> shapes.add(shape(kind, values));
            case "dock" -> dock = pose("dock", dock, values);
            case "start" -> start = pose("start", start, values);
            case "marker" -> marker = marker(marker, values);
            default ->
                throw new IllegalArgumentException(
                        "'" + kind + "' is unknown; a line begins with wall, obstacle, cliff, dock, start or marker");
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

    private static List<Double> numbers(List<String> words) {
        return words.stream().map(RoomFile::number).toList();
    }

    private static Shape shape(String kindName, List<String> values) {
        Shape.Kind kind = Shape.Kind.valueOf(kindName.toUpperCase(Locale.ROOT));
        int count = values.size();
        if (kind != Shape.Kind.CLIFF) {
            count = (int)
                    values.stream().takeWhile(word -> !LOOKS.contains(word)).count();
        }
        List<Double> numbers = numbers(values.subList(0, count));
        if (count < 4 || count % 2 != 0) {
            throw new IllegalArgumentException(kindName + " has " + count
                    + " numbers; it needs two corners (a rectangle) or more (a polygon), each as X Y");
        }
        List<Point> corners = new ArrayList<>();
        for (int i = 0; i < count; i += 2) {
            corners.add(new Point(numbers.get(i), numbers.get(i + 1)));
        }
        if (corners.size() == 2) {
            corners = Shape.rectangle(corners.get(0), corners.get(1));
        }
        return new Shape(kind, corners, finish(values.subList(count, values.size())));
    }

    private static Finish finish(List<String> words) {
        OptionalInt rgb = OptionalInt.empty();
        OptionalDouble heightMm = OptionalDouble.empty();
        for (int i = 0; i < words.size(); i += 2) {
            String look = words.get(i);
            String value = i + 1 < words.size() ? words.get(i + 1) : "";
            if (!LOOKS.contains(look)) {
                throw new IllegalArgumentException(
                        "'" + look + "' is unknown here; after the corners come 'color RRGGBB' and 'height MM'");
            } else if (look.equals("height")) {
                heightMm = OptionalDouble.of(number(value));
            } else if (value.matches("[0-9a-fA-F]{6}")) {
                rgb = OptionalInt.of(Integer.parseInt(value, 16));
            } else {
                throw new IllegalArgumentException(
                        "color is '" + value + "'; it takes six hexadecimal digits, for example 1971c2");
            }
        }
        return new Finish(rgb, heightMm);
    }

    private static Pose pose(String name, @Nullable Object earlier, List<String> values) {
        requireFirst(name, earlier);
        if (values.size() != 3) {
            throw new IllegalArgumentException(
                    name + " has " + values.size() + " numbers; it needs three: X Y HEADING");
        }
        return pose(numbers(values));
    }

    private static Marker marker(@Nullable Marker earlier, List<String> words) {
        requireFirst("marker", earlier);
        boolean solid = !words.isEmpty() && words.get(words.size() - 1).equals(SOLID);
        List<String> values = solid ? words.subList(0, words.size() - 1) : words;
        if (values.size() < 3 || values.size() > 6) {
            throw new IllegalArgumentException(
                    "marker has " + values.size()
                            + " numbers; it needs three: X Y HEADING, and takes up to three more: ID SIDE HEIGHT, then 'solid'");
        }
        List<Double> numbers = numbers(values);
        double id = values.size() > 3 ? numbers.get(3) : 0;
        if (id != Math.rint(id)) {
            throw new IllegalArgumentException("the marker's id is " + id + "; it is a whole number");
        }
        return new Marker(
                pose(numbers),
                (int) id,
                values.size() > 4 ? numbers.get(4) : Marker.USUAL_SIDE_MM,
                values.size() > 5 ? numbers.get(5) : Marker.USUAL_HEIGHT_MM,
                false,
                solid);
    }

    private static void requireFirst(String name, @Nullable Object earlier) {
        if (earlier != null) {
            throw new IllegalArgumentException("there is a " + name + " already; remove one of the two");
        }
    }

    private static Pose pose(List<Double> numbers) {
        return new Pose(numbers.get(0), numbers.get(1), Math.toRadians(numbers.get(2)));
    }
}
