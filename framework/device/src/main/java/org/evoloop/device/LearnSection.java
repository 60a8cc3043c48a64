package org.evoloop.device;

import java.time.Duration;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;

/**
 * What a device file says about learning the device: how it is brought to its beginning, and what must not be done.
 *
 * <p>Threading: immutable.
 *
 * @param home the state in which it begins and is left; empty if the device does not say where it is
 * @param reset events that are sent until the device is at home, or once if it does not say where it is
 * @param resetIn by state, instead: events that are sent there until the device is at home
 * @param homeWithin how long the device may take to come home after an event of the reset
 * @param settle how long it must be quiet after an event
 * @param never events that are never sent
 * @param neverIn by state: events that are not sent there
 * @param pressesAnHour how many events are sent in an hour at most; empty for no limit
 * @param stops by reading: the value above which learning ends
 * @param hours the first hour of the day and the first that is too late; empty for all
 * @since 0.1
 */
public record LearnSection(
        String home,
        List<String> reset,
        Map<String, List<String>> resetIn,
        Duration homeWithin,
        Duration settle,
        Set<String> never,
        Map<String, Set<String>> neverIn,
        Optional<Integer> pressesAnHour,
        Map<String, Double> stops,
        List<LocalTime> hours) {
    private static final int MOST_PRESSES = 1_000_000;
    private static final Duration SETTLE = Duration.ofMillis(500);

    /** Nothing is said. */
    public static final LearnSection NONE = new LearnSection(
            "", List.of(), Map.of(), Duration.ZERO, SETTLE, Set.of(), Map.of(), Optional.empty(), Map.of(), List.of());

    public LearnSection {
        reset = List.copyOf(reset);
        resetIn = Map.copyOf(resetIn);
        never = Set.copyOf(never);
        neverIn = Map.copyOf(neverIn);
        stops = Map.copyOf(stops);
        hours = List.copyOf(hours);
    }

    static LearnSection read(Section learn, FileModels models) {
        String home =
                learn.text("home").map(state -> reported(learn, state, models)).orElse("");
        Set<String> never = new LinkedHashSet<>();
        learn.texts("never").forEach(event -> never.add(sendable(learn, event, models)));
        List<String> reset = new ArrayList<>();
        Map<String, List<String>> resetIn = new LinkedHashMap<>();
        if (learn.any("reset").orElse(null) instanceof Node.Entries) {
            learn.section("reset").ifPresent(states -> {
                for (Node.Text state : states.keys()) {
                    resetIn.put(reported(learn, state, models), resetting(states, state.value(), never, models));
                }
                states.done();
            });
        } else {
            reset.addAll(resetting(learn, "reset", never, models));
        }
        Optional<Duration> homeWithin = learn.period("home-within");
        requireWayHome(learn, homeWithin.isPresent());
        Map<String, Set<String>> neverIn = new LinkedHashMap<>();
        learn.section("never-in").ifPresent(states -> {
            for (Node.Text state : states.keys()) {
                Set<String> events = new LinkedHashSet<>();
                states.texts(state.value()).forEach(event -> events.add(sendable(learn, event, models)));
                neverIn.put(reported(learn, state, models), events);
            }
            states.done();
        });
        Map<String, Double> stops = new LinkedHashMap<>();
        learn.section("stop-above").ifPresent(limits -> {
            for (Node.Text reading : limits.keys()) {
                String known = models.reading(reading);
                limits.value(known, LearnSection::number).ifPresent(limit -> stops.put(known, limit));
            }
            limits.done();
        });
        LearnSection section = new LearnSection(
                home,
                reset,
                resetIn,
                homeWithin.orElse(Duration.ZERO),
                learn.period("settle").orElse(SETTLE),
                never,
                neverIn,
                learn.number("presses-an-hour", 1, MOST_PRESSES),
                stops,
                learn.between("between"));
        learn.done();
        return section;
    }

    /** Without an event of the reset it comes home by itself, or a person brings it there. */
    private static void requireWayHome(Section learn, boolean waits) {
        if (learn.has("home") && !learn.has("reset") && !waits) {
            learn.problem("learn has a home, and nothing that brings the device there; add reset: EVENT, or"
                    + " home-within: TIME if it comes home by itself");
        }
        if (!learn.has("home") && learn.any("reset").orElse(null) instanceof Node.Entries) {
            learn.problem("learn.reset is by state, so learn needs home: STATE");
        }
    }

    /** The events that a reset sends. */
    private static List<String> resetting(Section section, String key, Set<String> never, FileModels models) {
        List<String> events = new ArrayList<>();
        for (Node.Text event : section.texts(key)) {
            events.add(sendable(section, event, models));
            if (never.contains(event.value())) {
                section.problems().at(event, "'" + event + "' is sent for the reset, and learn.never forbids it");
            }
        }
        return events;
    }

    private static String reported(Section learn, Node.Text state, FileModels models) {
        learn.problems()
                .requireOneOf(state, models.allReported(), "'" + state + "' is not a state that the device reports");
        return state.value();
    }

    private static String sendable(Section learn, Node.Text event, FileModels models) {
        learn.problems()
                .requireOneOf(event, models.allSent(), "'" + event + "' is not an event that is sent to the device");
        return event.value();
    }

    private static Double number(String text) {
        try {
            return Double.valueOf(text);
        } catch (NumberFormatException wrong) {
            throw new IllegalArgumentException("'" + text + "' is no number");
        }
    }
}
