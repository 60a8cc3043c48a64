package org.evoloop.study.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/**
 * A journal contains exactly the core's inputs; {@code ./evoloop study --check} compares them with the specification.
 */
class RecordedTest {
    private static final Path GOLDEN = Path.of(System.getProperty("evoloop.root"), "prism", "proof", "golden");

    @TempDir
    private Path folder;

    private final ByteArrayOutputStream said = new ByteArrayOutputStream();

    private int run(String pair, String... more) {
        said.reset();
        List<String> all = new ArrayList<>(GoldenTest.arguments(pair));
        all.addAll(List.of(more));
        PrintStream out = new PrintStream(said, true, StandardCharsets.UTF_8);
        return new CommandLine(new Main(out, out)).execute(all.toArray(String[]::new));
    }

    private String said() {
        return said.toString(StandardCharsets.UTF_8);
    }

    /** The light bulb's program, with presses, timers and a kill -9 in between. */
    @Test
    void theKeptJournalIsReplayedAsItWas() throws IOException {
        assertThat(run("bulb", "--queue=8", "--journal=" + GOLDEN.resolve("bulb.journal")))
                .as(said())
                .isZero();

        assertThat(said()).isEqualTo(Files.readString(GOLDEN.resolve("bulb.recorded.txt")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"robot", "bulb"})
    void aRunOfTheWholeConverterIsRecordedInFull(String pair) {
        assertThat(run(pair, "--record=" + folder, "--traces=3", "--seed=7", "--length=150"))
                .as(said())
                .isZero();

        List<String> lines = said().lines().toList();
        assertThat(lines.stream().filter("> ANEW 0 0 0 0"::equals)).hasSize(3);
        assertThat(lines.stream().map(line -> line.split(" ")[1]).distinct())
                .contains("RECOVERED", "CLOSED", "FOUND_AT", "HEARD_OF", "PLANNED");
        assertThat(lines.stream().filter(line -> line.startsWith("= ")).count())
                .as("one state after each input")
                .isEqualTo(lines.stream().filter(line -> line.startsWith("> ")).count());
    }

    @Test
    void aJournalOfOtherModelsIsOneMessage() throws IOException {
        assertThat(run("robot", "--journal=" + GOLDEN.resolve("bulb.journal"))).isEqualTo(2);

        assertThat(said()).startsWith("error: ").contains("bulb.journal").hasLineCount(1);
    }

    @Test
    void whereItsBeginIsMissingItSaysSo() throws IOException {
        assertThat(run("bulb", "--record=" + folder, "--traces=1", "--seed=7", "--length=150"))
                .isZero();
        Path journal;
        try (Stream<Path> lives = Files.list(folder.resolve("run7"))) {
            journal = lives.max(Comparator.naturalOrder()).orElseThrow();
        }
        Files.delete(journal.resolve("0000000001.journal"));
        Files.createDirectory(journal.resolve("aside"));

        assertThat(run("bulb", "--journal=" + journal)).isEqualTo(2);
        assertThat(said()).contains("does not begin with its first record").hasLineCount(1);
    }

    @Test
    void noJournalIsOneMessage() {
        assertThat(run("bulb", "--journal=" + folder.resolve("nowhere"))).isEqualTo(2);
        assertThat(said()).contains("nowhere does not exist").hasLineCount(1);
    }
}
