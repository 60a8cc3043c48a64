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

    private final List<Runnable> ofEvent = new ArrayList<>();
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
        if (isRead()) {
            ofEvent.add(() -> {
                line("----   " + (occurrence.source().isButton() ? "button_event" : "internal_event") + " : "
                        + occurrence.event() + "   -----");
                line("");
                line("Monitor");
                line(" inputs " + occurrence.event() + " event.");
            });
        }
    }

    synchronized void analyzed(Decision decision) {
        if (isRead()) {
            ofEvent.add(() -> {
                line("Analyze");
                states(decision.before());
                line(" mode: " + mode(decision));
            });
        }
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
        if (isRead()) {
            ofEvent.add(() -> {
                line("Plan");
                if (!anyEvents) {
                    line(" MAPE-K loop does not send events. ");
                }
                line("Execute");
            });
        }
    }

    synchronized void step(Event event) {
        if (isRead()) {
            ofEvent.add(() -> line(" MAPE-K loop will send this event : " + event));
        }
    }

    synchronized void command(Event event) {
        if (isRead()) {
            ofEvent.add(() -> line(" " + event + " command"));
        }
    }

    synchronized void starts(State state) {
        if (isRead()) {
            ofEvent.add(() -> line(" Operate existing functions for " + state + " in the another thread"));
        }
    }

    /** Asked before anything is kept: without a reader it costs nothing. */
    private static boolean isRead() {
        return LOG.isInfoEnabled();
    }

    private void sayEvent() {
        ofEvent.forEach(Runnable::run);
        ofEvent.clear();
    }

    /** The event's last lines; what was said meanwhile follows. */
    synchronized void executed(Configuration now) {
        sayEvent();
        if (isRead()) {
            states(now);
        }
        gap = true;
        closeEvent();
    }

    /** The event came to no good end. */
    synchronized void brokenOff(Configuration now) {
        if (inEvent) {
            executed(now);
        }
    }

    private void closeEvent() {
        inEvent = false;
        if (!later.isEmpty()) {
            later.forEach(this::line);
            later.clear();
        }
    }

    /** Something that does not belong to the event in the loop. */
    synchronized void notice(String line) {
        if (inEvent) {
            later.add(line);
        } else {
            line(line);
        }
    }

    private void states(Configuration configuration) {
        line(" original_current_state: " + configuration.original());
        line(" new_current_state: " + configuration.evolved());
    }

    private void line(String line) {
        if (gap) {
            LOG.info("");
        }
        LOG.info(line);
        gap = false;
        begun = true;
    }
}
