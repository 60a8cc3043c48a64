package org.evoloop.migration;

import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;

/**
 * The fate of a pair of states of the running models in a swap.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Fate {
    /**
     * The swap is possible.
     *
     * @param at the states of device and evolved system as soon as the next models take over
     * @param to their states in the end: when all steps have been sent, or the new model has followed the device
     * @param steps the steps sent to get there; usually none
     * @param carried how the timers and the functions of both states are carried over
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
     * @param exits events that lead towards states in which it is possible
     * @param uncertain the exits that may never come: all but timers without a guard
     */
    record Waits(String because, List<Event> exits, List<Event> uncertain) implements Fate {
        public Waits {
            exits = List.copyOf(exits);
            uncertain = List.copyOf(uncertain);
        }
    }

    /**
     * No swap is possible here, and no event leads to a state in which one is.
     *
     * @param because the reason and the remedy, for people
     */
    record Stuck(String because) implements Fate {}
}
