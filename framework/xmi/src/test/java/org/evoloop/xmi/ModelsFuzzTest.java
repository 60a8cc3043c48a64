package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever a model file contains, it is read or refused with a message. CONTRIBUTING.md says how to let Jazzer search
 * for more.
 */
@Timeout(30)
class ModelsFuzzTest {

    @MethodSource("seeds")
    @FuzzTest
    void aModelFileIsReadOrRefused(byte[] bytes) {
        try {
            for (XmiMachine machine : ModelFile.read("fuzzed.xml", new ByteArrayInputStream(bytes))
                    .machines()) {
                flatten(machine);
            }
        } catch (ModelException refused) {
            assertThat(refused).hasMessageStartingWith("fuzzed.xml");
        }
    }

    private static void flatten(XmiMachine machine) {
        try {
            StateMachine flat = machine.toStateMachine();
            assertThat(flat.hasState(flat.initial())).isTrue();
        } catch (ModelException refused) {
            assertThat(refused.getMessage()).isNotBlank();
        }
    }

    /** A file in each dialect (Astah's, SCXML, UML 2, Mermaid, Markdown, PlantUML), and two in none. */
    static List<byte[]> seeds() throws IOException {
        Path root = Path.of(System.getProperty("evoloop.root"));
        List<byte[]> seeds = new ArrayList<>();
        try (Stream<Path> models = Files.list(root.resolve("models"));
                Stream<Path> samples = Files.list(root.resolve("framework/models/src/test/resources/samples"))) {
            for (Path file : Stream.concat(models, samples).sorted().toList()) {
                if (file.toString().matches(".*\\.(xml|xmi|uml|scxml|md|mmd)")) {
                    seeds.add(Files.readAllBytes(file));
                }
            }
        }
        seeds.add(
                ("@startuml\n[*] -> A\nstate \"Big\" as A #red {\nstate in <<entryPoint>>\nin --> B\n--\n[H] --> C : e [g] / f, h\n}"
                                + "\nA -up-> A[H*] : tm(2s) {local}\nA : entry / x\\ny / defer\n@enduml\n")
                        .getBytes(StandardCharsets.UTF_8));
        seeds.add("<html/>".getBytes(StandardCharsets.UTF_8));
        seeds.add(new byte[] {'P', 'K', 3, 4});
        return seeds;
    }
}
