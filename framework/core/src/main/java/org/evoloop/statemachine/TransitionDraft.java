package org.evoloop.statemachine;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A transition that is being drawn, part by part: {@code from("off").on("party").when("dark").to("wild").effect("chime")}.
 * The next {@link #from} or {@link #on} begins another, and {@link #build} ends them all.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class TransitionDraft {
    private final StateMachineBuilder builder;
    private final State source;
    private final List<String> guards = new ArrayList<>();
    private final List<String> effects = new ArrayList<>();
    private @Nullable Event trigger;
    private @Nullable State target;
    private boolean internal;

    TransitionDraft(StateMachineBuilder builder, State source) {
        this.builder = builder;
        this.source = source;
    }

    /**
     * The event that triggers it. If there is one already, another transition begins, which leaves the same state:
     * {@code from("off").on("press").to("on").on("party").to("wild")}.
     *
     * @param event its name, followed by its guards if it has any, as in {@code press [hot] [full]}
     */
    public TransitionDraft on(String event) {
        if (trigger != null) {
            return builder.from(source.name()).on(event);
        }
        trigger = StateMachineBuilder.drawn(event);
        return this;
    }

    /** A condition that must hold, beside any others. */
    public TransitionDraft when(String guard) {
        guards.add(requireNonNull(guard, "the guard of a transition is null"));
        return this;
    }

    /** The state to which it leads; for a transition that does not leave its state, see {@link #stays}. */
    public TransitionDraft to(String state) {
        target = new State(state);
        internal = false;
        return this;
    }

    /** Makes it internal: the state is neither left nor entered. */
    public TransitionDraft stays() {
        target = null;
        internal = true;
        return this;
    }

    /** A behavior that runs when it is taken, after any others. */
    public TransitionDraft effect(String name) {
        effects.add(requireNonNull(name, "the effect of a transition is null"));
        return this;
    }

    /** Ends this transition and begins another, which leaves {@code state}. */
    public TransitionDraft from(String state) {
        return builder.from(state);
    }

    /** Ends this transition; the machine's other parts follow. */
    public StateMachineBuilder and() {
        return builder;
    }

    /** Ends this transition, see {@link StateMachineBuilder#build}. */
    public StateMachine build() {
        return builder.build();
    }

    /** What is missing; empty if it is complete. */
    String problem() {
        String missing =
                trigger == null ? "event; write on(...)" : target == null && !internal ? "target; write to(...)" : "";
        return missing.isEmpty() ? "" : "the transition from " + source + " has no " + missing;
    }

    /** The transition, which must be complete. */
    Transition transition() {
        Event event = requireNonNull(trigger);
        List<String> all = new ArrayList<>(event.guards());
        all.addAll(guards);
        return new Transition(
                source, new Event(event.name(), all), target == null ? source : target, effects, internal);
    }
}
