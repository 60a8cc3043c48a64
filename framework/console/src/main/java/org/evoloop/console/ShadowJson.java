package org.evoloop.console;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.evoloop.converter.ShadowReport;
import org.evoloop.evolution.Configuration;
import org.evoloop.payload.JsonObject;
import org.evoloop.rehearsal.Difference;

/**
 * The report of a shadow, for programs:
 *
 * <ul>
 *   <li>{@code model}; {@code since}, in UTC
 *   <li>{@code originalState}, {@code newState}: the other models' states
 *   <li>{@code events}: how many were compared; {@code different}: how many they would have decided differently
 *   <li>{@code differences}, a list, newest first: {@code at}, {@code event}, {@code source}; {@code then}, the running
 *   models' result, and {@code now}, the other models' result, with reasons
 *   <li>{@code faults}, a list of the properties that they would have violated, newest first: {@code at}, {@code why}
 * </ul>
 *
 * <p>Threading: any thread may call it.
 *
 * @since 0.1
 */
public final class ShadowJson {
    private ShadowJson() {}

    /**
     * The object.
     *
     * @param most the largest number of differences and of faults, the newest ones
     */
    public static JsonObject of(ShadowReport report, int most) {
        Configuration at = report.at();
        return new JsonObject()
                .put("model", report.model())
                .put("since", report.since().toString())
                .put("originalState", at.original().name())
                .put("newState", at.evolved().name())
                .put("events", report.events())
                .put("different", report.different())
                .put(
                        "differences",
                        newest(report.differences(), most)
                                .map(ShadowJson::difference)
                                .toList())
                .put(
                        "faults",
                        newest(report.faults(), most).map(ShadowJson::fault).toList());
    }

    private static <T> Stream<T> newest(List<T> all, int most) {
        int last = all.size() - 1;
        return IntStream.rangeClosed(0, Math.min(most - 1, last)).mapToObj(back -> all.get(last - back));
    }

    private static JsonObject difference(Difference difference) {
        return new JsonObject()
                .put("at", difference.at().toString())
                .put("event", difference.occurrence().label())
                .put("source", difference.occurrence().source().name().toLowerCase(Locale.ROOT))
                .put("then", difference.then())
                .put("now", difference.now());
    }

    private static JsonObject fault(ShadowReport.Fault fault) {
        return new JsonObject().put("at", fault.at().toString()).put("why", fault.why());
    }
}
