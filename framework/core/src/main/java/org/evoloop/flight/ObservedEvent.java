package org.evoloop.flight;

import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;
import org.jspecify.annotations.Nullable;

/** An occurrence was reported to a converter. */
@Name("org.evoloop.Observed")
@Label("Observed")
@Description("An occurrence has come to a converter")
@Category("Evoloop")
@StackTrace(false)
public final class ObservedEvent extends Event {
    /** Used to ask whether a recording is running; a new one for each question would be garbage. */
    private static final ObservedEvent PROBE = new ObservedEvent();

    @Label("Converter")
    @Nullable
    String converter;

    @Label("Occurrence")
    @Nullable
    String occurrence;

    @Label("Admission")
    @Description("queued, dropped or refused")
    @Nullable
    String admission;

    private ObservedEvent() {}

    /** Records the event, if a recording is running. */
    public static void record(String converter, Object occurrence, String admission) {
        if (PROBE.isEnabled()) {
            ObservedEvent event = new ObservedEvent();
            if (event.shouldCommit()) {
                event.converter = converter;
                event.occurrence = occurrence.toString();
                event.admission = admission;
                event.commit();
            }
        }
    }
}
