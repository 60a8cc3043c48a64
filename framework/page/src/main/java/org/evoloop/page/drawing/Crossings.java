package org.evoloop.page.drawing;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.page.drawing.Graph.Box;

/** Counts the crossings of arrows for an order of boxes, and improves the order. */
final class Crossings {
    /** Trying every pair of neighbours would take long in larger graphs. */
    private static final int MOST_BOXES = 150;

    private static final int MOST_PASSES = 10;

    private Crossings() {}

    /** Swaps neighbours in a row as long as that reduces crossings. */
    static void lessen(List<List<Box>> rows) {
        if (rows.stream().mapToInt(List::size).sum() > MOST_BOXES) {
            return;
        }
        boolean better = true;
        for (int pass = 0; better && pass < MOST_PASSES; pass++) {
            better = false;
            for (int index = 0; index < rows.size(); index++) {
                List<Box> row = rows.get(index);
                // Other crossings do not change.
                List<List<Box>> around = rows.subList(Math.max(0, index - 1), Math.min(rows.size(), index + 2));
                for (int i = 1; i < row.size(); i++) {
                    if (row.get(i).band != row.get(i - 1).band) {
                        continue;
                    }
                    int before = count(around);
                    Collections.swap(row, i - 1, i);
                    if (count(around) < before) {
                        better = true;
                    } else {
                        Collections.swap(row, i - 1, i);
                    }
                }
            }
        }
    }

    static int count(List<List<Box>> rows) {
        int crossings = 0;
        for (int index = 1; index < rows.size(); index++) {
            crossings += between(rows.get(index - 1), rows.get(index));
        }
        return crossings;
    }

    private static int between(List<Box> upper, List<Box> lower) {
        Map<Box, Integer> places = new HashMap<>();
        for (int place = 0; place < lower.size(); place++) {
            places.put(lower.get(place), place);
        }
        List<Integer> passed = new ArrayList<>();
        int crossings = 0;
        for (Box box : upper) {
            List<Integer> own = new ArrayList<>();
            for (Box other : box.neighbours) {
                Integer place = places.get(other);
                if (place != null) {
                    own.add(place);
                }
            }
            for (int place : own) {
                for (int left : passed) {
                    crossings += left > place ? 1 : 0;
                }
            }
            passed.addAll(own);
        }
        return crossings;
    }
}
