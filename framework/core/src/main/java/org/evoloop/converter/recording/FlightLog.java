package org.evoloop.converter.recording;

import java.util.Locale;
import org.evoloop.converter.running.CoreDriver;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.flight.ConversionEvent;
import org.evoloop.flight.ObservedEvent;
import org.jspecify.annotations.Nullable;

/**
 * Reports a converter's occurrences to Java Flight Recorder.
 *
 * <p>Threading: guarded by the lock of the {@link CoreDriver}.
 */
public final class FlightLog {
    private final String converter;
    private @Nullable Occurrence inTheLoop;
    private @Nullable ConversionEvent conversion;

    FlightLog(String converter) {
        this.converter = converter;
    }

    public String converter() {
        return converter;
    }

    /**
     * It has come.
     *
     * @param admission {@code queued}, {@code dropped} or {@code refused}
     */
    public void observed(Occurrence occurrence, String admission) {
        ObservedEvent.record(converter, occurrence, admission);
    }

    /** {@code occurrence} has its turn; an overtaken one may have it again. */
    public void begun(Occurrence occurrence) {
        if (inTheLoop != occurrence) {
            inTheLoop = occurrence;
            conversion = ConversionEvent.begun();
        }
    }

    public void decided(long waitedNanos) {
        if (conversion != null) {
            conversion.decided(waitedNanos);
        }
    }

    /** Also called for an occurrence that never had its turn. */
    public void ended(
            Occurrence occurrence, Configuration before, Configuration after, Outcome outcome, String detail) {
        boolean hadItsTurn = inTheLoop == occurrence;
        ConversionEvent event = hadItsTurn ? conversion : ConversionEvent.begun();
        if (hadItsTurn) {
            inTheLoop = null;
            conversion = null;
        }
        if (event != null) {
            ConversionEvent.ended(
                    event, converter, occurrence, before, after, outcome.name().toLowerCase(Locale.ROOT), detail);
        }
    }
}
