package org.evoloop.device;

import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.DoublePredicate;
import java.util.function.Predicate;
import org.evoloop.converter.DeviceLink;
import org.evoloop.device.file.Section;
import org.evoloop.evolution.Values;
import org.evoloop.function.Reading;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The guards of a device file: by the time of day, by a reading, or by a value of the event. None holds before {@link
 * #attach}, and one about a reading that is not known does not hold.
 *
 * <p>Threading: attached before the converter is built; evaluated by any thread.
 */
final class Guards {
    private final Map<String, Predicate<Values>> byText = new LinkedHashMap<>();
    private List<DeviceLink> links = List.of();
    private @Nullable Clock clock;

    private Guards() {}

    /** Reads the section {@code guards} of {@code file}. */
    static Guards read(Section file, FileModels models) {
        Guards guards = new Guards();
        file.named("guards").forEach((text, section) -> {
            models.guard(text);
            section.oneOf(List.of("between", "reading", "value"))
                    .ifPresent(kind -> guards.byText.put(text.value(), guards.guard(kind, section)));
            section.done();
        });
        return guards;
    }

    private Predicate<Values> guard(String kind, Section section) {
        if (kind.equals("between")) {
            return between(section);
        }
        String name = section.text(kind).map(text -> text.value()).orElse("");
        DoublePredicate range = range(section);
        return kind.equals("reading")
                ? values -> reading(name).stream().anyMatch(range)
                : values -> values.byName().get(name) instanceof Number number && range.test(number.doubleValue());
    }

    private static DoublePredicate range(Section section) {
        if (!section.has("above") && !section.has("below")) {
            section.problem(section.name() + " needs above or below, or both");
        }
        double above = section.value("above", Guards::number).orElse(Double.NEGATIVE_INFINITY);
        double below = section.value("below", Guards::number).orElse(Double.POSITIVE_INFINITY);
        return value -> value > above && value < below;
    }

    /** A number in a file. */
    static Double number(String text) {
        if (!text.matches("[+-]?[0-9]{1,15}(\\.[0-9]{1,15})?")) {
            throw new IllegalArgumentException("'" + text + "' is no number");
        }
        return Double.valueOf(text);
    }

    private Predicate<Values> between(Section section) {
        List<LocalTime> times = section.between("between");
        if (times.isEmpty()) {
            return values -> false;
        }
        LocalTime from = times.get(0);
        LocalTime to = times.get(1);
        return values -> {
            LocalTime now = now();
            boolean after = !now.isBefore(from);
            boolean before = now.isBefore(to);
            return from.isBefore(to) ? after && before : after || before;
        };
    }

    private LocalTime now() {
        Clock known = clock;
        return known == null
                ? LocalTime.MIDNIGHT
                : ZonedDateTime.ofInstant(known.wallTime(), ZoneId.systemDefault())
                        .toLocalTime();
    }

    private OptionalDouble reading(String name) {
        return links.stream()
                .flatMap(link -> link.readings().stream())
                .filter(reading -> reading.name().equals(name) && reading.value() instanceof Number)
                .map(Reading::value)
                .mapToDouble(value -> ((Number) value).doubleValue())
                .findFirst();
    }

    /** From now on they hold or not by this clock and the readings of these links. */
    void attach(Clock its, List<DeviceLink> known) {
        clock = its;
        links = List.copyOf(known);
    }

    Map<String, Predicate<Values>> all() {
        return byText;
    }
}
