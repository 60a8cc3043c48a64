package org.evoloop.converter;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The log of the paper's experiment, word for word, a line a message, as the SLF4J logger {@value #LOGGER}.
 *
 * <p>The lines of one event stand together, and are put into words when it has come to its end: the logger must not stand
 * in its way. What a new function says meanwhile follows after them.
 *
 * <p>Threading: thread-safe.
 */
final class Transcript {
    static final String LOGGER = "org.evoloop.transcript";

    private static final Logger LOG = LoggerFactory.getLogger(LOGGER);

    /** The lines of the event in the loop, and beside each what stands in its braces. */
    private final List<String> formats = new ArrayList<>();

    private final List<Object> arguments = new ArrayList<>();
    private final List<String> later = new ArrayList<>();
    private boolean inEvent;
    private boolean begun;

    /** Whether an empty line comes before the next one. */
    private boolean gap;

    synchronized void observed(Occurrence occurrence) {
        // One that came to no end at all.
        sayEvent();
        inEvent = true;
        gap = begun;
        keep(
                occurrence.source().isButton()
                        ? "----   button_event : {}   -----"
                        : "----   internal_event : {}   -----",
                occurrence.event());
        keep("", "");
        keep("Monitor", "");
        keep(" inputs {} event.", occurrence.event());
    }

    synchronized void analyzed(Decision decision) {
        keep("Analyze", "");
        keepStates(decision.before());
        keep(" mode: {}", mode(decision));
    }

    /** A detour counts as new: no single function of the device does what it does. */
    private static String mode(Decision decision) {
        if (decision instanceof Decision.NotAcceptable) {
            return "Not acceptable";
        }
        if (decision instanceof Decision.Resynchronization) {
            return "Resynchronize";
        }
        boolean isNew = decision instanceof Decision.NewFunction
                || (decision instanceof Decision.ExistingFunction existing && existing.isDetour());
        return isNew ? "Use new functions" : "Use existing functions";
    }

    synchronized void planned(boolean anyEvents) {
        keep("Plan", "");
        if (!anyEvents) {
            keep(" MAPE-K loop does not send events. ", "");
        }
        keep("Execute", "");
    }

    synchronized void step(Event event) {
        keep(" MAPE-K loop will send this event : {}", event);
    }

    synchronized void command(Event event) {
        keep(" {} command", event);
    }

    synchronized void starts(State state) {
        keep(" Operate existing functions for {} in the another thread", state);
    }

    private void keepStates(Configuration configuration) {
        keep(" original_current_state: {}", configuration.original());
        keep(" new_current_state: {}", configuration.evolved());
    }

    /** Without a reader it costs nothing. */
    private void keep(String format, Object argument) {
        if (LOG.isInfoEnabled()) {
            formats.add(format);
            arguments.add(argument);
        }
    }

    private void sayEvent() {
        for (int index = 0; index < formats.size(); index++) {
            line(formats.get(index), arguments.get(index));
        }
        formats.clear();
        arguments.clear();
    }

    /** The event's last lines; what was said meanwhile follows. */
    synchronized void executed(Configuration now) {
        keepStates(now);
        sayEvent();
        gap = true;
        inEvent = false;
        // By index: an iterator would be garbage in every event.
        for (int index = 0; index < later.size(); index++) {
            line("{}", later.get(index));
        }
        later.clear();
    }

    /** The event came to no good end. */
    synchronized void brokenOff(Configuration now) {
        if (inEvent) {
            executed(now);
        }
    }

    /** Something that does not belong to the event in the loop. */
    synchronized void notice(String line) {
        if (inEvent) {
            later.add(line);
        } else {
            line("{}", line);
        }
    }

    private void line(String format, Object argument) {
        if (gap) {
            LOG.info("");
        }
        LOG.info(format, argument);
        gap = false;
        begun = true;
    }
}
