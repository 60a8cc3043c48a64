package org.evoloop.check.timing;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import org.evoloop.check.CheckInput;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;

/**
 * What the check before it runs says, said by Storm of models that were made for it by other code: ./evoloop test
 * --oracles.
 */
@Tag("slow")
@EnabledIfEnvironmentVariable(named = "EVOLOOP_ORACLES", matches = ".+")
class StormOracleTest {
    private static final int MODELS = 400;

    @TempDir
    private Path directory;

    @Test
    void stormSaysTheSame() throws IOException, InterruptedException {
        long seed = Optional.ofNullable(System.getenv("EVOLOOP_SEED"))
                .map(Long::parseLong)
                .orElseGet(() -> new Random().nextLong() >>> 32);
        Map<String, Boolean> ours = new LinkedHashMap<>();
        for (long each = seed; ours.size() < MODELS; each++) {
            Optional<RandomTiming> timing = RandomTiming.of(each);
            if (timing.isPresent()) {
                RandomTiming made = timing.get();
                TimeReport report =
                        TimeCheck.run(CheckInput.of(made.pair()), made.file().time(), "random");
                ours.put(String.valueOf(each), report.verdicts().get(0).holds());
                Files.writeString(directory.resolve(each + ".prism"), PrismText.of(made));
            }
        }
        assertThat(ours.values()).as("some hold and some do not").contains(true, false);
        assertThat(storm()).as("from seed %d on", seed).containsExactlyInAnyOrderEntriesOf(ours);
    }

    private Map<String, Boolean> storm() throws IOException, InterruptedException {
        Path root = Path.of(System.getProperty("evoloop.root"));
        Path answers = directory.resolve("answers");
        Process storm = new ProcessBuilder(
                        System.getenv("EVOLOOP_ORACLES"),
                        root.resolve("framework/check/oracles/storm.py").toString(),
                        directory.toString())
                .redirectOutput(answers.toFile())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        assertThat(storm.waitFor()).isZero();
        Map<String, Boolean> told = new TreeMap<>();
        Files.readAllLines(answers).forEach(line -> told.put(line.split(" ")[0], line.endsWith(" holds")));
        return told;
    }
}
