package org.evoloop.converter.attachment;

import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import org.evoloop.evolution.EventNames;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.MapeLoop;
import org.evoloop.statemachine.Event;

/** What a monitor does for the converter. */
public interface MonitorAccess {
    /**
     * From now on it reports to {@code loop}.
     *
     * @param holding the guards that the original model draws for an event and that hold now, by its values
     * @param own whether only the device can raise an event
     * @param endings who is to be asked how an occurrence ends
     */
    void attach(
            LoopConfig config,
            MapeLoop<Occurrence, ?, ?> loop,
            EventNames names,
            BiFunction<Event, Values, Set<String>> holding,
            Predicate<Event> own,
            Endings endings);

    /** Sets the names by which it reports events. */
    void useNames(EventNames names);

    /**
     * Refuses names that do not fit.
     *
     * @throws IllegalArgumentException if it reports an event that is not among {@code names}
     */
    void requireKnown(EventNames names);

    /** Those that the device takes by itself. */
    Set<Event> spontaneousEvents();

    /** Those that a controller raises through it. */
    Set<Event> controllerEvents();
}
