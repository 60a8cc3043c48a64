package org.evoloop.function;

import java.time.Duration;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * A new function whose state is composite: it passes through sub-states, each a concrete state of the state pattern
 * (paper, section V.B).
 *
 * <p>Threading: as {@link NewFunction}; all sub-states of a visit run on its one thread or, without threads, where its
 * tasks run.
 *
 * @since 0.1
 */
public final class StatePatternFunction implements NewFunction {

    /** A sub-state. */
    @FunctionalInterface
    public interface SubState {
        /**
         * Performs the sub-state.
         *
         * @return the next one, or null if the function is done
         * @throws Exception as {@link NewFunction#run}
         */
        @Nullable
        SubState perform(Visit visit) throws Exception;
    }

    /**
     * A sub-state that begins after {@code delay}, also in a converter without threads, where no sub-state may wait:
     *
     * <pre>{@code
     * return after(Duration.ofSeconds(30), next -> drained(next));
     * }</pre>
     *
     * @throws IllegalArgumentException if {@code delay} is negative, or longer than {@link Clock#LONGEST}
     */
    public static SubState after(Duration delay, SubState next) {
        return new Later(Clock.requireDelay(delay), next);
    }

    private record Later(Duration delay, SubState next) implements SubState {
        @Override
        public SubState perform(Visit visit) throws InterruptedException {
            visit.sleep(delay);
            return next;
        }
    }

    private final SubState initial;

    /** @param initial where each visit starts */
    public StatePatternFunction(SubState initial) {
        this.initial = initial;
    }

    @Override
    public void run(Visit visit) throws Exception {
        run(visit, initial);
    }

    private static void run(Visit visit, SubState first) throws Exception {
        SubState current = first;
        while (current != null && visit.isActive()) {
            if (current instanceof Later later && !visit.threads()) {
                visit.after(later.delay(), () -> goOn(visit, later.next()));
                return;
            }
            current = current.perform(visit);
        }
    }

    private static void goOn(Visit visit, SubState next) {
        try {
            run(visit, next);
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        } catch (RuntimeException failure) {
            throw failure;
        } catch (Exception failure) {
            throw new IllegalStateException(failure.getMessage(), failure);
        }
    }
}
