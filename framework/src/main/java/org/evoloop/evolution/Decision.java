package org.evoloop.evolution;

import java.util.List;

/**
 * What an event means: the outcome of the paper's Algorithm 1 for one configuration and one occurrence.
 *
 * <p>{@link #steps()} move the original model, in order; a step that the device took itself can only be the first.
 *
 * <p>Threading: immutable.
 */
public sealed interface Decision {
    /** Where the system stood when the event occurred. */
    Configuration before();

    /** Where it stands once every step has had its effect. */
    Configuration after();

    /** The transitions of the original model on the way. */
    List<Step> steps();

    /**
     * The new model has no transition for the event, so it stays where it is. If the device has acted all the same, the
     * one step says how.
     */
    record NotAcceptable(Configuration before, Configuration after, List<Step> steps) implements Decision {}

    /** The new model's next state is one that the device has; the steps take the device there. */
    record ExistingFunction(Configuration before, Configuration after, List<Step> steps) implements Decision {

        /** Whether the device needs more than one step: a way through its functions that it does not offer as one. */
        public boolean isDetour() {
            return steps.size() > 1;
        }
    }

    /** The next state is new: its function starts here, and nothing is sent. */
    record NewFunction(Configuration before, Configuration after, List<Step> steps) implements Decision {}

    /** The device was found elsewhere than its model was; both models follow, and nothing is sent. */
    record Resynchronization(Configuration before, Configuration after, List<Step> steps) implements Decision {
        Resynchronization(Configuration before, Configuration after) {
            this(before, after, List.of());
        }
    }

    /**
     * The next state is one that the device has, but nothing that can be sent takes the device there.
     *
     * @param reason for people, with both states and the events that can be sent
     */
    record Impossible(Configuration before, Configuration after, List<Step> steps, String reason) implements Decision {}
}
