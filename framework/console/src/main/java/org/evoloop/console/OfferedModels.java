package org.evoloop.console;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * The new models that a converter's owner may choose from: those of {@link NewModels#offered} that are evolutions of
 * the device's model. They are read once, on first use.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class OfferedModels {
    /** The longest wait for a choice made on a web page or in Home Assistant. */
    private static final Duration PATIENCE = Duration.ofSeconds(10);

    private final SystemEventConverter converter;
    private final NewModels models;

    /** The machines' names, by reference. */
    private @Nullable Map<String, String> names;

    OfferedModels(SystemEventConverter converter, NewModels models) {
        this.converter = converter;
        this.models = models;
    }

    /** The models as {@code FILE#NAME}, in the program's order; empty if none is offered. */
    public List<String> references() {
        return List.copyOf(names().keySet());
    }

    /** The one that the converter runs; empty if it runs another. */
    public Optional<String> running() {
        String running = converter.knowledge().models().evolved().name();
        return names().entrySet().stream()
                .filter(entry -> entry.getValue().equals(running))
                .map(Map.Entry::getKey)
                .findFirst();
    }

    /**
     * Evolves to one of them, if that is possible within 10 s.
     *
     * @throws IllegalArgumentException if it is not offered
     * @throws ModelException as in {@link SystemEventConverter#evolve}
     * @throws org.evoloop.converter.EvolutionException as in {@link SystemEventConverter#evolve}
     */
    public void choose(String reference) {
        if (!names().containsKey(reference)) {
            throw new IllegalArgumentException("there is no model " + reference + " to choose");
        }
        ModelPair next = pair(reference);
        converter.evolve(Evolution.to(converter.knowledgeOf(next)).withDeadline(PATIENCE));
    }

    /**
     * The device's model with one of them.
     *
     * @throws ModelException if it can no longer be read
     */
    public ModelPair pair(String reference) {
        return new ModelPair(converter.knowledge().models().original(), models.read(reference));
    }

    private synchronized Map<String, String> names() {
        Map<String, String> known = names;
        if (known == null) {
            known = new LinkedHashMap<>();
            for (String reference : models.offered()) {
                StateMachine machine = evolution(reference);
                if (machine != null) {
                    known.put(reference, machine.name());
                }
            }
            names = known;
        }
        return known;
    }

    /**
     * The machine to offer; null if it is not an evolution, or is the device's own model, which is useless as a choice.
     */
    private @Nullable StateMachine evolution(String reference) {
        try {
            ModelPair pair = pair(reference);
            pair.requireValid();
            converter.knowledgeOf(pair);
            return pair.evolved().name().equals(pair.original().name()) ? null : pair.evolved();
        } catch (ModelException unfit) {
            return null;
        }
    }
}
