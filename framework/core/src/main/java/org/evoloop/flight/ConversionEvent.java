package org.evoloop.flight;

import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;
import jdk.jfr.Timespan;
import org.jspecify.annotations.Nullable;

/** An occurrence was converted; lasts from the beginning of its turn to its end. */
@Name("org.evoloop.Conversion")
@Label("Conversion")
@Description("An occurrence from its turn in the loop to its end")
@Category("Evoloop")
@StackTrace(false)
public final class ConversionEvent extends Event {
    /** Used to ask whether a recording is running; a new one for each question would be garbage. */
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
    @Description("From its observation to the start of its execution; 0 if it was not executed")
    @Timespan(Timespan.NANOSECONDS)
    long decidedAfter;

    private ConversionEvent() {}

    /** The occurrence has its turn; null if no recording is running. */
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
     * @param nanos the time since it was observed
     */
    public void decided(long nanos) {
        decidedAfter = nanos;
    }

    /**
     * The occurrence has ended.
     *
     * @param event the result of {@link #begun}
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
