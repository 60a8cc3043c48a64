package org.evoloop.xmi.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statechart.RandomChart;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelWriter;
import org.evoloop.xmi.dialect.DrawnChart;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;

/** Mermaid itself sees the states and transitions that this project writes: ./evoloop test --oracles. */
@Tag("slow")
@EnabledIfEnvironmentVariable(named = "EVOLOOP_MERMAID", matches = ".+")
class MermaidOracleTest {
    private static final int DIAGRAMS = 500;
    private static final Pattern TRANSITION = Pattern.compile("\\s*(\\S+) --> (\\S+)(?: : (.*))?");
    private static final String END = "====";

    /** Texts that Mermaid could misread. */
    private static final List<String> TEXTS = List.of(
            "a; b",
            "a: b",
            "a::b",
            "x < 1 && y > 2",
            "<b>bold</b>",
            "50% %% no comment",
            "#44; #x",
            "say \"hi\"",
            "it's",
            "a --> b",
            "{local} }",
            "[x] / y, z",
            "f(a, b)",
            "«keyword»",
            "点灯",
            "note",
            "end note",
            "back\\slash\\n");

    @TempDir
    private Path directory;

    @Test
    void mermaidSeesWhatIsWritten() throws IOException, InterruptedException {
        List<String> texts = new ArrayList<>();
        for (String text : TEXTS) {
            texts.add(ModelWriter.MERMAID.write(labelled(text)));
        }
        long seed = Optional.ofNullable(System.getenv("EVOLOOP_SEED"))
                .map(Long::parseLong)
                .orElseGet(() -> new Random().nextLong());
        Random random = new Random(seed);
        while (texts.size() < DIAGRAMS) {
            try {
                texts.add(ModelWriter.MERMAID.write(RandomChart.draw(random, 6)));
            } catch (ModelException unsayable) {
                assertThat(unsayable).hasMessageContaining("cannot be written in Mermaid");
            }
        }
        List<List<String>> theirs = judge(texts);
        assertThat(theirs).hasSameSizeAs(texts);
        for (int i = 0; i < texts.size(); i++) {
            assertThat(theirs.get(i))
                    .as("seed %d: %s", seed, texts.get(i))
                    .containsExactlyInAnyOrderElementsOf(ours(texts.get(i)));
        }
    }

    private static Statechart labelled(String text) {
        String escaped = Words.effect(text);
        return TextDiagrams.file(
                        "F.mmd",
                        "stateDiagram-v2\n[*] --> A\nstate \"" + Words.name(text) + "\" as A\nA : entry / " + escaped
                                + "\nA --> B : " + Words.trigger(text) + " / " + escaped + ", " + escaped + "\n")
                .findOnly()
                .statechart();
    }

    private static List<String> ours(String text) {
        List<String> facts = new ArrayList<>();
        DrawnChart chart =
                new DrawnChart(TextDiagrams.file("F.mmd", text).findOnly().statechart());
        for (Vertex vertex : chart.vertices()) {
            boolean named = vertex instanceof ChartState
                    || (vertex instanceof Pseudostate point
                            && point.kind() != Kind.INITIAL
                            && point.kind() != Kind.JUNCTION);
            if (named) {
                ChartState owner = Optional.ofNullable(chart.home(vertex.key()))
                        .map(chart::owner)
                        .orElse(null);
                facts.add("state " + vertex.key() + " " + (owner == null ? "-" : owner.key()));
            }
        }
        for (String line : text.lines().toList()) {
            Matcher transition = TRANSITION.matcher(line);
            if (transition.matches()) {
                String label = transition.group(3) == null ? "" : Escapes.decode(transition.group(3), Syntax.MERMAID);
                facts.add(("edge " + transition.group(1) + " " + transition.group(2) + " : " + label).strip());
            }
        }
        return facts;
    }

    private List<List<String>> judge(List<String> texts) throws IOException, InterruptedException {
        Path asked = Files.writeString(
                directory.resolve("diagrams"),
                String.join("", texts.stream().map(text -> text + END + "\n").toList()));
        Path answers = directory.resolve("answers");
        Path root = Path.of(System.getProperty("evoloop.root"));
        Process judge = new ProcessBuilder(
                        "node",
                        root.resolve("framework/xmi/oracles/mermaid.mjs").toString(),
                        System.getenv("EVOLOOP_MERMAID"),
                        asked.toString(),
                        answers.toString())
                .inheritIO()
                .start();
        assertThat(judge.waitFor()).isZero();
        List<List<String>> all = new ArrayList<>();
        List<String> facts = new ArrayList<>();
        for (String line : Files.readAllLines(answers)) {
            if (line.equals(END)) {
                all.add(facts);
                facts = new ArrayList<>();
            } else {
                facts.add(line);
            }
        }
        return all;
    }
}
