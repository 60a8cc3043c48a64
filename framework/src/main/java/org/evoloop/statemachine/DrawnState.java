package org.evoloop.statemachine;

import java.util.List;

/**
 * How a state of a flat machine was drawn.
 *
 * @param paths see {@link StateMachine#paths}
 * @param end see {@link StateMachine#isEnd}
 */
record DrawnState(List<String> paths, boolean end) {
    DrawnState {
        paths = List.copyOf(paths);
    }
}
