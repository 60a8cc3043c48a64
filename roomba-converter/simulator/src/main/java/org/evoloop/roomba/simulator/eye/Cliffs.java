package org.evoloop.roomba.simulator.eye;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;

/** Paints areas without a floor as dark. */
final class Cliffs {
    private static final long DARK = Rgb.of(0x1A1815);

    /** So near that it is below the bottom of every picture. */
    private static final double NEAREST_MM = 1;

    private final List<Shape> shapes;

    /** For each cliff, its corners relative to the robot: ahead and to the left. */
    private final List<List<Point>> outlines = new ArrayList<>();

    Cliffs(List<Shape> shapes) {
        this.shapes = shapes;
    }

    static Cliffs of(Room room) {
        return new Cliffs(room.shapes().stream()
                .filter(shape -> shape.kind() == Shape.Kind.CLIFF)
                .toList());
    }

    void lookFrom(Pose pose) {
        outlines.clear();
        for (Shape shape : shapes) {
            outlines.add(shape.corners().stream().map(pose::seen).toList());
        }
    }

    /** @param aside the column's direction: mm to the left for each mm ahead */
    void paint(Column column, double aside, int endRow) {
        for (List<Point> outline : outlines) {
            double[] crossings = crossings(outline, aside);
            // Counted from far to near, the line of sight is over the cliff from each odd crossing to the next one.
            for (int i = crossings.length - 1; i >= 0; i -= 2) {
                double nearMm = i > 0 ? crossings[i - 1] : NEAREST_MM;
                column.cover(DARK, Rgb.ONE, column.row(0, 1 / crossings[i]), column.row(0, 1 / nearMm), endRow);
            }
        }
    }

    /** The distances ahead at which the line of sight crosses the outline, nearest first. */
    private static double[] crossings(List<Point> outline, double aside) {
        double[] crossings = new double[outline.size()];
        int count = 0;
        for (int i = 0; i < outline.size(); i++) {
            Point from = outline.get(i);
            Point to = outline.get((i + 1) % outline.size());
            double fromOff = from.yMm() - aside * from.xMm();
            double toOff = to.yMm() - aside * to.xMm();
            if (fromOff > 0 != toOff > 0) {
                double aheadMm = from.xMm() + fromOff / (fromOff - toOff) * (to.xMm() - from.xMm());
                if (aheadMm > NEAREST_MM) {
                    crossings[count++] = aheadMm;
                }
            }
        }
        double[] sorted = Arrays.copyOf(crossings, count);
        Arrays.sort(sorted);
        return sorted;
    }
}
