package org.evoloop.models;

import java.time.ZoneId;
import java.util.concurrent.Callable;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.DryRun;
import org.evoloop.models.record.ReplayDiagram;
import org.evoloop.models.record.ReplayJson;
import org.evoloop.models.record.ReplayText;
import org.evoloop.xmi.ModelReference;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Replays a journal's events on other models. */
@Command(
        name = "replay",
        description = "Gives the converter's inputs to other models, and lists each event that these would have handled"
                + " differently, with its outcome then and now.",
        footer = {"", "Exit status: 1 if a property of the other models is broken, or the journal is damaged."},
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class JournalReplayCommand implements Callable<Integer> {
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
            description = "The model of the device: FILE#NAME.")
    private String original;

    @Option(
            names = "--new",
            required = true,
            paramLabel = "NEW",
            description = "The new model to try on the events: FILE#NAME.")
    private String evolved;

    @Option(
            names = "--format",
            defaultValue = "TEXT",
            description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private OutputFormat format;

    @Mixin
    private PropertiesFile properties;

    @Override
    public Integer call() throws Exception {
        ModelReference tried = reading.reference(evolved);
        ModelPair pair = ModelReader.pair(reading.reference(original), tried, spec);
        pair.requireValid();
        PropertyFile file = properties.read(tried, pair);
        return journal.examine(spec, files -> {
            DryRun.Result result = DryRun.of(files, pair, file.properties());
            ZoneId zone = ZoneId.systemDefault();
            Output.print(
                    spec,
                    switch (format) {
                        case TEXT -> ReplayText.write(result, file, zone);
                        case JSON -> ReplayJson.write(result, file);
                        case SVG -> ReplayDiagram.write(pair, result, file, zone);
                    });
            return result.broken().isEmpty() ? ExitCode.OK : ExitCode.SOFTWARE;
        });
    }
}
