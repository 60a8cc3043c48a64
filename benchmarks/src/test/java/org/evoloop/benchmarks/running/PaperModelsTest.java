package org.evoloop.benchmarks.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;

class PaperModelsTest {
    @Test
    void areTheSameAsInTheModelFile() {
        ModelFile file = ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml"));

        assertSame(PaperModels.cleaningRobot().original(), file.pick("original"));
        assertSame(PaperModels.cleaningRobot().evolved(), file.pick("new"));
    }

    private static void assertSame(StateMachine here, StateMachine drawn) {
        assertThat(here.initial()).isEqualTo(drawn.initial());
        assertThat(here.states()).isEqualTo(drawn.states());
        assertThat(here.events()).isEqualTo(drawn.events());
        assertThat(here.transitions()).containsExactlyInAnyOrderElementsOf(drawn.transitions());
    }
}
