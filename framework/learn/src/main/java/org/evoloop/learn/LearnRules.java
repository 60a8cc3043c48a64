package org.evoloop.learn;

import java.time.LocalTime;
import java.time.ZoneId;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * What must not be done to a device that is learned. The rules are checked before anything is sent.
 *
 * <p>Threading: immutable.
 *
 * @param never events that are never sent
 * @param neverIn by what the device shows: events that are not sent then
 * @param pressesAnHour how many events are sent in an hour at most; {@link Integer#MAX_VALUE} if there is no limit
 * @param stops readings at which learning ends
 * @param hours the hours of the day in which something is sent; null for all
 * @since 0.1
 */
public record LearnRules(
        Set<String> never,
        Map<String, Set<String>> neverIn,
        int pressesAnHour,
        List<Stop> stops,
        @Nullable Hours hours) {
    /** No rules. */
    public static final LearnRules NONE = new LearnRules(Set.of(), Map.of(), Integer.MAX_VALUE, List.of(), null);

    /**
     * Learning ends when a reading is above a limit.
     *
     * @param reading its name
     * @param above the limit
     */
    public record Stop(String reading, double above) {}

    /**
     * Hours of the day; {@code to} may be on the next day.
     *
     * @param from first
     * @param to first that is too late
     * @param zone whose time of day
     */
    public record Hours(LocalTime from, LocalTime to, ZoneId zone) {
        boolean contain(LocalTime time) {
            return from.isBefore(to)
                    ? !time.isBefore(from) && time.isBefore(to)
                    : !time.isBefore(from) || time.isBefore(to);
        }
    }

    public LearnRules {
        never = Set.copyOf(never);
        neverIn = Map.copyOf(neverIn);
        stops = List.copyOf(stops);
        if (pressesAnHour < 1) {
            throw new IllegalArgumentException("at least 1 press an hour is needed, not " + pressesAnHour);
        }
    }

    /** Whether {@code event} must not be sent while the device shows {@code shown}. */
    boolean forbid(String event, String shown) {
        return never.contains(event) || neverIn.getOrDefault(shown, Set.of()).contains(event);
    }

    /** Why learning has to end with these readings; empty if it need not. */
    Optional<String> stopAt(Map<String, Double> readings) {
        return stops.stream()
                .filter(stop -> readings.getOrDefault(stop.reading(), Double.NEGATIVE_INFINITY) > stop.above())
                .map(stop -> stop.reading() + " is " + readings.get(stop.reading()) + ", above " + stop.above())
                .findFirst();
    }
}
