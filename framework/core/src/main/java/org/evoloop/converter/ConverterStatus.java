package org.evoloop.converter;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.evolution.Configuration;
import org.evoloop.function.Reading;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.QueueStatus;
import org.jspecify.annotations.Nullable;

/**
 * A snapshot of a converter's status.
 *
 * <p>Threading: immutable.
 *
 * @param name the converter's name
 * @param loop the state of the loop's lifecycle
 * @param states the current states of both models
 * @param evolution which models took over from which while it ran, as long as a way leads back, or as its journal says;
 *     else empty
 * @param shadow what other models would have done beside those that run; empty if there are none
 * @param doubt why the record of the device's state may be wrong; empty if it is certain
 * @param lastKnownSince since when these are only the last states that are known, because the loop is closed or the
 *     device cannot be reached; empty while they are kept up to date
 * @param queue what waits and what was lost
 * @param events what became of the events so far
 * @param conversionTime how long conversions take
 * @param components every component and its thread
 * @param function the new function that runs
 * @param faults guards, effects, functions, tasks and listeners that have failed
 * @param link the connection to the device; null if no link was registered
 * @since 0.1
 */
public record ConverterStatus(
        String name,
        LoopState loop,
        Configuration states,
        String evolution,
        String shadow,
        String doubt,
        Optional<Instant> lastKnownSince,
        QueueStatus queue,
        EventCounts events,
        ConversionTime conversionTime,
        List<ComponentStatus> components,
        RunningFunction function,
        List<Fault> faults,
        @Nullable LinkStatus link) {

    /** How many events had which outcome, see {@link org.evoloop.core.Outcome}. */
    public record EventCounts(long handled, long ignored, long stale, long failed) {}

    /**
     * Time from an event being observed to its execution beginning, in nanoseconds of the converter's clock, over the
     * last events.
     *
     * @param events how many events these figures are of, 0 to 1024
     */
    public record ConversionTime(int events, long lastNanos, long medianNanos, long percentile99Nanos) {}

    /**
     * The new function of the current state.
     *
     * @param state the state, empty if the device does the work
     * @param thread the thread, empty if it has returned or has none
     * @param progress how far it is, in its own words; empty if it says nothing
     * @param readings the same in numbers
     */
    public record RunningFunction(String state, String thread, String progress, List<Reading> readings) {
        /** No function runs. */
        public static final RunningFunction NONE = new RunningFunction("", "", "", List.of());

        /** How far it is, in words and numbers; empty if it says nothing. */
        public String describe() {
            return Stream.concat(
                            Stream.of(progress).filter(text -> !text.isEmpty()),
                            readings.stream().map(Reading::toString))
                    .collect(Collectors.joining(", "));
        }
    }

    /**
     * What is no component and has failed.
     *
     * @param part which it is, such as {@code guard [full]} or {@code function Move}
     * @param failures how often
     * @param lastFailure the message of the last failure
     */
    public record Fault(String part, long failures, String lastFailure) {}

    /**
     * The connection, see {@link DeviceLink}.
     *
     * @param readings of the device now; none while it cannot be reached, whatever it reported before
     */
    public record LinkStatus(boolean up, String text, List<Reading> readings) {
        /** Leaves out readings that may no longer hold. */
        public LinkStatus {
            readings = up ? List.copyOf(readings) : List.of();
        }
    }
}
