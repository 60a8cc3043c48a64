package org.evoloop.converter;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
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
 * @param system the new model's state for people, with where the device is if the state needs it somewhere
 * @param evolution which models took over from which while it ran or, by its journal, before; empty if none did or the
 *     way back is gone
 * @param shadow the report of the shadow; empty if there is none
 * @param doubt why the record of the device's state may be wrong; empty if it is certain
 * @param drift what the device did lately that its model does not have
 * @param lastKnownSince since when the states are only the last known ones, because the loop is closed or the device
 *     cannot be reached; empty while they are up to date
 * @param queue how many events wait and how many were lost
 * @param events the outcomes of the events so far
 * @param conversionTime how long conversions take
 * @param components every component and its thread
 * @param function the running new function
 * @param timers the timers of the new model's state that run, the next one first; none while the loop is closed
 * @param faults guards, effects, functions, tasks, listeners and a journal that have failed
 * @param link the connection to the device; null if no link was registered
 * @since 0.1
 */
public record ConverterStatus(
        String name,
        LoopState loop,
        Configuration states,
        String system,
        String evolution,
        String shadow,
        String doubt,
        Drift drift,
        Optional<Instant> lastKnownSince,
        QueueStatus queue,
        EventCounts events,
        ConversionTime conversionTime,
        List<ComponentStatus> components,
        RunningFunction function,
        List<RunningTimer> timers,
        List<Fault> faults,
        @Nullable LinkStatus link) {

    /**
     * What is wrong: first what holds now, and then what has failed since the converter was built, one entry a part.
     */
    public List<Trouble> troubles() {
        List<Trouble> found = new ArrayList<>();
        LinkStatus device = link;
        if (device != null && !device.up()) {
            found.add(new Trouble(Trouble.LINK, device.text(), 1));
        }
        if (!doubt.isEmpty()) {
            found.add(new Trouble(Trouble.RECORD, doubt, 1));
        }
        if (device != null && !device.error().isEmpty()) {
            found.add(new Trouble(Trouble.DEVICE, device.error(), 1));
        }
        for (ComponentStatus component : components) {
            if (component.activity() == ComponentStatus.Activity.STUCK) {
                // When it has been given up, that is a failure: the same trouble.
                found.add(new Trouble(component.name(), component.name() + " is stuck", component.failures() + 1));
            } else if (component.failures() > 0) {
                found.add(Trouble.failures(component.name(), component.failures(), component.lastFailure()));
            }
        }
        faults.forEach(fault -> found.add(Trouble.failures(fault.part(), fault.failures(), fault.lastFailure())));
        return found;
    }

    /**
     * The number of events at one moment. Those observed are the sum of all others.
     *
     * @param handled by outcome, as the next four, see {@link org.evoloop.evolution.Outcome}
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
     * A timer of the new model's state.
     *
     * @param event the event that it raises, such as {@code tm(5min)}
     * @param remaining the time left until then, by the converter's clock; zero if it is due and waits for its turn
     * @param due the wall-clock time of that moment; it stays the same while the timer runs
     */
    public record RunningTimer(String event, Duration remaining, Instant due) {
        private static final int TENTHS_SHOWN_BELOW_SECONDS = 10;
        private static final int MINUTES_SHOWN_FROM_SECONDS = 120;
        private static final int HOURS_SHOWN_FROM_SECONDS = 7200;

        /** For people: {@code tm(5min) in 4 min 30 s}. */
        public String describe() {
            return event + " in " + inWords();
        }

        private String inWords() {
            long tenths = remaining.plusMillis(50).toMillis() / 100;
            long seconds = remaining.plusMillis(500).toSeconds();
            if (seconds < TENTHS_SHOWN_BELOW_SECONDS) {
                return tenths / 10 + "." + tenths % 10 + " s";
            } else if (seconds < MINUTES_SHOWN_FROM_SECONDS) {
                return seconds + " s";
            } else if (seconds < HOURS_SHOWN_FROM_SECONDS) {
                return seconds / 60 + " min " + seconds % 60 + " s";
            }
            return seconds / 3600 + " h " + seconds / 60 % 60 + " min";
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

        /** What the device itself says is wrong, in its reading {@code error}; empty if nothing is. */
        public String error() {
            return readings.stream()
                    .filter(reading -> reading.name().equals("error") && !"none".equals(reading.value()))
                    .map(reading -> String.valueOf(reading.value()))
                    .findFirst()
                    .orElse("");
        }
    }
}
