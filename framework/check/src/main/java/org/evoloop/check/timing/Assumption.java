package org.evoloop.check.timing;

import org.evoloop.check.temporal.Formula;
import org.jspecify.annotations.Nullable;

/**
 * What is known of the time that things around a converter take. The check before it runs counts on that.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Assumption {
    /** What it is about: no two of a file are about the same. */
    Object about();

    /** From when {@code event} is sent until the device has obeyed. */
    record Takes(String event, Span span) implements Assumption {
        @Override
        public Object about() {
            return "takes " + event;
        }
    }

    /**
     * From one event of this name to the next one; of any name if it is null: of all that controllers and people press.
     */
    record Gap(@Nullable String event, long minNanos) implements Assumption {
        @Override
        public Object about() {
            return event == null ? "presses" : "gap " + event;
        }
    }

    /** {@code event} comes by itself once in each time that {@code during} lasts, so long after its beginning. */
    record Comes(String event, Span span, Formula.Atom during) implements Assumption {
        @Override
        public Object about() {
            return "comes " + event + " after " + during;
        }
    }

    /** How many events may wait. */
    record Queue(int capacity) implements Assumption {
        @Override
        public Object about() {
            return "queue";
        }
    }
}
