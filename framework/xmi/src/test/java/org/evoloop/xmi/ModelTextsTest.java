package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The examples in {@code models} are the same machines as drawings and as text. */
class ModelTextsTest {
    private static ModelFile read(String name) {
        return ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", name));
    }

    @ParameterizedTest
    @CsvSource({
        "light-bulb.xml, light-bulb.md",
        "cleaning-robot.xml, cleaning-robot.md",
        "roomba.xml, roomba.md",
        "cleaning-robot-twice.scxml, cleaning-robot-twice.mmd",
        "light-bulb.xml, README.md",
        "../devices/light-bulb/README.md, ../README.md",
        "light-bulb.xml, ../docs/lightbulb.md",
        "../docs/fan/fan.uml, ../docs/retrofit.md"
    })
    void theTextIsTheDrawing(String drawing, String text) {
        ModelFile texts = read(text);

        for (XmiMachine drawn : read(drawing).machines()) {
            assertThat(SameMachine.difference(
                            drawn.toStateMachine(), texts.find(drawn.name()).toStateMachine()))
                    .as(drawn.name())
                    .isEmpty();
        }
    }

    @Test
    void theTextHasNoOtherMachines() {
        assertThat(read("roomba.md").machines())
                .hasSameSizeAs(read("roomba.xml").machines());
    }
}
