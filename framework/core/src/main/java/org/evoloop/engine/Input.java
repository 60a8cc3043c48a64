package org.evoloop.engine;

import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * An input of the {@link Core}. Times are nanoseconds of the converter's monotonic clock; {@code number} is that of the
 * occurrence, from {@link Output.Begin}: an input for any occurrence but the one in progress is ignored, since that one
 * was given up.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Input {
    /** Calls the method of {@code core} for this input. */
    void applyTo(Inputs core);

    /** The converter is opened: it takes controllers' events, and the current state is entered anew. */
    record Opened(long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.opened(atNanos);
        }
    }

    /**
     * The converter is closed to everything but facts. The occurrence in progress may still end normally, unless it was
     * interrupted by the end of a process and has not been resumed.
     */
    record Closing() implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.closing();
        }
    }

    /** Nothing is in progress any more: the function and timers of the current state end. */
    record Closed() implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.closed();
        }
    }

    /**
     * The previous process ended without closing the converter: a step that was being sent is in doubt, an effect that
     * was being run is not run again, and everything else continues when the converter is opened.
     */
    record Recovered(long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.recovered(atNanos);
        }
    }

    /** Something occurred. A fact moves the original model at once; anything else waits for its turn. */
    record Observed(Occurrence occurrence) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.observed(occurrence);
        }
    }

    /** A timer of a visit has expired. */
    record TimerDue(long visit, Event event, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.timerDue(visit, event, atNanos);
        }
    }

    /** Nothing is in progress, and the next occurrence may begin. */
    record Ready() implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.ready();
        }
    }

    /** The occurrence in progress was analyzed and planned. */
    record Planned(long number, Decision decision, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.planned(number, decision, atNanos);
        }
    }

    /** The analyze or plan component has dismissed the occurrence. */
    record Dismissed(long number, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.dismissed(number, atNanos);
        }
    }

    /** The device is ready for the requested step, which is about to be sent. */
    record Sending(long number) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.sending(number);
        }
    }

    /**
     * The step that was being sent has had its effect.
     *
     * @param inOrder whether the adapter guarantees that everything the device did by itself before this effect was
     *     reported before it, and everything later after it
     */
    record Sent(long number, boolean inOrder, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.sent(number, inOrder, atNanos);
        }
    }

    /** The requested effect is about to be run. */
    record Running(long number) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.running(number);
        }
    }

    /** An effect of the new model was run; {@code failure} is the reason if it failed, else empty. */
    record EffectRun(long number, String failure, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.effectRun(number, failure, atNanos);
        }
    }

    /** The device was asked for its state; {@code state} is null if it is unknown. */
    record Located(long number, @Nullable State state, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.located(number, state, atNanos);
        }
    }

    /** A component failed on the occurrence; a step being sent had no effect. */
    record Failed(long number, String reason, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.failed(number, reason, atNanos);
        }
    }

    /**
     * A component was abandoned or failed while handling the occurrence; it is unknown whether a step being sent had
     * its effect.
     */
    record GivenUp(long number, String reason, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.givenUp(number, reason, atNanos);
        }
    }

    /** Models or components have changed: from now on these rules apply. */
    record Changed(Rules rules, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.changed(rules, atNanos);
        }
    }

    /**
     * Other models take over. That happens between two events, and only where it is possible, see {@link
     * Core#hindrance}; otherwise the input is ignored.
     */
    record Evolved(Swap swap, long atNanos) implements Input {
        @Override
        public void applyTo(Inputs core) {
            core.evolved(swap, atNanos);
        }
    }
}
