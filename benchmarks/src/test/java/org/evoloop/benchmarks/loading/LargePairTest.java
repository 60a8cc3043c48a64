package org.evoloop.benchmarks.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LargePairTest {
    private static Row row(double ours) {
        return LargePair.row(Figures.parse("large " + ours + "\nstax 30\nlarge clock 150\n"));
    }

    @Test
    void isHeldAgainstTheParseOfTheSameFiles() {
        Row row = row(90);

        assertThat(row.goal().isRatio()).isTrue();
        assertThat(row.goal().ratio(row.ours())).isEqualTo(3);
        assertThat(row.reached()).isTrue();
        assertThat(row.peers()).containsEntry("by the clock, with the collector", 150.0);
        assertThat(row(91).reached()).isFalse();
    }

    @Test
    void theParseReadsEveryNameAndEveryValue(@TempDir Path directory) throws IOException {
        Path file = Files.writeString(directory.resolve("a.xml"), "<ab c=\"def\"><!-- no --><g/>text</ab>");

        assertThat(ParseStax.characters(file)).isEqualTo(2 + 1 + 3 + 1);
    }
}
