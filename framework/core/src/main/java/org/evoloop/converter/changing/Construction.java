package org.evoloop.converter.changing;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.evoloop.converter.ConverterJournal;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.EventPlan;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.running.Assembly;
import org.evoloop.converter.running.ConverterShell;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.Component;
import org.evoloop.loop.LoopConfig;
import org.jspecify.annotations.Nullable;

/**
 * Builds a converter from what was added to it.
 *
 * <p>Threading: guarded by its converter.
 */
final class Construction {
    private final LoopConfig config;
    private final Ownership ownership;
    private final Assembly assembly;

    Construction(LoopConfig config, Ownership ownership, Assembly assembly) {
        this.config = config;
        this.ownership = ownership;
        this.assembly = assembly;
    }

    /**
     * Adds the defaults, and takes ownership of everything.
     *
     * @throws IllegalStateException if something is missing, or belongs to another converter
     */
    StateKnowledge complete(@Nullable StateKnowledge known) {
        List<String> problems = new ArrayList<>();
        if (known == null) {
            problems.add("no knowledge, call addKnowledge");
        }
        if (!assembly.has(Component.Role.EXECUTE)) {
            problems.add("no execute component, call addExecute");
        }
        if (known == null || !problems.isEmpty()) {
            throw refused(problems);
        }
        if (!assembly.has(Component.Role.ANALYZE)) {
            assembly.add(new EventAnalyze());
        }
        if (!assembly.has(Component.Role.PLAN)) {
            assembly.add(new EventPlan());
        }
        String another = "make one for each converter";
        ownership.take(config.clock(), "its clock", another, problems);
        ownership.take(known, known.name(), another, problems);
        for (Component component : assembly.all()) {
            ownership.take(component, component.name(), another, problems);
        }
        if (!problems.isEmpty()) {
            ownership.giveBackAll(null);
            throw refused(problems);
        }
        return known;
    }

    private IllegalStateException refused(List<String> problems) {
        return new IllegalStateException("converter " + config.name() + ": " + String.join("; ", problems));
    }

    /**
     * The knowledge with which the previous process ended: {@code built}, or that of the models to which it had
     * evolved.
     *
     * @throws IllegalStateException if it had evolved and no knowledge factory was added
     */
    StateKnowledge present(
            StateKnowledge built,
            @Nullable ConverterJournal journal,
            @Nullable Function<ModelPair, ? extends StateKnowledge> factory) {
        ModelPair evolved = journal == null ? null : journal.evolvedFrom(built.models());
        if (evolved == null) {
            return built;
        }
        StateKnowledge present = knowledgeOf(evolved, factory);
        ownership.take(present, present.name());
        return present;
    }

    /** @throws IllegalStateException if there is no factory */
    static StateKnowledge knowledgeOf(
            ModelPair models, @Nullable Function<ModelPair, ? extends StateKnowledge> factory) {
        if (factory == null) {
            throw new IllegalStateException("there is no knowledge factory for the models '"
                    + models.original().name() + "' and '" + models.evolved().name()
                    + "'; call addKnowledgeFactory");
        }
        return factory.apply(models);
    }

    /**
     * Checks everything, and gives every component its thread.
     *
     * @param evolved whether the models differ from those for which the code was written
     * @param shell makes the shell from the decisions
     */
    ConverterShell build(StateKnowledge known, boolean evolved, Function<DecisionTable, ConverterShell> shell) {
        DecisionTable table = assembly.compile(known, !evolved);
        ConverterShell built = shell.apply(table);
        built.use(table, assembly);
        for (Component component : assembly.all()) {
            built.join(component);
        }
        built.loop().build();
        return built;
    }
}
