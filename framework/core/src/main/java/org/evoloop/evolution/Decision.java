package org.evoloop.evolution;

import java.util.List;
import java.util.Objects;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * What an event means: the outcome of the paper's Algorithm 1 for one configuration and one occurrence.
 *
 * <p>The {@link #steps()} move the original model, in order; only the first can be one that the device took itself.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Decision {
    /** The states when the event occurred. */
    Configuration before();

    /** The states once every step has had its effect. */
    Configuration after();

    /** The steps through the original model. */
    List<Step> steps();

    /** The new model's transition, or the one that it would take if that were possible; null if it takes none. */
    default @Nullable Transition transition() {
        return null;
    }

    /**
     * Effects of the new model's transition that the converter has to run: those that the device does not run itself.
     */
    default List<String> effects() {
        return List.of();
    }

    /** The states when planning begins: {@link #before}, moved by the step that the device took itself. */
    default Configuration start() {
        return before().withOriginal(deviceStart());
    }

    /** The device's state when planning begins, after the step that it took itself. */
    default State deviceStart() {
        return deviceBegan() ? steps().get(0).target() : before().original();
    }

    /** Whether the device took the first step by itself. */
    default boolean deviceBegan() {
        return !steps().isEmpty() && steps().get(0).byDevice();
    }

    /** Whether planning begins in {@code at}. */
    default boolean startsIn(Configuration at) {
        return at.evolved().equals(before().evolved()) && at.original().equals(deviceStart());
    }

    /**
     * Whether the new model leaves its state, even if it enters the same state again; an internal transition does not
     * leave it.
     */
    default boolean leavesState() {
        Transition taken = transition();
        return taken != null && !taken.internal();
    }

    /** The device's states through which the plan leads, without its first and last. */
    default List<State> passed() {
        return steps().stream()
                .filter(step -> !step.byDevice())
                .skip(1)
                .map(Step::source)
                .toList();
    }

    /**
     * The new model has no transition for the event, so it stays where it is. If the device has acted all the same,
     * there is one step for that.
     */
    record NotAcceptable(Configuration before, Configuration after, List<Step> steps) implements Decision {}

    /** The device has the new model's next state; the steps take it there. */
    record ExistingState(
            Configuration before, Configuration after, List<Step> steps, Transition transition, List<String> effects)
            implements Decision {

        /**
         * Whether the device needs more than one step: a path through its functions that it does not offer as a single
         * one.
         */
        public boolean isDetour() {
            return steps.size() > 1;
        }
    }

    /**
     * The next state is new: its function starts here. Nothing is sent, unless the state needs the device elsewhere: then
     * the steps take it there first.
     */
    record NewState(
            Configuration before, Configuration after, List<Step> steps, Transition transition, List<String> effects)
            implements Decision {}

    /**
     * The device was found in another state than its model was, or has left the state in which the new model needs it,
     * and the new model has no transition for that; both models follow, and nothing is sent.
     */
    record Resynchronization(Configuration before, Configuration after, List<Step> steps) implements Decision {
        Resynchronization(Configuration before, Configuration after) {
            this(before, after, List.of());
        }

        /** The device is there already. */
        @Override
        public State deviceStart() {
            return after.original();
        }

        @Override
        public boolean leavesState() {
            return !before.evolved().equals(after.evolved());
        }
    }

    /**
     * A new function has an event of the device sent; the new model stays in its state.
     */
    record Sending(Configuration before, Configuration after, List<Step> steps) implements Decision {}

    /** The record is in doubt: the device is asked for its state, and its answer is treated as a finding. */
    record Inquiry(Configuration before) implements Decision {
        @Override
        public Configuration after() {
            return before;
        }

        @Override
        public List<Step> steps() {
            return List.of();
        }
    }

    /**
     * A rule of an analyze component refuses the event, whatever the models say.
     *
     * @param reason for people
     */
    record Refused(Configuration before, String reason) implements Decision {
        @Override
        public Configuration after() {
            return before;
        }

        @Override
        public List<Step> steps() {
            return List.of();
        }
    }

    /**
     * The device has the next state, but no events that can be sent take it there.
     *
     * @param reason for people, with both states and the events that can be sent
     */
    record Impossible(
            Configuration before,
            Configuration after,
            List<Step> steps,
            @Nullable Transition transition,
            String reason) implements Decision {

        /** The event has no effect. */
        @Override
        public boolean leavesState() {
            return false;
        }

        // By hand: a record's own go through method handles, which cost some 10 us a call wherever the last of the
        // JVM's
        // compilers has not been, and that one is left out on small computers.

        @Override
        public boolean equals(@Nullable Object other) {
            return other instanceof Impossible that
                    && before.equals(that.before)
                    && after.equals(that.after)
                    && steps.equals(that.steps)
                    && Objects.equals(transition, that.transition)
                    && reason.equals(that.reason);
        }

        @Override
        public int hashCode() {
            return 31 * before.hashCode() + reason.hashCode();
        }
    }
}
