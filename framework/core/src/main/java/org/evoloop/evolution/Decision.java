package org.evoloop.evolution;

import java.util.List;
import java.util.Objects;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * What an event means: the outcome of the paper's Algorithm 1 for one configuration and one occurrence.
 *
 * <p>{@link #steps()} move the original model, in order; a step that the device took itself can only be the first.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Decision {
    /** Where the system stood when the event occurred. */
    Configuration before();

    /** Where it stands once every step has had its effect. */
    Configuration after();

    /** The transitions of the original model on the way. */
    List<Step> steps();

    /** What the new model takes, or would if it were possible; null if it takes nothing. */
    default @Nullable Transition transition() {
        return null;
    }

    /** Effects of the new model's transition that the converter has to see to: those that the device does not do itself. */
    default List<String> effects() {
        return List.of();
    }

    /** Where the system stands when planning begins: {@link #before}, moved on by the step that the device took itself. */
    default Configuration start() {
        return before().withOriginal(deviceStart());
    }

    /** Where the device is when planning begins: where the step that it took itself has led. */
    default State deviceStart() {
        return steps().isEmpty() || !steps().get(0).byDevice()
                ? before().original()
                : steps().get(0).target();
    }

    /** Whether planning begins in {@code at}. */
    default boolean startsIn(Configuration at) {
        return at.evolved().equals(before().evolved()) && at.original().equals(deviceStart());
    }

    /** Whether the new model leaves its state, be it towards itself; an internal transition does not. */
    default boolean leavesState() {
        Transition taken = transition();
        return taken != null && !taken.internal();
    }

    /** States of the device through which the plan leads, without those in which it begins and ends. */
    default List<State> passed() {
        return steps().stream()
                .filter(step -> !step.byDevice())
                .skip(1)
                .map(Step::source)
                .toList();
    }

    /**
     * The new model has no transition for the event, so it stays where it is. If the device has acted all the same, the
     * one step says how.
     */
    record NotAcceptable(Configuration before, Configuration after, List<Step> steps) implements Decision {}

    /** The new model's next state is one that the device has; the steps take the device there. */
    record ExistingState(
            Configuration before, Configuration after, List<Step> steps, Transition transition, List<String> effects)
            implements Decision {

        /** Whether the device needs more than one step: a way through its functions that it does not offer as one. */
        public boolean isDetour() {
            return steps.size() > 1;
        }
    }

    /** The next state is new: its function starts here, and nothing is sent. */
    record NewState(
            Configuration before, Configuration after, List<Step> steps, Transition transition, List<String> effects)
            implements Decision {}

    /** The device was found elsewhere than its model was; both models follow, and nothing is sent. */
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
     * A new function has the device do an event that it knows; the new model stays in its state.
     */
    record Sending(Configuration before, Configuration after, List<Step> steps) implements Decision {}

    /** The record is in doubt: the device is asked where it is, and what it answers is taken as found. */
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
     * The next state is one that the device has, but nothing that can be sent takes the device there.
     *
     * @param reason for people, with both states and the events that can be sent
     */
    record Impossible(
            Configuration before,
            Configuration after,
            List<Step> steps,
            @Nullable Transition transition,
            String reason) implements Decision {

        /** The event comes to nothing. */
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
