package org.evoloop.models;

import java.util.concurrent.Callable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.evolution.Bypass;
import org.evoloop.models.evolution.BypassJson;
import org.evoloop.models.evolution.BypassText;
import org.evoloop.models.evolution.EvolutionPlan;
import org.evoloop.models.evolution.PlanJson;
import org.evoloop.models.evolution.PlanText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Shows what the converter will do. */
@Command(
        name = "plan",
        description =
                "Shows how each transition of the new model will be carried out, in each reachable pair of states.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class PlanCommand implements Callable<Integer> {
    /** The output formats. */
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

    @Option(
            names = "--bypass",
            description = "Shows instead what the device does with the controller's events if they are passed on to it"
                    + " unchanged while the converter is down.")
    private boolean bypass;

    @Override
    public Integer call() {
        ModelPair pair = options.read();
        pair.requireValid();
        DeviceEvents device = options.device(pair);
        boolean json = format == Format.JSON;
        if (bypass) {
            Bypass described = Bypass.of(pair, device);
            return Output.print(spec, json ? BypassJson.write(described) : BypassText.write(described));
        }
        EvolutionPlan plan = EvolutionPlan.of(pair, device);
        return Output.print(spec, json ? PlanJson.write(plan) : PlanText.write(plan));
    }
}
