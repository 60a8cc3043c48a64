package org.evoloop.benchmarks.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.evoloop.benchmarks.drawing.SoakPlot;
import org.evoloop.benchmarks.report.SoakResults;
import org.evoloop.benchmarks.report.SoakSample;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SoakTest {

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void everyEventIsHandledAndKept(boolean threads, @TempDir Path journal) throws Exception {
        List<SoakSample> samples = new Soak(journal, threads).run(1000, 8);

        assertThat(samples)
                .extracting(SoakSample::events)
                .containsExactly(125L, 250L, 375L, 500L, 625L, 750L, 875L, 1000L);
        assertThat(samples).allMatch(sample -> sample.heapMegabytes() > 0 && sample.diskMegabytes() > 0);
    }

    private static SoakSample sample(int number, double heap, int threads) {
        return new SoakSample(number * 1000L, number, heap, threads, 14, 16, 3, 20, 90);
    }

    private static SoakResults results(double perSample) {
        return new SoakResults(
                "a machine",
                "abc",
                "2026-11-23",
                java.util.stream.IntStream.rangeClosed(1, 16)
                        .mapToObj(number -> sample(number, 9 + number % 2 + number * perSample, 9))
                        .toList());
    }

    @Test
    void reportsWhatHasGrown() {
        assertThat(results(0).grown()).isEmpty();
        assertThat(results(0.5).grown()).containsExactly("heap after a collection, in MB: from 12.0 to 17.0");
    }

    @Test
    void isDrawnAndWritten() {
        assertThat(SoakPlot.svg(results(0)))
                .startsWith("<svg ")
                .contains("16,000 events with a journal, in 16 s")
                .contains("commit abc");
        assertThat(results(0).json()).contains("\"heapMegabytes\"").contains("\"machine\" : \"a machine\"");
    }
}
