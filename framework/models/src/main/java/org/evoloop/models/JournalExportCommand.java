package org.evoloop.models;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.SQLException;
import java.util.List;
import java.util.concurrent.Callable;
import org.evoloop.journal.JournalException;
import org.evoloop.journal.JournalFiles;
import org.evoloop.journal.JournalFiles.SegmentInfo;
import org.evoloop.models.record.RecordJson;
import org.evoloop.models.record.RecordTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;

/** Exports a journal for other programs. */
@Command(
        name = "export",
        description =
                "Writes all records into a file for other programs: a JSON document, or an SQLite database with the tables"
                        + " segment and record.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class JournalExportCommand implements Callable<Integer> {
    /** The output formats. */
    enum Format {
        JSON,
        SQLITE
    }

    @Spec
    private CommandSpec spec;

    @Mixin
    private JournalDirectory journal;

    @Option(names = "--format", required = true, description = "One of ${COMPLETION-CANDIDATES}.")
    private Format format;

    @Option(names = "--output", required = true, paramLabel = "FILE", description = "A file that does not exist yet.")
    private Path output;

    @Override
    public Integer call() throws Exception {
        return journal.examine(spec, this::export);
    }

    private int export(JournalFiles files) throws IOException, SQLException {
        if (Files.exists(output)) {
            throw new IllegalArgumentException(output + " exists; delete it, or name another file");
        }
        Path folder = output.toAbsolutePath().resolveSibling("");
        if (!Files.isDirectory(folder)) {
            throw new IllegalArgumentException(output + " cannot be written: " + folder + " is not a directory");
        }
        try {
            if (format == Format.JSON) {
                writeJson(files);
            } else {
                writeTable(files);
            }
            return 0;
        } catch (UncheckedSql e) {
            Files.deleteIfExists(output);
            throw cannotBeWritten(e.failure);
        } catch (SQLException | IOException | JacksonException e) {
            Files.deleteIfExists(output);
            throw cannotBeWritten(e);
        } catch (JournalException e) {
            Files.deleteIfExists(output);
            throw e;
        }
    }

    private IllegalArgumentException cannotBeWritten(Exception why) {
        return new IllegalArgumentException(
                output + " cannot be written: " + why.getMessage() + "; name a file in a directory with free space",
                why);
    }

    /** One record or segment a line. */
    private void writeJson(JournalFiles files) throws IOException {
        try (Writer to = Files.newBufferedWriter(output, StandardCharsets.US_ASCII);
                JsonGenerator json = new JsonFactory().createGenerator(ObjectWriteContext.empty(), to)) {
            json.writeStartObject();
            json.writeArrayPropertyStart("records");
            List<SegmentInfo> segments = files.read(each -> json.writeRawValue("\n" + RecordJson.line(each)));
            json.writeRaw('\n').writeEndArray();
            json.writeArrayPropertyStart("segments");
            segments.forEach(each -> json.writeRawValue("\n" + RecordJson.line(each)));
            json.writeRaw('\n').writeEndArray();
            json.writeEndObject().writeRaw('\n');
        }
    }

    private void writeTable(JournalFiles files) throws SQLException {
        // Some names, such as :memory:, do not name a file; an absolute path always does.
        try (RecordTable table = new RecordTable(output.toAbsolutePath().toString())) {
            List<SegmentInfo> segments = files.read(each -> {
                try {
                    table.add(each);
                } catch (SQLException e) {
                    throw new UncheckedSql(e);
                }
            });
            for (SegmentInfo segment : segments) {
                table.add(segment);
            }
            table.commit();
        }
    }

    /** Carries an SQLException out of the callback that reads records, which cannot throw it. */
    private static final class UncheckedSql extends RuntimeException {
        private final SQLException failure;

        UncheckedSql(SQLException failure) {
            super(failure);
            this.failure = failure;
        }
    }
}
