package org.evoloop.benchmarks.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import tools.jackson.core.JacksonException;
import tools.jackson.core.util.DefaultIndenter;
import tools.jackson.core.util.DefaultPrettyPrinter;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.MapperFeature;
import tools.jackson.databind.ObjectWriter;
import tools.jackson.databind.json.JsonMapper;

/**
 * The results of a run as JSON: an object with the origin and an array of rows, one per line, so that two runs can be
 * compared line by line.
 *
 * <p>Threading: immutable.
 */
public record Results(Origin origin, List<Row> rows) {
    private static final JsonMapper MAPPER = JsonMapper.builder()
            .disable(MapperFeature.SORT_PROPERTIES_ALPHABETICALLY)
            .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
            .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
            .build();

    private static final ObjectWriter A_ROW_A_LINE = MAPPER.writer()
            .with(new DefaultPrettyPrinter()
                    .withObjectIndenter(DefaultPrettyPrinter.FixedSpaceIndenter.instance())
                    .withArrayIndenter(DefaultIndenter.SYSTEM_LINEFEED_INSTANCE.withLinefeed("\n")));

    /** The file. */
    record Document(String machine, String commit, String day, List<Line> rows) {}

    /** A row of the file. Derived values, such as the ratio, are also written. */
    record Line(
            String what,
            String unit,
            double ours,
            String against,
            double againstValue,
            double ratio,
            double bound,
            boolean atLeast,
            boolean reached,
            Map<String, Double> peers) {
        static Line of(Row row) {
            Row.Goal goal = row.goal();
            return new Line(
                    row.what(),
                    row.unit(),
                    row.ours(),
                    goal.name(),
                    goal.against(),
                    goal.ratio(row.ours()),
                    goal.bound(),
                    goal.atLeast(),
                    row.reached(),
                    row.peers());
        }

        Row row() {
            return new Row(what, unit, ours, new Row.Goal(against, againstValue, bound, atLeast), peers);
        }
    }

    public Results {
        rows = List.copyOf(rows);
    }

    /**
     * Reads the output of {@link #json}.
     *
     * @throws IllegalArgumentException if the file cannot be read or has other contents
     */
    public static Results read(Path file) {
        try {
            Document document = MAPPER.readValue(Files.readString(file), Document.class);
            return new Results(
                    new Origin(document.machine, document.commit, document.day),
                    document.rows.stream().map(Line::row).toList());
        } catch (IOException cause) {
            throw new IllegalArgumentException(
                    file + " cannot be read; name a file that ./evoloop bench --json has written", cause);
        } catch (JacksonException cause) {
            throw new IllegalArgumentException(
                    file + " is not what ./evoloop bench --json writes: " + cause.getOriginalMessage(), cause);
        }
    }

    /** The results as JSON. */
    public String json() {
        List<Line> lines = rows.stream().map(Line::of).toList();
        return A_ROW_A_LINE.writeValueAsString(new Document(origin.machine(), origin.commit(), origin.day(), lines))
                + "\n";
    }
}
