package org.evoloop.flight;

import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;
import jdk.jfr.Timespan;
import org.jspecify.annotations.Nullable;

/** An occurrence has come to its end; it lasts from its turn on. */
@Name("org.evoloop.Conversion")
@Label("Conversion")
@Description("An occurrence from its turn in the loop to its end")
@Category("Evoloop")
@StackTrace(false)
public final class ConversionEvent extends Event {
    /** Tells whether somebody records; one made for each question would be garbage. */
    private static final ConversionEvent PROBE = new ConversionEvent();

    @Label("Converter")
    @Nullable
    String converter;

    @Label("Occurrence")
    @Nullable
    String occurrence;

    @Label("Before")
    @Description("The states of both models")
    @Nullable
    String before;

    @Label("After")
    @Description("The states of both models")
    @Nullable
    String after;

    @Label("Outcome")
    @Nullable
    String outcome;

    @Label("Detail")
    @Nullable
    String detail;

    @Label("Decided After")
    @Description("From its being observed to its execution beginning; 0 if it was not executed")
    @Timespan(Timespan.NANOSECONDS)
    long decidedAfter;

    private ConversionEvent() {}

    /** It has its turn; null if nobody records. */
    public static @Nullable ConversionEvent begun() {
        if (!PROBE.isEnabled()) {
            return null;
        }
        ConversionEvent event = new ConversionEvent();
        event.begin();
        return event;
    }

    /**
     * It was decided.
     *
     * @param nanos from its being observed
     */
    public void decided(long nanos) {
        decidedAfter = nanos;
    }

    /**
     * It has come to its end.
     *
     * @param event what {@link #begun} has returned
     */
    public static void ended(
            @Nullable ConversionEvent event,
            String converter,
            Object occurrence,
            Object before,
            Object after,
            String outcome,
            String detail) {
        if (event != null && event.shouldCommit()) {
            event.converter = converter;
            event.occurrence = occurrence.toString();
            event.before = before.toString();
            event.after = after.toString();
            event.outcome = outcome;
            event.detail = detail;
            event.commit();
        }
    }
}
