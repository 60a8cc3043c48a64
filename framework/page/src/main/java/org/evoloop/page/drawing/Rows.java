package org.evoloop.page.drawing;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToIntFunction;
import org.evoloop.page.drawing.Graph.Box;
import org.evoloop.page.drawing.Graph.Frame;

/**
 * Orders the boxes of a graph with few crossings, then places them: each near its neighbours, none overlapping.
 */
final class Rows {
    private static final double GAP = 16;
    private static final double ROW_GAP = 18;

    /** Room for the initial arrow. */
    private static final double ABOVE = 44;

    private static final int SWEEPS = 12;

    private final Graph graph;
    private final List<List<Box>> rows;

    /** Between bands, for the edges of their frames. */
    private final double bandGap;

    /** The left edge of each band; the last is the right edge of all. */
    private final double[] edges;

    private Rows(Graph graph) {
        this.graph = graph;
        this.rows = graph.rows;
        this.bandGap = GAP + 2 * Graph.PADDING * Math.max(1, graph.depth());
        this.edges = new double[graph.bands.size() + 1];
        for (int band = 0; band < graph.bands.size(); band++) {
            int each = band;
            edges[band + 1] = edges[band]
                    + bandGap
                    + rows.stream()
                            .mapToDouble(row -> width(of(row, each)))
                            .max()
                            .orElse(0);
        }
    }

    private static List<Box> of(List<Box> row, int band) {
        return row.stream().filter(box -> box.band == band).toList();
    }

    private static double width(List<Box> boxes) {
        return boxes.stream().mapToDouble(box -> box.width + GAP).sum();
    }

    static void arrange(Graph graph) {
        Rows rows = new Rows(graph);
        graph.rows.forEach(row -> row.sort(Comparator.comparingInt(box -> box.band)));
        rows.spread();
        List<List<Box>> best = copy(graph.rows);
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            rows.order(sweep % 2 == 0);
            rows.spread();
            if (Crossings.count(graph.rows) < Crossings.count(best)) {
                best = copy(graph.rows);
            }
        }
        for (int row = 0; row < best.size(); row++) {
            Collections.copy(graph.rows.get(row), best.get(row));
        }
        Crossings.lessen(graph.rows);
        rows.spread();
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            rows.pull();
        }
        rows.shiftToOrigin();
        rows.stack();
    }

    private static List<List<Box>> copy(List<List<Box>> rows) {
        List<List<Box>> copies = new ArrayList<>();
        rows.forEach(row -> copies.add(List.copyOf(row)));
        return copies;
    }

    /** Side by side, in the middle of their band. */
    private void spread() {
        for (List<Box> row : rows) {
            for (int band = 0; band < edges.length - 1; band++) {
                List<Box> boxes = of(row, band);
                double left = (edges[band] + edges[band + 1] - width(boxes)) / 2;
                for (Box box : boxes) {
                    box.x = left + GAP / 2 + box.width / 2;
                    left += box.width + GAP;
                }
            }
        }
    }

    private void order(boolean down) {
        for (int index = 0; index < rows.size(); index++) {
            List<Box> row = rows.get(down ? index : rows.size() - 1 - index);
            row.sort(Comparator.<Box>comparingInt(box -> box.band).thenComparingDouble(Rows::middleOfNeighbours));
        }
    }

    private static double middleOfNeighbours(Box box) {
        return box.neighbours.stream().mapToDouble(other -> other.x).average().orElse(box.x);
    }

    /** Moves each box towards the middle of its neighbours, as far as the boxes beside it and its band allow. */
    private void pull() {
        for (List<Box> row : rows) {
            for (int band = 0; band < edges.length - 1; band++) {
                pull(of(row, band), edges[band] + bandGap / 2, edges[band + 1] - bandGap / 2);
            }
        }
    }

    private static void pull(List<Box> row, double least, double most) {
        double[] wanted = row.stream()
                .mapToDouble(
                        box -> Math.max(least + box.width / 2, Math.min(most - box.width / 2, middleOfNeighbours(box))))
                .toArray();
        double[] fromLeft = new double[wanted.length];
        double[] fromRight = new double[wanted.length];
        for (int i = 0; i < wanted.length; i++) {
            fromLeft[i] = i == 0 ? wanted[i] : Math.max(wanted[i], fromLeft[i - 1] + apart(row, i));
        }
        for (int i = wanted.length - 1; i >= 0; i--) {
            fromRight[i] =
                    i == wanted.length - 1 ? wanted[i] : Math.min(wanted[i], fromRight[i + 1] - apart(row, i + 1));
        }
        for (int i = 0; i < wanted.length; i++) {
            row.get(i).x = (fromLeft[i] + fromRight[i]) / 2;
        }
        for (int i = wanted.length - 1; i >= 0; i--) {
            Box box = row.get(i);
            box.x = Math.min(
                    box.x, i == wanted.length - 1 ? most - box.width / 2 : row.get(i + 1).x - apart(row, i + 1));
        }
        for (int i = 0; i < wanted.length; i++) {
            Box box = row.get(i);
            box.x = Math.max(box.x, i == 0 ? least + box.width / 2 : row.get(i - 1).x + apart(row, i));
        }
    }

    private static double apart(List<Box> row, int index) {
        return (row.get(index - 1).width + row.get(index).width) / 2 + GAP;
    }

    private void shiftToOrigin() {
        double left = rows.stream()
                .flatMap(List::stream)
                .mapToDouble(box -> box.x - box.width / 2)
                .min()
                .orElse(0);
        rows.forEach(row -> row.forEach(box -> box.x += GAP + Graph.PADDING * graph.depth() - left));
    }

    private void stack() {
        double top = ABOVE;
        for (int index = 0; index < rows.size(); index++) {
            List<Box> row = rows.get(index);
            top += (Graph.PADDING + Graph.TITLE) * most(index, Frame::firstRow);
            double height = row.stream().mapToDouble(box -> box.height).max().orElse(0);
            for (Box box : row) {
                box.y = top + height / 2;
            }
            top += height + ROW_GAP + Graph.PADDING * most(index, Frame::lastRow);
        }
    }

    /** How many frames, one in another, have their first or last row there. */
    private int most(int row, ToIntFunction<Frame> end) {
        return graph.bands.stream()
                .mapToInt(band -> (int) graph.frames.stream()
                        .filter(frame -> frame.isAmong(band) && end.applyAsInt(frame) == row)
                        .count())
                .max()
                .orElse(0);
    }
}
