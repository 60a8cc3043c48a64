package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What {@code check} reports about time. */
class TimeCommandTest {
    private static final String KNOWN = """
            takes Spot 1 s .. 2 s
            at least 3 s between presses
            arriveSpot comes 1 s .. 60 s after function Move
            """;

    @TempDir
    private Path directory;

    private Tool check(String properties, String... options) throws IOException {
        Path file = Files.writeString(directory.resolve("robot.properties.txt"), properties);
        List<String> arguments = new ArrayList<>(List.of(
                "check",
                Tool.ROBOT + "#original",
                Tool.ROBOT + "#new",
                "--spontaneous",
                "endSpot",
                "--properties",
                file.toString()));
        arguments.addAll(List.of(options));
        return Tool.run(arguments.toArray(String[]::new));
    }

    @Test
    void aPropertyThatHoldsIsReportedWithItsTimes() throws IOException {
        Tool result = check(KNOWN + "In time: Move never longer than 62 s\n");

        assertThat(result.err()).isEmpty();
        assertThat(result.status()).isZero();
        assertThat(result.out()).contains("time: 'In time' holds: 2 s at best, 62 s at worst\n");
    }

    @Test
    void aViolationIsReportedWithTheShortestPath() throws IOException {
        Tool result = check(KNOWN + "In time: Move never longer than 61 s\n");

        assertThat(result.status()).isEqualTo(1);
        assertThat(result.out())
                .contains("error: property: 'In time' (" + directory.resolve("robot.properties.txt")
                        + ", line 4) does not hold")
                .contains("  way:  at 0 s start -> (Off, Off); at 0 s Clean -> (On, On); at 3 s Spot -> (On, Move); "
                        + "at 63 s arriveSpot -> (On, Move), sending Spot; at 64 s 'In time' is violated\n")
                .contains("time: 'In time' does not hold: 2 s at best, 62 s at worst\n");
    }

    @Test
    void programsGetTheSame() throws IOException {
        JsonNode result = JsonMapper.shared()
                .readTree(check(KNOWN + "In time: Move never longer than 61 s\n", "--format", "json")
                        .out());

        assertThat(result.get("times").get(0).get("worstNanos").asLong()).isEqualTo(62_000_000_000L);
        JsonNode timed =
                result.get("findings").get(result.get("findings").size() - 1).get("timed");
        assertThat(timed.get(3).get("what").asString()).isEqualTo("arriveSpot");
        assertThat(timed.get(3).get("atNanos").asLong()).isEqualTo(63_000_000_000L);
        assertThat(timed.get(3).get("sending").asString()).isEqualTo("Spot");
    }

    @Test
    void aViolationIsDrawnAsATimingDiagram() throws IOException {
        String picture = check(KNOWN + "In time: Move never longer than 61 s\n", "--format", "svg")
                .out();

        assertThat(picture).contains("class=\"timing\"", "class=\"lifeline\"", ">new model</text>", ">63 s</text>");
    }

    @Test
    void whatIsTooLargeIsRefusedWithTheFigure() throws IOException {
        Tool result = check("takes Spot 1 ms .. 1 h\ntakes Clean 1 ms .. 1 h\nIn time: Move never longer than 1 h\n");

        assertThat(result.status()).isEqualTo(2);
        assertThat(result.out()).as("the other rules are checked").contains("swallowed-event");
        assertThat(result.err())
                .hasLineCount(1)
                .contains(
                        "line 3: 'In time' cannot be decided: there are more than ",
                        " in ticks of 1 ms; write lengths");
    }
}
