package org.evoloop.converter;

import java.time.Instant;
import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.rehearsal.Difference;

/**
 * A comparison of other models with the running ones, see {@link Shadow}.
 *
 * <p>Threading: immutable.
 *
 * @param model the name of the other new model
 * @param since when the shadow began
 * @param at the states in which device and evolved system would be
 * @param events how many events were compared
 * @param different how many events the other models would have decided differently
 * @param differences the last {@value #MOST_KEPT} of them, oldest first
 * @param faults the violations that the {@linkplain Probation.Watches watches} of the evolution would have found,
 *     oldest first, at most {@value #MOST_KEPT}
 * @since 0.1
 */
public record ShadowReport(
        String model,
        Instant since,
        Configuration at,
        long events,
        long different,
        List<Difference> differences,
        List<Fault> faults) {

    /** How many differences, and how many faults, are remembered. */
    public static final int MOST_KEPT = 1_000;

    /**
     * A violation that the other models would have caused.
     *
     * @param why the reason, for people
     */
    public record Fault(Instant at, String why) {
        @Override
        public String toString() {
            return at + "  " + why;
        }
    }

    public ShadowReport {
        differences = List.copyOf(differences);
        faults = List.copyOf(faults);
    }

    /** For messages: {@code 'guest': 120 events, 3 of them decided differently}. */
    @Override
    public String toString() {
        return "'" + model + "': " + events + (events == 1 ? " event, " : " events, ") + different
                + " of them decided differently" + (faults.isEmpty() ? "" : "; properties broken: " + faults.size());
    }
}
