package org.evoloop.benchmarks.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * What a run has found, as JSON for programs: an object with the origin and an array of rows, a line each, so that two runs
 * can be compared line by line.
 *
 * <p>Threading: immutable.
 */
public record Results(Origin origin, List<Row> rows) {
    public Results {
        rows = List.copyOf(rows);
    }

    /**
     * Reads what {@link #json} has written.
     *
     * @throws IllegalArgumentException if the file cannot be read or is something else
     */
    public static Results read(Path file) {
        try {
            return parse(Files.readString(file));
        } catch (IOException cause) {
            throw new IllegalArgumentException(
                    file + " cannot be read; name a file that ./evoloop bench --json has written", cause);
        } catch (JacksonException cause) {
            throw new IllegalArgumentException(
                    file + " is not what ./evoloop bench --json writes: " + cause.getOriginalMessage(), cause);
        }
    }

    static Results parse(String text) {
        JsonNode root = JsonMapper.shared().readTree(text);
        List<Row> rows = new ArrayList<>();
        root.required("rows").forEach(row -> rows.add(row(row)));
        return new Results(new Origin(text(root, "machine"), text(root, "commit"), text(root, "day")), rows);
    }

    private static Row row(JsonNode row) {
        Map<String, Double> peers = new LinkedHashMap<>();
        row.required("peers").forEachEntry((name, value) -> peers.put(name, value.doubleValue()));
        Row.Goal goal = new Row.Goal(
                text(row, "against"),
                row.required("againstValue").doubleValue(),
                row.required("bound").doubleValue(),
                row.required("atLeast").booleanValue());
        return new Row(
                text(row, "what"), text(row, "unit"), row.required("ours").doubleValue(), goal, peers);
    }

    private static String text(JsonNode node, String field) {
        return node.required(field).stringValue();
    }

    /** The results as JSON; what follows from the rest, as the ratio, is written as well. */
    public String json() {
        String all = rows.stream().map(Results::json).collect(Collectors.joining(",\n    "));
        return "{\n  \"machine\": " + quote(origin.machine()) + ",\n  \"commit\": " + quote(origin.commit())
                + ",\n  \"day\": " + quote(origin.day()) + ",\n  \"rows\": [\n    " + all + "\n  ]\n}\n";
    }

    private static String json(Row row) {
        String peers = row.peers().entrySet().stream()
                .map(peer -> quote(peer.getKey()) + ": " + peer.getValue())
                .collect(Collectors.joining(", "));
        Row.Goal goal = row.goal();
        return "{\"what\": " + quote(row.what()) + ", \"unit\": " + quote(row.unit()) + ", \"ours\": " + row.ours()
                + ", \"against\": " + quote(goal.name()) + ", \"againstValue\": " + goal.against() + ", \"ratio\": "
                + goal.ratio(row.ours()) + ", \"bound\": " + goal.bound() + ", \"atLeast\": " + goal.atLeast()
                + ", \"reached\": " + row.reached() + ", \"peers\": {" + peers + "}}";
    }

    private static String quote(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}
