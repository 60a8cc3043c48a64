package org.evoloop.device;

import java.time.LocalTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.evoloop.converter.Analysis;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.evolution.Occurrence;
import org.evoloop.function.QuietHours;
import org.evoloop.mqtt.home.DayPlan;
import org.evoloop.mqtt.home.HomeSetting;
import org.evoloop.time.Clock;
import org.evoloop.time.TimeOfWeek;
import org.jspecify.annotations.Nullable;

/**
 * When a device file raises events by itself, and when it must be quiet: its sections {@code schedule} and {@code quiet}.
 *
 * <p>Threading: immutable, but for the quiet hours, which their owner may change.
 */
final class DaySection {
    /** The key of a function that lasts until the quiet hours end. */
    static final String WAITING = "until-quiet-ends";

    /** Nothing is said. */
    static final DaySection NONE = new DaySection(Map.of(), null, Set.of());

    private final Map<String, List<TimeOfWeek>> schedule;
    private final @Nullable QuietHours quiet;
    private final Set<String> refused;

    private DaySection(Map<String, List<TimeOfWeek>> schedule, @Nullable QuietHours quiet, Set<String> refused) {
        this.schedule = schedule;
        this.quiet = quiet;
        this.refused = refused;
    }

    /** Reads the sections of {@code file}, after those that say which events there are. */
    static DaySection read(Section file, FileModels models) {
        Map<String, List<TimeOfWeek>> times = new LinkedHashMap<>();
        file.section("schedule").ifPresent(schedule -> {
            for (Node.Text event : schedule.keys()) {
                times.put(models.scheduled(event), times(schedule, event));
            }
        });
        Set<String> refused = new LinkedHashSet<>();
        QuietHours quiet = file.section("quiet")
                .map(section -> {
                    section.texts("refuse").forEach(event -> refused.add(models.raisable(event, "refused")));
                    return quiet(section, !refused.isEmpty() || isAwaited(file));
                })
                .orElse(null);
        return new DaySection(times, quiet, refused);
    }

    private static List<TimeOfWeek> times(Section schedule, Node.Text event) {
        List<TimeOfWeek> times = new ArrayList<>();
        List<Node.Text> written = schedule.texts(event.value());
        if (written.isEmpty()) {
            schedule.problems().at(event, "'" + event + "' needs times, such as [\"09:00\", \"MON,FRI 18:30\"]");
        }
        for (Node.Text time : written) {
            try {
                times.add(TimeOfWeek.parse("schedule." + event, time.value()));
            } catch (IllegalArgumentException wrong) {
                schedule.problems().at(time, String.valueOf(wrong.getMessage()));
            }
        }
        return times;
    }

    private static boolean isAwaited(Section file) {
        return file.named("functions").values().stream().anyMatch(function -> function.has(WAITING));
    }

    /** @param counts whether anything depends on it */
    private static QuietHours quiet(Section section, boolean counts) {
        section.require("between");
        List<LocalTime> hours = section.between("between");
        section.done();
        if (!counts) {
            section.problem("quiet refuses nothing, and nothing waits for its end; add refuse: [EVENT], or a function {"
                    + WAITING + ": EVENT}");
        }
        return hours.isEmpty() ? QuietHours.none() : QuietHours.between(hours.get(0), hours.get(1));
    }

    /**
     * The function in {@code section}, which waits for the end of the quiet hours; empty if it cannot be used, which is
     * noted.
     *
     * @param raised checks the event with which it finishes
     */
    Optional<FileKnowledge.Function> waiting(Section section, Function<Node.Text, String> raised) {
        Optional<String> event = section.text(WAITING).map(raised);
        QuietHours hours = quiet;
        if (hours == null) {
            section.problem(
                    section.name() + " waits for the end of the quiet hours, and there are none; add the section"
                            + " quiet: {between: [\"22:00\", \"07:00\"]}");
            return Optional.empty();
        }
        return event.map(last -> new FileKnowledge.Function(hours.waiting(last), Set.of()));
    }

    /** The plan of one converter. */
    DayPlan plan() {
        DayPlan plan = new DayPlan(quiet == null ? QuietHours.none() : quiet);
        schedule.forEach((event, times) -> plan.at(event, label(event), times));
        return plan;
    }

    private static String label(String event) {
        return event.substring(0, 1).toUpperCase(Locale.ROOT) + event.substring(1) + " at";
    }

    /** What refuses events in the quiet hours. */
    EventAnalyze analyze(Clock clock) {
        return new EventAnalyze("QuietHours") {
            @Override
            protected @Nullable Analysis analyze(Occurrence occurrence) {
                QuietHours hours = quiet;
                if (hours == null || !isRefused(occurrence) || !hours.isQuiet(clock.wallTime())) {
                    return super.analyze(occurrence);
                }
                return refuse(occurrence, "it is quiet until " + hours.until());
            }
        };
    }

    private boolean isRefused(Occurrence occurrence) {
        return occurrence.source().isButton() && !occurrence.isFact() && occurrence.is(refused.toArray(String[]::new));
    }

    /**
     * Lets a converter keep to it.
     *
     * @return what its owner can change
     */
    List<HomeSetting> addTo(SystemEventConverter converter) {
        DayPlan plan = plan();
        plan.timetable().ifPresent(converter::addMonitor);
        if (!refused.isEmpty()) {
            converter.addAnalyze(analyze(converter.clock()));
        }
        return plan.settings(converter.clock(), quiet != null);
    }
}
