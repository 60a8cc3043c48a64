package org.evoloop.fleet;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.Callable;
import org.evoloop.fleet.wire.Rollout;
import org.evoloop.fleet.wire.Topic;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Has other models take over in a share of a fleet, or leads back. */
@Command(
        name = "rollout",
        description =
                "Rolls other models out to a share of the fleet. Repeat it with a larger share to continue; --back "
                        + "returns all devices to the previous models. It stops and rolls back by itself if too much "
                        + "goes wrong.",
        mixinStandardHelpOptions = true,
        sortOptions = false)
final class RolloutCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ClusterOptions cluster;

    @Parameters(index = "0", paramLabel = "ROLLOUT", description = "The rollout's name.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String rollout;

    @Option(names = "--from", required = true, paramLabel = "VERSION", description = "The version to replace.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String from;

    @Option(names = "--to", required = true, paramLabel = "VERSION", description = "The models that take over.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String to;

    @Option(
            names = "--percent",
            paramLabel = "P",
            defaultValue = "1",
            description = "The share of the devices, in " + "percent (default: 1).")
    private double percent;

    @Option(
            names = "--stop-percent",
            paramLabel = "P",
            defaultValue = "5",
            description = "It stops if more than this percentage of the events there are failures or divergences "
                    + "(default: 5).")
    private double stopPercent;

    @Option(
            names = "--stop-after",
            paramLabel = "N",
            defaultValue = "20",
            description = "How many events it counts there before it may stop (default: 20).")
    private long stopAfter;

    @Option(
            names = "--map",
            paramLabel = "FILE",
            description = "Mapping rules for names that differ, as for ./evoloop models migrate.")
    private @Nullable Path mapping;

    @Option(names = "--back", description = "Leads back.")
    private boolean back;

    @Override
    public Integer call() throws IOException, InterruptedException {
        for (double share : new double[] {percent, stopPercent}) {
            if (!(share >= 0 && share <= 100)) {
                throw new IllegalArgumentException("a share is " + share + " %, allowed is 0 to 100");
            }
        }
        Path file = mapping;
        String text = file == null ? "" : ClusterOptions.text(file);
        if (from.equals(to)) {
            throw new IllegalArgumentException("--from and --to are both " + from + "; name the models that take over");
        }
        Rollout written = new Rollout(rollout, from, to, percent, text, stopPercent, stopAfter, back ? "by hand" : "");
        // What cannot be led over is told here, and not only in the log of an instance.
        written.takeover(cluster.requireModels(from), cluster.requireModels(to));
        cluster.write(Topic.ROLLOUTS, Map.of(rollout, written.bytes()));
        spec.commandLine().getOut().println("the rollout " + rollout + " is written");
        return 0;
    }
}
