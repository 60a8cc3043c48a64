package org.evoloop.check.timing;

import java.util.List;
import org.evoloop.check.temporal.Formula;

/**
 * What a time property asks for. Its formulas are about one moment each. They are seen as follows: a state, a state of
 * the device and a function last; an event is there in the instant in which it comes, whatever becomes of it.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface TimeForm {
    /** What it is about: what begins, lasts, or occurs. */
    Formula subject();

    /** What else is to be seen; the subject itself if nothing is. */
    default Formula other() {
        return subject();
    }

    /** Every length of time in it. */
    List<Long> nanos();

    /** After {@code subject} begins, {@code other} holds for the first time within {@code span}. */
    record Response(Formula subject, Formula other, Span span) implements TimeForm {
        @Override
        public List<Long> nanos() {
            return List.of(span.minNanos(), span.maxNanos());
        }
    }

    /** {@code subject} lasts as long as {@code span} says whenever it has begun. */
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
