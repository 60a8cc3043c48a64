package org.evoloop.models.format;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.models.diagram.ChartDiagram;
import org.evoloop.models.diagram.SvgWriter;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Statechart;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Everything in a chart is in every format. {@code -Devoloop.samples=DIRECTORY} compares them for more files. */
class FormatsTest {
    private static final Pattern SVG_TEXT = Pattern.compile("<text[^>]*>([^<]*)</text>");

    static List<Statechart> samples() throws IOException {
        String root = System.getProperty("evoloop.root");
        List<Path> folders = new ArrayList<>();
        folders.add(Path.of(root, "models"));
        folders.add(Path.of(root, "framework", "models", "src", "test", "resources", "samples"));
        if (!System.getProperty("evoloop.samples", "").isEmpty()) {
            folders.add(Path.of(System.getProperty("evoloop.samples")));
        }
        List<Statechart> charts = new ArrayList<>(List.of(WholeChart.CHART));
        for (Path folder : folders) {
            try (Stream<Path> files = Files.walk(folder)) {
                files.filter(file -> file.toString().matches(".*\\.(xml|xmi|uml|scxml)"))
                        .sorted()
                        .forEach(file -> charts.addAll(charts(file)));
            }
        }
        return charts;
    }

    private static List<Statechart> charts(Path file) {
        List<Statechart> charts = new ArrayList<>();
        for (XmiMachine machine : ModelFile.read(file).machines()) {
            try {
                charts.add(machine.statechart());
            } catch (ModelException unusable) {
                assertThat(unusable).hasMessageContaining("state machine '");
            }
        }
        return charts;
    }

    private static String dense(String text) {
        return text.replaceAll("\\s", "");
    }

    /** A line break in a name would begin a line of the text. */
    private static List<String> inOneLine(List<String> facts) {
        return facts.stream().map(fact -> fact.replace('\n', '?')).toList();
    }

    private static void assertHolds(String format, String content, List<String> facts) {
        String dense = dense(content);
        assertThat(facts).as(format).allSatisfy(fact -> assertThat(dense).contains(dense(fact)));
    }

    @ParameterizedTest
    @MethodSource("samples")
    void everyTextIsInEveryFormat(Statechart chart) {
        ChartFacts facts = new ChartFacts(chart);
        List<Statechart> one = List.of(chart);
        String text = MachineText.write(one);
        String dot = Dot.write(one).replaceAll("\\\\n", "\n").replaceAll("\\\\(.)", "$1");
        String plantUml = PlantUml.write(one).replace("\\n", "\n").replace("<U+0022>", "\"");
        String json =
                strings(JsonMapper.shared().readTree(MachineJson.write(one))).collect(Collectors.joining("\n"));
        String svg = SVG_TEXT.matcher(SvgWriter.write("", List.of(ChartDiagram.of(chart))))
                .results()
                .map(match -> match.group(1))
                .collect(Collectors.joining("\n"))
                .replace("&lt;", "<")
                .replace("&gt;", ">")
                .replace("&quot;", "\"")
                .replace("&amp;", "&");

        assertHolds("text", text, inOneLine(facts.drawn));
        assertHolds("text", text, inOneLine(facts.declared));
        assertHolds("text", text, inOneLine(facts.regions));
        assertHolds("JSON", json, facts.drawn);
        assertHolds("JSON", json, facts.declared);
        assertHolds("JSON", json, facts.regions);
        assertHolds("DOT", dot, facts.drawn);
        assertHolds("DOT", dot, facts.regions);
        assertHolds("PlantUML", plantUml, facts.drawn);
        assertHolds("SVG", svg, facts.drawn);
    }

    private static Stream<String> strings(JsonNode node) {
        return node.isString() ? Stream.of(node.asString()) : node.valueStream().flatMap(FormatsTest::strings);
    }

    /** Every drawn arrow, including those that only start a region. */
    @ParameterizedTest
    @MethodSource("samples")
    void jsonHasEveryTransition(Statechart chart) {
        ChartIndex index = new ChartIndex(chart);
        JsonNode machine = JsonMapper.shared()
                .readTree(MachineJson.write(List.of(chart)))
                .get("machines")
                .get(0);
        List<List<String>> written = Stream.of("transitions", "initialTransitions")
                .flatMap(key -> machine.get(key).valueStream())
                .map(row -> Stream.of("source", "trigger", "guard", "effect", "target", "kind")
                        .map(key -> row.get(key).isNull() ? "" : row.get(key).asString())
                        .toList())
                .toList();

        assertThat(written)
                .containsExactlyInAnyOrderElementsOf(index.arcs().stream()
                        .flatMap(arc -> rows(arc, index).stream())
                        .toList());
    }

    private static List<List<String>> rows(Arc arc, ChartIndex index) {
        return (arc.triggers().isEmpty() ? List.of("") : arc.triggers())
                .stream()
                        .map(trigger -> List.of(
                                index.name(arc.source()),
                                trigger,
                                arc.guard(),
                                String.join("; ", arc.effects()),
                                index.name(arc.target()),
                                arc.kind().name().toLowerCase(Locale.ROOT)))
                        .toList();
    }
}
