package org.evoloop.flight;

import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;
import org.jspecify.annotations.Nullable;

/** A component of a loop was called. */
@Name("org.evoloop.Phase")
@Label("Phase")
@Description("Analyze, plan or execute was called")
@Category("Evoloop")
@StackTrace(false)
public final class PhaseEvent extends Event {
    /** Used to ask whether a recording is running; a new one for each question would be garbage. */
    private static final PhaseEvent PROBE = new PhaseEvent();

    @Label("Loop")
    @Nullable
    String loop;

    @Label("Phase")
    @Nullable
    String phase;

    @Label("Component")
    @Nullable
    String component;

    @Label("Input")
    @Nullable
    String input;

    private PhaseEvent() {}

    /** The call begins; null if no recording is running. */
    public static @Nullable PhaseEvent begun() {
        if (!PROBE.isEnabled()) {
            return null;
        }
        PhaseEvent event = new PhaseEvent();
        event.begin();
        return event;
    }

    /**
     * The call has returned, or thrown.
     *
     * @param event the result of {@link #begun}
     */
    public static void ended(@Nullable PhaseEvent event, String loop, String phase, String component, Object input) {
        if (event != null && event.shouldCommit()) {
            event.loop = loop;
            event.phase = phase;
            event.component = component;
            event.input = input.toString();
            event.commit();
        }
    }
}
