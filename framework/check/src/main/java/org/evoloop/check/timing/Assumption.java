package org.evoloop.check.timing;

import org.evoloop.check.temporal.Formula;
import org.jspecify.annotations.Nullable;

/**
 * An assumption about the timing of a converter's environment, used by the check before it runs.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Assumption {
    /** Its subject: no two assumptions of a file have the same. */
    Object about();

    /** The time from when {@code event} is sent until the device has obeyed. */
    record Takes(String event, Span span) implements Assumption {
        @Override
        public Object about() {
            return "takes " + event;
        }
    }

    /**
     * The least time between two events of this name; if it is null, between any two that controllers and people
     * request.
     */
    record Gap(@Nullable String event, long minNanos) implements Assumption {
        @Override
        public Object about() {
            return event == null ? "presses" : "gap " + event;
        }
    }

    /**
     * {@code event} comes by itself once in each period in which {@code during} holds, this long after its beginning.
     */
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
