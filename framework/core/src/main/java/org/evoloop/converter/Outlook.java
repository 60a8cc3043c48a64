package org.evoloop.converter;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;

/**
 * What can happen next, and what a converter would do then: its core's own decisions, where it is now.
 *
 * <p>Threading: immutable.
 *
 * @param at the states of both models
 * @param events each event of a controller, with an effect here or without, in order; then what comes by itself here
 * @param doubtful the step of which it is unknown whether the device has taken it; empty if the record is certain or
 *     in doubt for another reason
 * @since 0.1
 */
public record Outlook(Configuration at, List<Next> events, Optional<Step> doubtful) {
    /** Keeps its own list. */
    public Outlook {
        events = List.copyOf(events);
    }

    /**
     * An event that can come.
     *
     * @param trigger the event without guards
     * @param source who raises it: a controller, the device, a timer or a function
     * @param deferred whether the state lets it wait where it has no effect
     * @param delay for a timer of the state, the whole time from its start; empty for any other event
     * @param decisions what it would mean, one for each combination of guards that is drawn, in the order in which they
     *     are tried; empty if it has no effect here
     */
    public record Next(
            Event trigger, Source source, boolean deferred, Optional<Duration> delay, List<Decision> decisions) {
        /** Keeps its own list. */
        public Next {
            decisions = List.copyOf(decisions);
        }
    }
}
