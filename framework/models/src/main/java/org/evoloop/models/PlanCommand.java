package org.evoloop.models;

import java.util.concurrent.Callable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.evolution.EvolutionPlan;
import org.evoloop.models.evolution.PlanJson;
import org.evoloop.models.evolution.PlanText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** What the converter will do. */
@Command(
        name = "plan",
        description =
                "Says how each transition of the new model comes about, in each pair of states that can be reached.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class PlanCommand implements Callable<Integer> {
    /** How a plan can be told. */
    enum Format {
        TEXT,
        JSON
    }

    @Spec
    private CommandSpec spec;

    @Mixin
    private PairOptions options;

    @Option(
            names = "--format",
            defaultValue = "TEXT",
            description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private Format format;

    @Override
    public Integer call() {
        ModelPair pair = options.read();
        pair.requireValid();
        EvolutionPlan plan = EvolutionPlan.of(pair, options.device(pair.original()));
        return Output.print(spec, format == Format.JSON ? PlanJson.write(plan) : PlanText.write(plan));
    }
}
