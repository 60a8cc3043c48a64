package org.evoloop.fleet;

import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.Callable;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Rollout;
import org.evoloop.fleet.wire.Topic;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Switches a share of a fleet to other models, or back. */
@Command(
        name = "rollout",
        description =
                "Switches a share of the fleet to other models. Repeat it with a greater share to include more; with"
                        + " --back all return to the old models. With too many failures it is rolled back automatically.",
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

    @Option(names = "--from", required = true, paramLabel = "VERSION", description = "The old models.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String from;

    @Option(names = "--to", required = true, paramLabel = "VERSION", description = "The new models.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String to;

    @Option(
            names = "--percent",
            paramLabel = "P",
            defaultValue = "1",
            description = "The share of the devices, at least that of before (default: 1).")
    private double percent;

    @Option(
            names = "--stop-percent",
            paramLabel = "P",
            defaultValue = "5",
            description = "Roll back if a greater share of results are failures or divergences (default: 5).")
    private double stopPercent;

    @Option(
            names = "--stop-after",
            paramLabel = "N",
            defaultValue = "20",
            description = "The number of results before it may be rolled back (default: 20).")
    private long stopAfter;

    @Option(
            names = "--map",
            paramLabel = "FILE",
            description = "The exceptions from mapping by name, as for ./evoloop models migrate.")
    private @Nullable Path mapping;

    @Option(names = "--back", description = "Rolls it back.")
    private boolean back;

    @Override
    public Integer call() throws InterruptedException {
        for (double share : new double[] {percent, stopPercent}) {
            if (!(share >= 0 && share <= 100)) {
                throw new IllegalArgumentException("a share is " + share + " %, allowed is 0 to 100");
            }
        }
        ClusterOptions.requireName("the rollout's name", rollout);
        Path file = mapping;
        String text = file == null ? "" : ClusterOptions.text(file);
        if (from.equals(to)) {
            throw new IllegalArgumentException("--from and --to are both " + from + "; give the new models to --to");
        }
        Model one = cluster.requireModels(from);
        Model other = cluster.requireModels(to);
        Map<String, byte[]> published = cluster.last(Topic.ROLLOUTS);
        Rollout before = read(rollout, published.get(rollout));
        Rollout written = back
                ? requirePresent(before).stoppedBecause("by hand")
                : new Rollout(rollout, from, to, percent, text, stopPercent, stopAfter, "");
        requireSameDevices(before, written);
        published.forEach((name, record) -> requireNotOpposite(name, record, written));
        // A mapping that does not fit is reported here, not only in an instance's log.
        written.takeover(one, other);
        cluster.write(Topic.ROLLOUTS, Map.of(rollout, written.bytes()));
        spec.commandLine().getOut().println("the rollout " + rollout + " is written");
        return 0;
    }

    /** Null if there is none, or it is unusable; the instances ignore it then, too. */
    private static @Nullable Rollout read(String name, byte @Nullable [] record) {
        try {
            return record == null ? null : Rollout.read(name, record);
        } catch (Refusal unusable) {
            return null;
        }
    }

    private Rollout requirePresent(@Nullable Rollout before) {
        if (before == null) {
            throw new FleetException("there is no rollout " + rollout + " in the fleet '" + cluster.fleet() + "'");
        }
        return before;
    }

    /** Devices that already have the new models would otherwise be left out when the rollout is rolled back. */
    private void requireSameDevices(@Nullable Rollout before, Rollout next) {
        if (before == null) {
            return;
        } else if (!before.from().equals(from) || !before.to().equals(to)) {
            throw new FleetException("the rollout " + rollout + " is from " + before.from() + " to " + before.to()
                    + "; take another name for one from " + from + " to " + to);
        } else if (before.isRolling() && next.percent() < before.percent()) {
            throw new FleetException(
                    "the rollout " + rollout + " includes " + before.percent() + " % of the devices already, more than "
                            + next.percent() + " %; only --back makes devices return");
        }
    }

    /** Two rollouts in opposite directions would switch their devices with every event. */
    private void requireNotOpposite(String name, byte[] record, Rollout next) {
        Rollout present = read(name, record);
        if (present != null
                && !name.equals(rollout)
                && present.leaves().equals(next.reaches())
                && present.reaches().equals(next.leaves())) {
            throw new FleetException("the rollout " + name + " switches devices from " + present.leaves() + " to "
                    + present.reaches() + ", so they would switch back and forth; repeat that rollout instead"
                    + (present.isRolling() ? ", with --back" : ""));
        }
    }
}
