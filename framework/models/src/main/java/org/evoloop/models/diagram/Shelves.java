package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.evoloop.models.diagram.Layout.Point;

/**
 * The places of the frames of several machines: in order, row by row, so that the whole has roughly the shape of a
 * page.
 *
 * @param places the top left corner of each frame
 */
record Shelves(double width, double height, List<Point> places) {
    static final double GAP = 16;

    /** The height above each machine, for its name. */
    static final double HEADING = 32;

    Shelves {
        places = List.copyOf(places);
    }

    static double frameWidth(Layout layout) {
        return layout.width();
    }

    static double frameHeight(Layout layout) {
        return layout.height() + HEADING;
    }

    /** Tries rows as wide as the first one, two, three and so on of the frames, and takes the best. */
    static Shelves of(List<Layout> layouts) {
        return IntStream.rangeClosed(1, layouts.size())
                .mapToObj(first -> within(layouts, rowWidth(layouts.subList(0, first))))
                .min(Comparator.comparingDouble(shelves -> ElkLayout.badness(shelves.width(), shelves.height())))
                .orElse(new Shelves(2 * GAP, 2 * GAP, List.of()));
    }

    private static double rowWidth(List<Layout> row) {
        return row.stream().mapToDouble(layout -> frameWidth(layout) + GAP).sum();
    }

    private static Shelves within(List<Layout> layouts, double rowWidth) {
        List<Point> places = new ArrayList<>();
        double width = 0;
        double x = GAP;
        double y = GAP;
        double rowHeight = 0;
        for (Layout layout : layouts) {
            if (x > GAP && x + frameWidth(layout) > rowWidth + GAP) {
                x = GAP;
                y += rowHeight + GAP;
                rowHeight = 0;
            }
            places.add(new Point(x, y));
            x += frameWidth(layout) + GAP;
            width = Math.max(width, x);
            rowHeight = Math.max(rowHeight, frameHeight(layout));
        }
        return new Shelves(width, y + rowHeight + GAP, places);
    }
}
