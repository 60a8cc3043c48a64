package org.evoloop.fleet;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Topic;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Publishes models to a fleet. */
@Command(
        name = "publish",
        description = {
            "Publishes a pair of models under a version, which cannot be changed later. They are checked first."
        },
        mixinStandardHelpOptions = true,
        sortOptions = false)
final class PublishCommand implements Callable<Integer> {
    private static final Pattern USE = Pattern.compile("(.+):(.+)");
    private static final Pattern TIMER = Pattern.compile("(.+):(.+):(\\d{1,12})");

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ClusterOptions cluster;

    @Parameters(index = "0", paramLabel = "VERSION", description = "The version, such as lamp-2.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String version;

    @Parameters(index = "1", paramLabel = "FILE", description = "A model file with both machines.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path file;

    @Option(
            names = "--original",
            paramLabel = "NAME",
            defaultValue = "original",
            description = "The name of the device's state machine in it.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String original;

    @Option(
            names = "--new",
            paramLabel = "NAME",
            defaultValue = "new",
            description = "The name of the wanted state machine in it.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String evolved;

    @Option(
            names = "--timer",
            paramLabel = "STATE:EVENT:MS",
            description =
                    "A state raises an event after MS milliseconds; in addition to the time triggers in the diagrams.")
    private List<String> timers = new ArrayList<>();

    @Option(
            names = "--device-state",
            paramLabel = "STATE:STATE",
            description =
                    "A new state needs the device in this one of its states; in addition to what the diagrams say.")
    private List<String> deviceStates = new ArrayList<>();

    @Option(
            names = "--sends",
            paramLabel = "STATE:EVENT",
            description = "The function of a new state may send this event; in addition to what the diagrams say.")
    private List<String> sends = new ArrayList<>();

    @Override
    public Integer call() throws InterruptedException {
        byte[] record = new ModelRecord(
                        String.valueOf(file.getFileName()),
                        ClusterOptions.text(file),
                        original,
                        evolved,
                        timers.stream().map(PublishCommand::timer).toList(),
                        uses(),
                        ModelRecord.QUEUE)
                .bytes();
        ModelRecord.read(version, record);
        byte[] before = cluster.models(version);
        if (before != null && !Arrays.equals(before, record)) {
            throw new FleetException("other models are published as " + version
                    + " already; a version cannot be changed, so use another for these");
        }
        cluster.write(Topic.MODELS, Map.of(version, record));
        spec.commandLine().getOut().println("the models " + version + " are published");
        return 0;
    }

    private List<ModelRecord.Use> uses() {
        List<ModelRecord.Use> uses = new ArrayList<>();
        for (String text : deviceStates) {
            Matcher parts = use("--device-state", text, "Gap:StopUp");
            uses.add(new ModelRecord.Use(parts.group(1), parts.group(2), List.of()));
        }
        for (String text : sends) {
            Matcher parts = use("--sends", text, "Soon:brew");
            uses.add(new ModelRecord.Use(parts.group(1), "", List.of(parts.group(2))));
        }
        return uses;
    }

    private static Matcher use(String option, String text, String example) {
        Matcher parts = USE.matcher(text);
        if (!parts.matches()) {
            throw new IllegalArgumentException(option + " is '" + text + "'; write two names, such as " + example);
        }
        return parts;
    }

    private static ModelRecord.Timer timer(String text) {
        Matcher parts = TIMER.matcher(text);
        if (!parts.matches()) {
            throw new IllegalArgumentException(
                    "--timer is '" + text + "'; write STATE:EVENT:MS, such as wait:timeout:2000");
        }
        return new ModelRecord.Timer(parts.group(1), parts.group(2), Long.parseLong(parts.group(3)));
    }
}
