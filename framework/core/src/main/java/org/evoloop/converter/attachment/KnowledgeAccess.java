package org.evoloop.converter.attachment;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.evoloop.converter.binding.Bindings;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.EventNames;
import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** What a converter's knowledge knows beside the models. */
public interface KnowledgeAccess {
    /** Has the functions registered, once, even if building the converter is tried again. */
    void register();

    /**
     * Problems with the registrations, a line each.
     *
     * @param leftOver whether a registration for a name that the models do not have is a problem. It is not when they
     *     take over from models for which the code still has registrations
     */
    List<String> problems(boolean leftOver);

    /** The code behind guards and effects. */
    Bindings bindings();

    /** The names of the events of both models. */
    EventNames eventNames();

    /** The timer events of {@code state} and their delays. */
    Map<Event, Duration> timersOf(State state);

    /** The function that runs when {@code transition} of the new model is taken. */
    NewFunction action(Transition transition);

    /**
     * The state of this name in which the device says that it is.
     *
     * @throws IllegalStateException if its model does not have it; the message lists the most similar names
     */
    State located(String name);

    /** Sets where the states are kept from now on; null for nowhere. */
    void attach(@Nullable Supplier<Configuration> kept);
}
