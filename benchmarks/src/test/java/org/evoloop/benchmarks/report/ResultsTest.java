package org.evoloop.benchmarks.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ResultsTest {
    @TempDir
    Path directory;

    @Test
    void whatIsWrittenCanBeReadAgain() throws IOException {
        Map<String, Double> peers = new LinkedHashMap<>();
        peers.put("slow", 70.5);
        peers.put("a \"quick\" one", 2.0);
        Results results = new Results(
                new Origin("JDK 17, \\ 2 processors", "abc1234-dirty", "2026-01-02"),
                List.of(
                        new Row("a decision", "ns", 9.25, Row.Goal.atMostTimes(0.4, "slow", 70.5), peers),
                        new Row("a flood", "events/s", 1e6, Row.Goal.least(5e5))));
        Path file = Files.writeString(directory.resolve("results.json"), results.json());

        Results read = Results.read(file);

        assertThat(read).isEqualTo(results);
        assertThat(read.rows().get(0).peers().keySet()).containsExactly("slow", "a \"quick\" one");
    }

    @Test
    void namesTheFileThatIsSomethingElse() throws IOException {
        Path text = Files.writeString(directory.resolve("notes.txt"), "what | ours");
        Path other = Files.writeString(directory.resolve("other.json"), "{\"rows\": [{\"what\": \"it\"}]}");

        assertThatIllegalArgumentException()
                .isThrownBy(() -> Results.read(text))
                .withMessageContaining("notes.txt is not what ./evoloop bench --json writes");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Results.read(other))
                .withMessageContaining("other.json is not what ./evoloop bench --json writes")
                .withMessageContaining("unit");
    }

    @Test
    void namesTheFileThatIsNotThere() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Results.read(directory.resolve("missing.json")))
                .withMessageContaining("missing.json cannot be read");
    }
}
