package org.evoloop.converter.recording;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.converter.running.CoreDriver;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.event.Level;

/**
 * The log of the paper's experiment, word for word, one line per message, written to the SLF4J logger {@value #LOGGER}.
 * A line break in a name or in what a function says is written as {@code ?}.
 *
 * <p>The lines of one event are kept together, and logged by {@link #say} after it has ended, so that a slow logger
 * delays no event. Output of a new function meanwhile follows after them.
 *
 * <p>Threading: lines of the event in the loop are added under the lock of the {@link CoreDriver}; {@link #say} and
 * {@link #notice} may be called from any thread, and only they wait for the logger.
 */
public final class Transcript {
    /** The name of its logger. */
    public static final String LOGGER = "org.evoloop.transcript";

    private static final int MOST_LATER = 1000;

    private static final Logger LOG = LoggerFactory.getLogger(LOGGER);

    private final Object logging = new Object();

    private final String converter;

    /** Lines to be logged: formats, each followed by its argument, and by the event that it is about. */
    private final ArrayDeque<Object> ready = new ArrayDeque<>();

    private volatile boolean isReady;
    private final List<String> later = new ArrayList<>();

    /** How many lines were dropped because {@link #later} was full. */
    private int leftOut;

    private boolean inEvent;
    private boolean begun;

    /** Whether an empty line comes before the next one. */
    private boolean gap;

    // The event in the loop; costs nothing if the logger is off.

    private @Nullable Occurrence about;
    private final List<Object> lines = new ArrayList<>();
    private boolean traced;

    /** The new state whose function starts if the event succeeds. */
    private @Nullable State entered;

    /** @param converter its name */
    public Transcript(String converter) {
        this.converter = converter;
    }

    public void observed(Occurrence occurrence) {
        about = LOG.isInfoEnabled() ? occurrence : null;
        if (about == null) {
            return;
        }
        synchronized (this) {
            inEvent = true;
            gap = begun;
        }
        entered = null;
        keep(
                occurrence.source().isButton()
                        ? "----   button_event : {}   -----"
                        : "----   internal_event : {}   -----",
                occurrence.label());
        keep("", "");
        keep("Monitor", "");
        keep(" inputs {} event.", occurrence.label());
    }

    public void decided(Decision decision) {
        keep("Analyze", "");
        keepStates(decision.before());
        keep(" mode: {}", mode(decision));
        keep("Plan", "");
        boolean sends = decision.steps().size() > (decision.deviceBegan() ? 1 : 0);
        traced = decision instanceof Decision.ExistingState
                || decision instanceof Decision.Sending
                || (decision instanceof Decision.NewState && sends);
        if (!traced || decision.steps().isEmpty()) {
            keep(" MAPE-K loop does not send events. ", "");
        }
        keep("Execute", "");
        if (decision.deviceBegan()) {
            step(decision.steps().get(0));
        }
        entered = decision instanceof Decision.NewState ? decision.after().evolved() : null;
    }

    /** A plan of several events counts as new: no single function of the device does the same. */
    private static String mode(Decision decision) {
        if (decision instanceof Decision.NotAcceptable || decision instanceof Decision.Refused) {
            return "Not acceptable";
        }
        if (decision instanceof Decision.Resynchronization || decision instanceof Decision.Inquiry) {
            return "Resynchronize";
        }
        boolean isNew = decision instanceof Decision.NewState
                || (decision instanceof Decision.ExistingState existing && existing.isDetour());
        return isNew ? "Use new functions" : "Use existing functions";
    }

    public void step(Step step) {
        if (traced) {
            keep(" MAPE-K loop will send this event : {}", step.trigger());
        }
    }

    public void command(Event event) {
        keep(" {} command", event);
    }

    private void keepStates(Configuration configuration) {
        keep(" original_current_state: {}", configuration.original());
        keep(" new_current_state: {}", configuration.evolved());
    }

    private void keep(String format, Object argument) {
        if (about != null) {
            lines.add(format);
            lines.add(argument);
        }
    }

    /** Other models have taken over; no event waits for the logger here. */
    public synchronized void evolved(Occurrence.Evolved occurrence) {
        line("***  The converter has {}.  ***  ", occurrence.label());
    }

    /** A property is violated; no event waits for the logger here. */
    public synchronized void violated(Occurrence.Violated occurrence) {
        String text = "***  A " + occurrence.label() + ".  ***  ";
        if (!inEvent) {
            line("{}", text);
        } else if (later.size() < MOST_LATER) {
            later.add(text);
        } else {
            leftOut++;
        }
    }

    /** An occurrence has ended, or its plan was overtaken. */
    public void ended(Occurrence occurrence, Configuration now) {
        if (occurrence != about) {
            return;
        }
        if (now.evolved().equals(entered)) {
            keep(" Operate existing functions for {} in the another thread", now.evolved());
        }
        keepStates(now);
        makeReady();
        lines.clear();
        about = null;
    }

    private synchronized void makeReady() {
        String label = about == null ? "" : about.label();
        // By index: an iterator would be garbage in every event.
        for (int index = 0; index < lines.size(); index += 2) {
            line(lines.get(index), lines.get(index + 1), label);
        }
        gap = true;
        inEvent = false;
        for (int index = 0; index < later.size(); index++) {
            line("{}", later.get(index));
        }
        if (leftOut > 0) {
            line("... and {} more lines", leftOut);
        }
        later.clear();
        leftOut = 0;
    }

    private void line(Object format, Object argument) {
        line(format, argument, "");
    }

    private void line(Object format, Object argument, String event) {
        if (gap) {
            ready.add("");
            ready.add("");
            ready.add(event);
        }
        ready.add(format);
        ready.add(argument);
        ready.add(event);
        gap = false;
        begun = true;
        isReady = true;
    }

    /** A line that does not belong to the event in the loop. */
    public void notice(String text) {
        synchronized (this) {
            if (inEvent) {
                // A bound on the lines kept while one event is in the loop.
                if (later.size() < MOST_LATER) {
                    later.add(text);
                } else {
                    leftOut++;
                }
            } else {
                line("{}", text);
            }
        }
        say();
    }

    /** Logs the lines that are ready. */
    public void say() {
        if (!isReady) {
            return;
        }
        synchronized (logging) {
            while (true) {
                String format;
                Object argument;
                String event;
                synchronized (this) {
                    if (ready.isEmpty()) {
                        isReady = false;
                        return;
                    }
                    format = (String) ready.remove();
                    argument = ready.remove();
                    event = (String) ready.remove();
                }
                Keys.at(LOG, Level.INFO, converter, event).log(format, Names.inOneLine(argument.toString()));
            }
        }
    }
}
