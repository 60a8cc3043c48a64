package org.evoloop.migration;

import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;

/**
 * What becomes of a pair of states of the running models in a swap.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Fate {
    /**
     * The swap is possible.
     *
     * @param at where device and evolved system are as soon as the next models take over
     * @param to where they stand when all steps have been sent
     * @param steps what is sent to get there; mostly nothing
     * @param carried what becomes of the timers and the functions of both states
     */
    record Maps(Configuration at, Configuration to, List<Step> steps, List<Carried> carried) implements Fate {
        public Maps {
            steps = List.copyOf(steps);
            carried = List.copyOf(carried);
        }
    }

    /**
     * The swap has to wait until other states are current.
     *
     * @param because why it is not possible here
     * @param exits events that lead towards states in which it is
     * @param uncertain those of them that may never come: all but timers without a guard
     */
    record Waits(String because, List<Event> exits, List<Event> uncertain) implements Fate {
        public Waits {
            exits = List.copyOf(exits);
            uncertain = List.copyOf(uncertain);
        }
    }

    /**
     * No swap is possible here, and nothing leads to where one is.
     *
     * @param because for people, with what can be done about it
     */
    record Stuck(String because) implements Fate {}
}
