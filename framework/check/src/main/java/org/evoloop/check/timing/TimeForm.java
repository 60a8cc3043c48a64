package org.evoloop.check.timing;

import java.util.List;
import org.evoloop.check.temporal.Formula;

/**
 * The form of a time property. Each of its formulas is about one moment. A state, a state of the device and a function
 * last; an event is present in the instant in which it comes, whatever its outcome.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface TimeForm {
    /** The formula that begins, lasts, or occurs. */
    Formula subject();

    /** The other formula; the subject itself if there is none. */
    default Formula other() {
        return subject();
    }

    /** Every duration in it. */
    List<Long> nanos();

    /** After {@code subject} begins, {@code other} holds for the first time within {@code span}. */
    record Response(Formula subject, Formula other, Span span) implements TimeForm {
        @Override
        public List<Long> nanos() {
            return List.of(span.minNanos(), span.maxNanos());
        }
    }

    /** {@code subject} lasts for a duration within {@code span} whenever it has begun. */
    record Stay(Formula subject, Span span) implements TimeForm {
        @Override
        public List<Long> nanos() {
            return List.of(span.maxNanos() == Span.FOR_EVER ? span.minNanos() : span.maxNanos());
        }
    }

    /** {@code subject} begins only where {@code other} has lasted for {@code minNanos} up to then. */
    record Before(Formula subject, Formula other, long minNanos) implements TimeForm {
        @Override
        public List<Long> nanos() {
            return List.of(minNanos);
        }
    }

    /** {@code subject} begins {@code most} times at most in any {@code windowNanos}, both ends included. */
    record Count(Formula subject, int most, long windowNanos) implements TimeForm {
        @Override
        public List<Long> nanos() {
            return List.of(windowNanos);
        }
    }
}
