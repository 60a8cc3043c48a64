package org.evoloop.engine.codec;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Reads events, steps, decisions and occurrences. Transitions are those of the models; an event need not be: any may have been
 * reported.
 *
 * <p>Errors: what cannot be read, or is not in the models, is a {@link CodecException}.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class ElementReader {
    private static final DecisionKind[] KINDS = DecisionKind.values();

    private final Items items;
    private final Names names;

    /** One for what was reported and planned: a state need not be in the models, either. */
    public ElementReader(ModelPair models, Items items) {
        this(new Names(models, items, false), items);
    }

    private ElementReader(Names names, Items items) {
        this.items = items;
        this.names = names;
    }

    /** One for what a core has accepted: states are those of the models. */
    static ElementReader strict(ModelPair models, Items items) {
        return new ElementReader(new Names(models, items, true), items);
    }

    /** Reads an event. */
    public Event event() {
        return names.event();
    }

    /** Reads a state of the device. */
    public State state() {
        return names.originalState();
    }

    /** Returns {@code value} after checking that its line has ended. */
    <T> T ended(T value) {
        items.ends();
        return value;
    }

    <T> List<T> many(String name, Supplier<T> one) {
        items.next(name);
        int count = ended(items.count());
        if (count == 0) {
            return List.of();
        }
        List<T> all = new ArrayList<>();
        while (all.size() < count) {
            all.add(one.get());
        }
        return List.copyOf(all);
    }

    Configuration at(String name) {
        items.next(name);
        return ended(new Configuration(names.originalState(), names.evolvedState()));
    }

    @Nullable
    Transition transition(String name) {
        items.next(name);
        Transition transition = items.isNone() ? null : names.evolvedTransition();
        items.ends();
        return transition;
    }

    @Nullable
    Step step(String name) {
        items.next(name);
        if (items.isNone()) {
            items.ends();
            return null;
        }
        boolean byDevice = items.choice("device", "sent");
        boolean conditional = items.choice("conditional", "always");
        Transition taken = ended(names.originalTransition());
        return new Step(taken, taken.event().trigger(), byDevice, conditional);
    }

    Step someStep() {
        Step step = step("step");
        if (step == null) {
            throw items.damaged("a step is missing");
        }
        return step;
    }

    /** Reads a decision; null if there is none. */
    public @Nullable Decision decision() {
        items.next("decision");
        if (items.isNone()) {
            items.ends();
            return null;
        }
        String word = ended(items.word());
        Configuration before = at("before");
        Configuration after = at("after");
        Transition transition = transition("transition");
        List<Step> steps = many("steps", this::someStep);
        items.next("effects");
        List<String> effects = ended(items.names());
        items.next("reason");
        String reason = ended(items.text());
        for (DecisionKind kind : KINDS) {
            if (kind.word().equals(word) && (transition != null || !kind.needsTransition())) {
                return kind.made(before, after, steps, transition, effects, reason);
            }
        }
        throw items.damaged("'" + word + "' is not a decision that could be made here");
    }

    /** Reads an occurrence. */
    public Occurrence occurrence() {
        String kind = items.next();
        long observedNanos = items.number();
        Occurrence read = switch (kind) {
            case "heard" -> heard(observedNanos);
            case "asked" -> asked(observedNanos);
            case "found" -> new Occurrence.Found(names.originalState(), observedNanos);
            case "evolved" -> new Occurrence.Evolved(items.text(), observedNanos);
            case "violated" -> new Occurrence.Violated(items.text(), observedNanos);
            case "in-doubt" -> new Occurrence.InDoubt(items.text(), observedNanos);
            default -> throw items.damaged("'" + kind + "' is not an occurrence");
        };
        return ended(read);
    }

    private Occurrence heard(long observedNanos) {
        long visit = items.number();
        Source source = Constants.SOURCES.read(items);
        boolean acted = items.choice("acted", "told");
        Event event = names.event();
        List<String> texts = items.names();
        Set<String> holding = texts.isEmpty() ? Set.of() : new TreeSet<>(texts);
        return new Occurrence.Heard(event, values(), source, acted, holding, visit, observedNanos);
    }

    private Occurrence asked(long observedNanos) {
        long visit = items.number();
        return new Occurrence.Asked(names.event(), values(), visit, observedNanos);
    }

    private Values values() {
        int count = items.count();
        if (count == 0) {
            return Values.NONE;
        }
        Map<String, Object> byName = new LinkedHashMap<>();
        for (int read = 0; read < count; read++) {
            byName.put(items.name(), items.value());
        }
        try {
            return new Values(byName);
        } catch (IllegalArgumentException e) {
            throw items.damaged(String.valueOf(e.getMessage()));
        }
    }
}
