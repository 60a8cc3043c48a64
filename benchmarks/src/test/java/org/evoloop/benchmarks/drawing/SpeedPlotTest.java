package org.evoloop.benchmarks.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.evoloop.benchmarks.report.Origin;
import org.evoloop.benchmarks.report.Results;
import org.evoloop.benchmarks.report.Row;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class SpeedPlotTest {
    private static final Origin ORIGIN = new Origin("JDK 17 & 2 processors", "abc1234", "2026-01-02");

    /** All stored results can be drawn; this fails if a row is renamed. */
    @Test
    void drawsEveryRunThatIsKept() throws Exception {
        Path kept = Path.of(System.getProperty("evoloop.root"), "benchmarks", "results");
        List<Path> drawn = new ArrayList<>();
        try (Stream<Path> files = Files.list(kept)) {
            for (Path file :
                    files.filter(name -> name.toString().endsWith(".json")).toList()) {
                Results results = Results.read(file);
                assertThat(texts(SpeedPlot.svg(results)))
                        .contains("Evoloop", "stateless4j", "LinkedTransferQueue")
                        .contains(results.origin().machine());
                drawn.add(file);
            }
        }
        assertThat(drawn).isNotEmpty();
    }

    @Test
    void putsTheQuickestFirstAndShowsTheGoals() throws Exception {
        List<String> texts = texts(SpeedPlot.svg(new Results(
                ORIGIN,
                List.of(
                        decision("a decision by the event's name", 20, 50),
                        decision("a decision among 10,000 states", 40, 2_000),
                        ring("the whole loop, 4 threads, median", 7, 6),
                        ring("the whole loop, 4 threads, 99th percentile", 9, 8)))));

        assertThat(texts)
                .containsSubsequence("Evoloop", "20.0 ns", "40.0 ns", "Other", "50.0 ns", "2.00 µs")
                .containsSubsequence("Bare", "6.00 µs", "8.00 µs", "Evoloop", "7.00 µs", "9.00 µs")
                .contains("goal, 6 states: 25.0 ns", "2026-01-02, commit abc1234", "JDK 17 & 2 processors");
    }

    @Test
    void namesTheRowThatIsMissing() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SpeedPlot.svg(new Results(ORIGIN, List.of())))
                .withMessageContaining("no row \"a decision by the event's name\"");
    }

    private static Row decision(String what, double ours, double other) {
        return new Row(what, "ns", ours, Row.Goal.atMostTimes(0.5, "Other", other), Map.of("Other", other));
    }

    private static Row ring(String what, double ours, double other) {
        return new Row(what, "us", ours, Row.Goal.atMostTimes(1.5, "Bare", other), Map.of("Bare", other));
    }

    private static List<String> texts(String svg) throws Exception {
        Element root = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)))
                .getDocumentElement();
        NodeList elements = root.getElementsByTagName("text");
        List<String> texts = new ArrayList<>();
        for (int index = 0; index < elements.getLength(); index++) {
            texts.add(elements.item(index).getTextContent());
        }
        return texts;
    }
}
