package org.evoloop.page.drawing;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.evoloop.page.drawing.Graph.Box;

/**
 * Orders the boxes of a graph with few crossings, then places them: each near its neighbours, none overlapping.
 */
final class Rows {
    private static final double GAP = 16;
    private static final double ROW_GAP = 18;

    /** Room for the initial arrow. */
    private static final double ABOVE = 28;

    private static final int SWEEPS = 12;

    private final List<List<Box>> rows;

    private Rows(List<List<Box>> rows) {
        this.rows = rows;
    }

    static void arrange(Graph graph) {
        Rows rows = new Rows(graph.rows);
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

    /** Side by side, around 0. */
    private void spread() {
        for (List<Box> row : rows) {
            double width = row.stream().mapToDouble(box -> box.width + GAP).sum();
            double left = -width / 2;
            for (Box box : row) {
                box.x = left + box.width / 2;
                left += box.width + GAP;
            }
        }
    }

    private void order(boolean down) {
        for (int index = 0; index < rows.size(); index++) {
            List<Box> row = rows.get(down ? index : rows.size() - 1 - index);
            row.sort(Comparator.comparingDouble(Rows::middleOfNeighbours));
        }
    }

    private static double middleOfNeighbours(Box box) {
        return box.neighbours.stream().mapToDouble(other -> other.x).average().orElse(box.x);
    }

    /** Moves each box towards the middle of its neighbours, as far as the boxes beside it allow. */
    private void pull() {
        for (List<Box> row : rows) {
            double[] wanted = row.stream().mapToDouble(Rows::middleOfNeighbours).toArray();
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
        rows.forEach(row -> row.forEach(box -> box.x += GAP - left));
    }

    private void stack() {
        double top = ABOVE;
        for (List<Box> row : rows) {
            double height = row.stream().mapToDouble(box -> box.height).max().orElse(0);
            for (Box box : row) {
                box.y = top + height / 2;
            }
            top += height + ROW_GAP;
        }
    }
}
