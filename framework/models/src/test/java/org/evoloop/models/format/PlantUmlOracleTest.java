package org.evoloop.models.format;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.LongStream;
import org.evoloop.models.diagram.RandomChart;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;

/**
 * PlantUML itself sees the states and transitions that this project writes, and those that it reads: ./evoloop test
 * --oracles.
 */
@Tag("slow")
@EnabledIfEnvironmentVariable(named = "EVOLOOP_PLANTUML", matches = ".+")
class PlantUmlOracleTest {
    private static final int DIAGRAMS = 500;
    private static final Pattern TRANSITION = Pattern.compile("\\s*(\\S+) --> (\\S+)(?: : (.*))?");
    private static final Pattern STATE = Pattern.compile("\\s*state (?:\".*\" as )?(v\\d+)(?: <<(.*)>>)?( \\{)?");
    private static final Map<String, String> NAMELESS =
            Map.of("start", "[*]", "end", "[*]", "history", "[H]", "history*", "[H*]");
    private static final String END = "====";

    @TempDir
    private Path directory;

    @Test
    void plantUmlSeesWhatIsWritten() throws IOException, InterruptedException {
        List<String> texts = new ArrayList<>();
        texts.add(PlantUml.write(List.of(WholeChart.CHART)));
        LongStream.range(0, DIAGRAMS).forEach(seed -> texts.add(PlantUml.write(List.of(RandomChart.of(seed)))));

        List<List<String>> theirs = judge(texts);

        assertThat(theirs).hasSameSizeAs(texts);
        for (int i = 0; i < texts.size(); i++) {
            assertThat(theirs.get(i)).as(texts.get(i)).containsExactlyInAnyOrderElementsOf(written(texts.get(i)));
        }
    }

    @Test
    void whatIsReadIsWhatPlantUmlSees() throws IOException, InterruptedException {
        long seed = Optional.ofNullable(System.getenv("EVOLOOP_SEED"))
                .map(Long::parseLong)
                .orElseGet(() -> new Random().nextLong());
        Random random = new Random(seed);
        List<String> texts = new ArrayList<>();
        List<List<String>> ours = new ArrayList<>();
        while (texts.size() < DIAGRAMS) {
            String text = RandomPlantUml.draw(random);
            try {
                ours.add(PlantUmlFacts.of(
                        ModelFile.read("F.puml", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)))
                                .findOnly()
                                .statechart()));
                texts.add(text);
            } catch (ModelException refused) {
                assertThat(refused).hasMessageStartingWith("F.puml: ");
            }
        }

        List<List<String>> theirs = judge(texts);

        int compared = 0;
        for (int i = 0; i < texts.size(); i++) {
            // PlantUML refuses an id in a region that another region has named.
            if (!theirs.get(i).toString().startsWith("[refused")) {
                compared++;
                assertThat(theirs.get(i))
                        .as("seed %d: %s", seed, texts.get(i))
                        .containsExactlyInAnyOrderElementsOf(ours.get(i));
            }
        }
        assertThat(compared).isGreaterThan(DIAGRAMS / 2);
    }

    /** What the lines of a text say that {@link PlantUml} wrote. */
    private static List<String> written(String text) {
        List<String> facts = new ArrayList<>();
        Map<String, String> ids = new HashMap<>();
        Deque<String> open = new ArrayDeque<>();
        for (String line : text.lines().toList()) {
            Matcher state = STATE.matcher(line);
            if (state.matches()) {
                String id = state.group(1);
                ids.put(id, NAMELESS.getOrDefault(String.valueOf(state.group(2)), id));
                if (id.equals(ids.get(id))) {
                    facts.add("state " + id + " " + (open.isEmpty() ? "-" : open.peek()));
                }
                if (state.group(3) != null) {
                    open.push(id);
                }
            } else if (line.strip().equals("}")) {
                open.pop();
            }
        }
        for (String line : text.lines().toList()) {
            Matcher arrow = TRANSITION.matcher(line);
            if (arrow.matches()) {
                String label =
                        arrow.group(3) == null ? "" : " : " + arrow.group(3).replace("\\n", " ");
                facts.add("edge " + ids.get(arrow.group(1)) + " " + ids.get(arrow.group(2)) + label);
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
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getenv("EVOLOOP_PLANTUML"),
                        root.resolve("framework/models/oracles/PlantUml.java").toString(),
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
