package org.evoloop.flight;

import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;
import org.jspecify.annotations.Nullable;

/** A converter has done something for the event in its loop, or for the state that it is in. */
@Name("org.evoloop.Work")
@Label("Work")
@Description("A step was sent to the device, an effect was run, or a new function ran until its state was left")
@Category("Evoloop")
@StackTrace(false)
public final class WorkEvent extends Event {
    /** Used to ask whether a recording is running; a new one for each question would be garbage. */
    private static final WorkEvent PROBE = new WorkEvent();

    /** What was done. */
    public enum Kind {
        SEND,
        EFFECT,
        FUNCTION
    }

    @Label("Converter")
    @Nullable
    String converter;

    @Label("Kind")
    @Description("SEND, EFFECT or FUNCTION")
    @Nullable
    String kind;

    @Label("What")
    @Description("The step, the effect, or the function's state")
    @Nullable
    String what;

    private WorkEvent() {}

    /** The work begins; null if no recording is running. */
    public static @Nullable WorkEvent begun() {
        if (!PROBE.isEnabled()) {
            return null;
        }
        WorkEvent event = new WorkEvent();
        event.begin();
        return event;
    }

    /**
     * The work has ended, successfully or not.
     *
     * @param event the result of {@link #begun}
     */
    public static void ended(@Nullable WorkEvent event, String converter, Kind kind, Object what) {
        if (event != null && event.shouldCommit()) {
            event.converter = converter;
            event.kind = kind.name();
            event.what = what.toString();
            event.commit();
        }
    }
}
