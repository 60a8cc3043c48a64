package org.evoloop.page.drawing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.evoloop.statemachine.State;

/**
 * A machine as rows of boxes: states are in even rows, by their distance from the initial one, and the arrows' labels
 * in odd ones, as boxes of their own, so that no text overlaps anything. A long arrow has a thin box in each row that
 * it crosses.
 */
final class Graph {
    /** Of a letter of a state's name, which is bold, and of an event's: means of the style sheet's font at 13 px. */
    private static final double BOLD = 9;

    private static final double PLAIN = 7.8;

    static final double STATE_HEIGHT = 40;
    static final double LINE = 17;

    /** Between a frame and what is in it, and above that for the frame's name. */
    static final double PADDING = 12;

    static final double TITLE = 24;

    /** An item that takes room in a row. */
    static final class Box {
        final int row;

        /** Boxes of one band are in the same columns, so that the frame of a composite state holds no other. */
        final int band;

        final double width;
        final double height;
        final List<Box> neighbours = new ArrayList<>();
        double x;
        double y;

        Box(int row, int band, double width, double height) {
            this.row = row;
            this.band = band;
            this.width = width;
            this.height = height;
        }
    }

    /**
     * All transitions from one state to another.
     *
     * @param way the boxes from its source to its target, both included
     * @param label the box with its texts
     */
    record Arrow(State source, State target, List<Sketch.Line> lines, List<Box> way, Box label) {}

    /**
     * A composite state, drawn as a frame.
     *
     * @param path the names of the composite states around it, and its own
     * @param states the boxes in it, also in the frames in it
     */
    record Frame(List<String> path, List<Box> states) {
        /** Whether it is one of the composite states {@code around} some state. */
        boolean isAmong(List<String> around) {
            return shared(around, path) == path.size();
        }

        int firstRow() {
            return states.stream().mapToInt(box -> box.row).min().orElse(0);
        }

        int lastRow() {
            return states.stream().mapToInt(box -> box.row).max().orElse(0);
        }
    }

    final Map<State, Box> states = new LinkedHashMap<>();
    final List<Arrow> arrows = new ArrayList<>();
    final List<List<Box>> rows = new ArrayList<>();

    /** The composite states around the states of each band, the outermost first; those of one frame are side by side. */
    final List<List<String>> bands = new ArrayList<>();

    /** An outer one before those in it. */
    final List<Frame> frames = new ArrayList<>();

    Graph(Sketch sketch) {
        new LinkedHashSet<>(sketch.around().values()).forEach(this::addBand);
        Map<State, Integer> distances = distances(sketch);
        sketch.around()
                .forEach((state, around) -> states.put(
                        state,
                        box(
                                2 * distances.getOrDefault(state, 0),
                                bands.indexOf(around),
                                state.name().length() * BOLD + 20,
                                STATE_HEIGHT)));
        Map<List<State>, List<Sketch.Line>> between = new LinkedHashMap<>();
        for (Sketch.Line line : sketch.arrows()) {
            between.computeIfAbsent(List.of(line.source(), line.target()), ends -> new ArrayList<>())
                    .add(line);
        }
        between.forEach((ends, lines) -> arrows.add(arrow(ends.get(0), ends.get(1), lines)));
        for (List<String> band : bands) {
            for (int depth = 1; depth <= band.size(); depth++) {
                Frame frame = new Frame(band.subList(0, depth), new ArrayList<>());
                if (frames.stream().noneMatch(other -> other.path().equals(frame.path()))) {
                    states.values().stream()
                            .filter(box -> frame.isAmong(bands.get(box.band)))
                            .forEach(frame.states()::add);
                    frames.add(frame);
                }
            }
        }
    }

    /** Behind those with which it shares most. */
    private void addBand(List<String> band) {
        int place = bands.size();
        int most = 0;
        for (int other = 0; other < bands.size(); other++) {
            int shared = shared(bands.get(other), band);
            if (shared > 0 && shared >= most) {
                most = shared;
                place = other + 1;
            }
        }
        bands.add(place, band);
    }

    private static int shared(List<String> one, List<String> other) {
        int shared = 0;
        while (shared < Math.min(one.size(), other.size()) && one.get(shared).equals(other.get(shared))) {
            shared++;
        }
        return shared;
    }

    /** How many frames are around the innermost states. */
    int depth() {
        return bands.stream().mapToInt(List::size).max().orElse(0);
    }

    /** How many frames lie between the edge of {@code frame} and a box in it, its own included. */
    int levels(Frame frame, Box box) {
        return bands.get(box.band).size() - frame.path().size() + 1;
    }

    private static Map<State, Integer> distances(Sketch sketch) {
        Map<State, Integer> distances = new LinkedHashMap<>(Map.of(sketch.initial(), 0));
        Deque<State> next = new ArrayDeque<>(List.of(sketch.initial()));
        while (!next.isEmpty()) {
            State source = next.remove();
            int distance = distances.getOrDefault(source, 0);
            for (Sketch.Line line : sketch.arrows()) {
                if (line.source().equals(source) && distances.putIfAbsent(line.target(), distance + 1) == null) {
                    next.add(line.target());
                }
            }
        }
        return distances;
    }

    /** The box of a state. */
    Box box(State state) {
        return Objects.requireNonNull(states.get(state));
    }

    private Box box(int row, int band, double width, double height) {
        while (rows.size() <= row) {
            rows.add(new ArrayList<>());
        }
        Box box = new Box(row, band, width, height);
        rows.get(row).add(box);
        return box;
    }

    private Arrow arrow(State source, State target, List<Sketch.Line> lines) {
        Box from = box(source);
        Box to = box(target);
        double width = lines.stream()
                .mapToDouble(each -> each.text().length() * PLAIN + 10)
                .max()
                .orElse(0);
        double height = lines.size() * LINE + 6;
        List<Box> way = new ArrayList<>(List.of(from));
        Box label;
        if (Math.abs(from.row - to.row) < 2) {
            label = box(from.row + 1, from.band, width, height);
            way.add(label);
        } else {
            int step = Integer.signum(to.row - from.row);
            // On the way down near the source, on the way up near the target: where there is most room.
            int labelRow = Math.min(from.row, to.row) + 1;
            label = box(labelRow, from.band, width, height);
            for (int row = from.row + step; row != to.row; row += step) {
                way.add(row == labelRow ? label : box(row, from.band, 10, 1));
            }
        }
        way.add(to);
        for (int index = 1; index < way.size(); index++) {
            way.get(index - 1).neighbours.add(way.get(index));
            way.get(index).neighbours.add(way.get(index - 1));
        }
        return new Arrow(source, target, lines, way, label);
    }
}
