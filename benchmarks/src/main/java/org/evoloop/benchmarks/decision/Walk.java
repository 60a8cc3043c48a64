package org.evoloop.benchmarks.decision;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A machine and a closed path through it, which is repeated.
 *
 * <p>Threading: immutable.
 *
 * @param initial the state in which the path starts and ends
 * @param way the events, each of which is acceptable when it occurs
 */
record Walk(List<String> states, List<String> events, List<Move> moves, String initial, List<String> way) {

    /** A transition. */
    record Move(String source, String event, String target) {}

    /** The six states of the paper's new cleaning robot, and ten events that take seven of its eight transitions. */
    static Walk robot() {
        return new Walk(
                List.of("Off", "On", "Spot", "Clean", "Move", "SpotWait"),
                List.of("Clean", "Spot", "endSpot", "arriveSpot", "timeout"),
                List.of(
                        new Move("Off", "Clean", "On"),
                        new Move("On", "Spot", "Move"),
                        new Move("On", "Clean", "Clean"),
                        new Move("Move", "arriveSpot", "Spot"),
                        new Move("Spot", "endSpot", "On"),
                        new Move("Clean", "Clean", "SpotWait"),
                        new Move("SpotWait", "timeout", "On"),
                        new Move("SpotWait", "Clean", "Spot")),
                "On",
                List.of(
                        "Clean",
                        "Clean",
                        "Clean",
                        "endSpot",
                        "Spot",
                        "arriveSpot",
                        "endSpot",
                        "Clean",
                        "Clean",
                        "timeout"));
    }

    /** A ring of {@code length} states, each with a transition forward and one back; the path goes round once. */
    static Walk chain(int length) {
        List<String> states =
                IntStream.range(0, length).mapToObj(index -> "s" + index).toList();
        List<Move> moves = new ArrayList<>();
        for (int index = 0; index < length; index++) {
            moves.add(new Move(states.get(index), "next", states.get((index + 1) % length)));
            moves.add(new Move(states.get(index), "back", states.get((index + length - 1) % length)));
        }
        return new Walk(states, List.of("next", "back"), List.copyOf(moves), states.get(0), List.of("next"));
    }

    /** The paper's machine for 6, else a ring of {@code size} states. */
    static Walk of(int size) {
        return size == 6 ? robot() : chain(size);
    }
}
