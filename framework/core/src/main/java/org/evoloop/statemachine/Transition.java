package org.evoloop.statemachine;

import static java.util.Objects.requireNonNull;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * One element of T: in {@code source}, {@code event} leads to {@code target}.
 *
 * <p>Threading: immutable.
 *
 * @param effects names of the behaviors that run when it is taken, in order: those on leaving states, its own, and
 *     those on entering states
 * @param internal whether the state is neither left nor entered, so that its timers and its function continue; then
 *     source and target are the same
 * @param keeps the time triggers and activities of the source that continue in the target, since they belong to an
 *     enclosing state of both that is not left: names of events as in {@link Event#name} and of activities as in {@link
 *     StateMachine#activities}. An internal transition keeps all
 * @since 0.1
 */
public record Transition(
        State source, Event event, State target, List<String> effects, boolean internal, Set<String> keeps) {

    /**
     * @throws NullPointerException if anything is null; the message says what
     * @throws ModelException if it is internal and leads to another state
     */
    public Transition {
        requireNonNull(source, "the source of a transition is null");
        requireNonNull(event, "the event of a transition is null");
        requireNonNull(target, "the target of a transition is null");
        Names.requireAll(effects, "the effects of a transition are null, or one of them is; List.of() are none");
        Names.requireAll(keeps, "what a transition keeps is null, or one of the names is; Set.of() is nothing");
        effects = List.copyOf(effects);
        keeps = keeps.isEmpty() ? Set.of() : Collections.unmodifiableSet(new LinkedHashSet<>(keeps));
        if (internal && !source.equals(target)) {
            throw new ModelException("the internal transition on " + event + " leads from " + source + " to " + target
                    + "; end it where it begins");
        }
    }

    /** A transition of a machine without hierarchy. */
    public Transition(State source, Event event, State target, List<String> effects, boolean internal) {
        this(source, event, target, effects, internal, Set.of());
    }

    /** A transition without effects. */
    public Transition(State source, Event event, State target) {
        this(source, event, target, List.of(), false);
    }

    /** For messages: {@code Off --Clean--> On}. */
    @Override
    public String toString() {
        return source + " --" + event + "--> " + target;
    }
}
