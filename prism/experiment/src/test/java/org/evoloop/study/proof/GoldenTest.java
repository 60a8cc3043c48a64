package org.evoloop.study.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/**
 * The code behaves as recorded in {@code prism/proof/golden}, with which {@code ./evoloop study --check} compares the
 * specification. If the core was changed on purpose, regenerate the files as described in {@code docs/proof.md}.
 */
class GoldenTest {
    private static final Path ROOT = Path.of(System.getProperty("evoloop.root"));
    private static final Path GOLDEN = ROOT.resolve("prism/proof/golden");

    private final ByteArrayOutputStream said = new ByteArrayOutputStream();

    static List<String> arguments(String pair) {
        String models = ROOT.resolve("models").toString();
        String fan = ROOT.resolve("prism/proof/fan").toString();
        if (pair.equals("fan")) {
            return List.of(
                    "--original=" + fan + "/original.scxml",
                    "--new=" + fan + "/new.scxml",
                    "--next=" + fan + "/original.scxml",
                    "--mapping=" + fan + "/mapping.txt",
                    "--sendable=power",
                    "--pressed=boost",
                    "--spontaneous=power",
                    "--timer=Boost=timeout");
        }
        if (pair.equals("lift")) {
            String lift = ROOT.resolve("prism/proof/lift").toString();
            return List.of(
                    "--original=" + lift + "/original.scxml",
                    "--new=" + lift + "/new.scxml",
                    "--next=" + lift + "/original.scxml",
                    "--mapping=" + lift + "/mapping.txt",
                    "--sendable=up,down",
                    "--pressed=express,fire",
                    "--spontaneous=down",
                    "--timer=Alarm=timeout",
                    "--queue=1");
        }
        return pair.equals("robot")
                ? List.of(
                        "--original=" + models + "/cleaning-robot.xml#original",
                        "--new=" + models + "/cleaning-robot.xml#new",
                        "--next=" + models + "/cleaning-robot-twice.scxml",
                        "--sendable=Clean,Spot",
                        "--spontaneous=endSpot,Clean,Spot",
                        "--timer=SpotWait=timeout")
                : List.of(
                        "--original=" + models + "/light-bulb.xml#original",
                        "--new=" + models + "/light-bulb.xml#new",
                        "--next=" + models + "/light-bulb.xml#original",
                        "--mapping=" + ROOT.resolve("prism/proof/light-bulb.mapping.txt"),
                        "--sendable=switch",
                        "--spontaneous=switch",
                        "--timer=wait=timeout");
    }

    private int run(List<String> arguments, String... more) {
        List<String> all = new ArrayList<>(arguments);
        all.addAll(List.of(more));
        PrintStream out = new PrintStream(said, true, StandardCharsets.UTF_8);
        return new CommandLine(new Main(out, out)).execute(all.toArray(String[]::new));
    }

    @ParameterizedTest
    @ValueSource(strings = {"robot", "bulb", "fan", "lift"})
    void theTablesAreThoseOfTheModelFiles(String pair) throws IOException {
        assertThat(run(arguments(pair))).isZero();

        assertThat(said.toString(StandardCharsets.UTF_8))
                .isEqualTo(Files.readString(GOLDEN.resolve(pair + ".tables.pml")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"robot", "bulb", "fan", "lift"})
    void theCoreDoesWhatItDid(String pair) throws IOException {
        assertThat(run(arguments(pair), "--traces=40", "--seed=1")).isZero();

        assertThat(said.toString(StandardCharsets.UTF_8))
                .isEqualTo(Files.readString(GOLDEN.resolve(pair + ".trace.txt")));
    }

    @Test
    void aModelThatIsNotThereIsOneMessage() {
        List<String> arguments = new ArrayList<>(arguments("robot"));
        arguments.set(1, "--new=" + ROOT.resolve("models/cleaning-robot.xml#nwe"));

        assertThat(run(arguments)).isEqualTo(2);
        assertThat(said.toString(StandardCharsets.UTF_8))
                .startsWith("error: ")
                .contains("nwe")
                .hasLineCount(1);
    }
}
