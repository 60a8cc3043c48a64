package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.evoloop.statechart.Flattening;
import org.evoloop.statechart.RandomChart;
import org.evoloop.statechart.Statechart;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A random chart that is written and read again has the same flat machine; what cannot be written is refused. */
class RoundTripTest {
    private static final int CHARTS = 1_000;

    @ParameterizedTest
    @EnumSource(ModelWriter.class)
    void aChartIsWrittenAndReadAgain(ModelWriter writer) {
        int written = 0;
        for (long seed = 0; written < CHARTS; seed++) {
            Statechart chart = RandomChart.draw(new Random(seed), 6);
            Flattening flat = Flattening.of(chart);
            if (!flat.problems().isEmpty()) {
                continue;
            }
            String text;
            try {
                text = writer.write(chart);
            } catch (ModelException refused) {
                assertThat(refused).hasMessageStartingWith("state machine 'random' cannot be written in ");
                continue;
            }
            written++;
            ModelFile file = ModelFile.read("written", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
            assertThat(SameMachine.difference(flat.machine(), file.only()))
                    .as("seed %s", seed)
                    .isEmpty();
        }
    }
}
