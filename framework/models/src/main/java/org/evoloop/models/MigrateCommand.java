package org.evoloop.models;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.migration.Mapping;
import org.evoloop.migration.Migration;
import org.evoloop.models.evolution.MigrationDiagram;
import org.evoloop.models.evolution.MigrationJson;
import org.evoloop.models.evolution.MigrationText;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Shows what a swap of models would do. */
@Command(
        name = "migrate",
        description = "Shows what becomes of each pair of states when another new model replaces the running one.",
        footer = {"", "Exit status: 1 if a swap is impossible in a pair of states."},
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class MigrateCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Mixin
    private ReadingOptions reading;

    @Mixin
    private DeviceOptions device;

    @Parameters(index = "0", paramLabel = "OLD_NEW", description = "The new model that is running: FILE#NAME.")
    private String running;

    @Parameters(index = "1", paramLabel = "NEW_NEW", description = "The new model that will replace it: FILE#NAME.")
    private String next;

    @Option(
            names = "--original",
            required = true,
            paramLabel = "ORIGINAL",
            description = "The model of the device: FILE#NAME.")
    private String original;

    @Option(
            names = "--to-original",
            paramLabel = "ORIGINAL",
            description = "The next model of the device: FILE#NAME (default: the same).")
    private @Nullable String nextOriginal;

    @Option(
            names = "--mapping",
            paramLabel = "FILE",
            description = "Rules for states, timers and functions whose names differ.")
    private @Nullable Path mapping;

    @Option(
            names = "--format",
            defaultValue = "TEXT",
            description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private OutputFormat format;

    @Override
    public Integer call() throws IOException {
        ModelPair before = pair(original, running);
        ModelPair after = pair(nextOriginal == null ? original : nextOriginal, next);
        DecisionTable table = DecisionTable.compile(before, device.of(before.original(), after.original()));
        DecisionTable nextTable = DecisionTable.compile(after, device.of(after.original(), before.original()));
        Mapping read = mapping == null
                ? Mapping.byName()
                : Mapping.parse(mapping.toString(), TextFile.read(mapping, "rules"), before, after);
        Migration migration = Migration.plan(table, nextTable, read);
        Output.print(
                spec,
                switch (format) {
                    case TEXT -> MigrationText.write(before, after, migration);
                    case JSON -> MigrationJson.write(before, after, migration);
                    case SVG -> MigrationDiagram.write(before, after, migration);
                });
        return migration.isPossible() ? 0 : 1;
    }

    private ModelPair pair(String device, String system) {
        ModelReference first = reading.reference(device);
        ModelPair pair = ModelReader.pair(first, reading.reference(system), spec);
        pair.requireValid();
        return pair;
    }
}
