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
 * @param evolution which models took over from which while it ran or, by its journal, before; empty if none did or the
 *     way back is gone
 * @param shadow the report of the shadow; empty if there is none
 * @param doubt why the record of the device's state may be wrong; empty if it is certain
 * @param lastKnownSince since when the states are only the last known ones, because the loop is closed or the device
 *     cannot be reached; empty while they are up to date
 * @param queue how many events wait and how many were lost
 * @param events the outcomes of the events so far
 * @param conversionTime how long conversions take
 * @param components every component and its thread
 * @param function the running new function
 * @param faults guards, effects, functions, tasks, listeners and a journal that have failed
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

    /**
     * The number of events at one moment. Those observed are the sum of all others.
     *
     * @param handled by outcome, as the next four, see {@link org.evoloop.core.Outcome}
     * @param refused those that came, or waited, while the loop was closed
     * @param waiting those that wait for their turn
     * @param inProgress those that have it: one or none
     */
    public record EventCounts(
            long observed,
            long handled,
            long ignored,
            long stale,
            long failed,
            long dropped,
            long refused,
            long waiting,
            long inProgress) {}

    /**
     * Time from the observation of an event to the start of its execution, in nanoseconds of the converter's clock,
     * over the last events.
     *
     * @param events the number of events behind these figures, 0 to 1024
     */
    public record ConversionTime(int events, long lastNanos, long medianNanos, long percentile99Nanos) {}

    /**
     * The new function of the current state.
     *
     * @param state the state, empty if the device does the work
     * @param thread the thread, empty if it has returned or has none
     * @param progress its progress, in its own words; empty if it reports none
     * @param readings its progress in numbers
     */
    public record RunningFunction(String state, String thread, String progress, List<Reading> readings) {
        /** No function runs. */
        public static final RunningFunction NONE = new RunningFunction("", "", "", List.of());

        /** Its progress, in words and numbers; empty if it reports none. */
        public String describe() {
            return Stream.concat(
                            Stream.of(progress).filter(text -> !text.isEmpty()),
                            readings.stream().map(Reading::toString))
                    .collect(Collectors.joining(", "));
        }
    }

    /**
     * A part that is not a component and has failed.
     *
     * @param part names it, such as {@code guard [full]} or {@code function Move}
     * @param failures how often
     * @param lastFailure the message of the last failure
     */
    public record Fault(String part, long failures, String lastFailure) {}

    /**
     * The connection, see {@link DeviceLink}.
     *
     * @param readings the device's current readings; none while it cannot be reached, whatever it reported before
     */
    public record LinkStatus(boolean up, String text, List<Reading> readings) {
        /** Leaves out readings that may no longer hold. */
        public LinkStatus {
            readings = up ? List.copyOf(readings) : List.of();
        }
    }
}
