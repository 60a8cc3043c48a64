package org.evoloop.models;

import java.time.ZoneId;
import java.util.concurrent.Callable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.DryRun;
import org.evoloop.models.record.ReplayJson;
import org.evoloop.models.record.ReplayText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** A journal's events, told to other models. */
@Command(
        name = "replay",
        description =
                "Tells other models what the converter was told, and lists where they would have decided otherwise: what"
                        + " became of the event then, and what would have.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class JournalReplayCommand implements Callable<Integer> {
    /** How differences can be told. */
    enum Format {
        TEXT,
        JSON
    }

    @Spec
    private CommandSpec spec;

    @Mixin
    private JournalDirectory journal;

    @Mixin
    private ReadingOptions reading;

    @Option(
            names = "--original",
            required = true,
            paramLabel = "ORIGINAL",
            description = "What the device does: FILE#NAME.")
    private String original;

    @Option(
            names = "--new",
            required = true,
            paramLabel = "NEW",
            description = "The new model that is tried on the events: FILE#NAME.")
    private String evolved;

    @Option(
            names = "--format",
            defaultValue = "TEXT",
            description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private Format format;

    @Override
    public Integer call() throws Exception {
        ModelPair pair = ModelReader.pair(reading.reference(original), reading.reference(evolved), spec);
        return journal.examine(spec, files -> {
            DryRun.Result result = DryRun.of(files, pair);
            return Output.print(
                    spec,
                    format == Format.JSON
                            ? ReplayJson.write(result)
                            : ReplayText.write(result, ZoneId.systemDefault()));
        });
    }
}
