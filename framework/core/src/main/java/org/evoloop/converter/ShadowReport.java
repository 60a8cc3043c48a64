package org.evoloop.converter;

import java.time.Instant;
import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.rehearsal.Difference;

/**
 * What other models would have done beside those that run, see {@link Shadow}.
 *
 * <p>Threading: immutable.
 *
 * @param model the name of the other new model
 * @param since when it began
 * @param at where device and evolved system would be
 * @param events how many were compared
 * @param different of how many the other models would have made something else
 * @param differences the last {@value ShadowCore#MOST_KEPT} of them, oldest first
 * @param faults what the {@linkplain Probation.Watches watches} of the evolution would have found, oldest first, at most
 *     {@value ShadowCore#MOST_KEPT}
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

    /**
     * That the other models would have broken what has to hold.
     *
     * @param why for people
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

    /** For messages: {@code 'guest': 120 events, 3 of them decided otherwise}. */
    @Override
    public String toString() {
        return "'" + model + "': " + events + (events == 1 ? " event, " : " events, ") + different
                + " of them decided otherwise" + (faults.isEmpty() ? "" : "; properties broken: " + faults.size());
    }
}
