package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A format that is known and not read is called by its name, with the way to go on. */
class ForeignFormatTest {
    private static void assertRefused(String name, byte[] bytes, String... words) {
        assertThatThrownBy(() -> ModelFile.read(name, new ByteArrayInputStream(bytes)))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith(name + ": is ")
                .hasMessageContainingAll(words);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"_type\": \"Project\", \"_id\": \"1\"} | a StarUML project, which Evoloop does not read: export XMI in StarUML",
                "{\"id\":\"lamp\",\"initial\":\"Off\",\"states\":{}} | an XState machine",
                "import { createMachine } from 'xstate'; | an XState machine",
                "{\"name\": 1}               | a JSON file",
                "// lamp\\ndigraph {\\nOff -> On } | a Graphviz graph (DOT)",
                "strict graph \"lamp\" { } | a Graphviz graph (DOT)",
                "initial => Off;\\nOff => On: press; | a file for state-machine-cat, which Evoloop does not read: convert it: smcat",
                "# lamp\\nstatechart:\\n  name: lamp | a YAML file",
                "<mxfile host='x'><diagram/></mxfile> | a draw.io drawing",
                "<svg xmlns='http://www.w3.org/2000/svg'/> | a picture",
                "<graphml/>                   | a yEd graph",
                "<!DOCTYPE html><html/>      | a web page",
                "<xmi:XMI xmlns:xmi='http://www.omg.org/XMI' xmlns:s='http://www.yakindu.org/sct/2.0'/> | an itemis CREATE",
                "\u0089PNG                   | a picture",
            })
    void itShowsInTheContent(String content, String what) {
        byte[] bytes = content.replace("\\n", "\n").getBytes(StandardCharsets.ISO_8859_1);

        assertRefused("model.xml", bytes, what);
    }

    @Test
    void itShowsInTextOfTwoBytesALetter() {
        assertRefused("model.txt", "digraph { }".getBytes(StandardCharsets.UTF_16), "a Graphviz graph");
    }

    @ParameterizedTest
    @CsvSource({
        "lamp.smcat, a file for state-machine-cat",
        "lamp.GV, a Graphviz graph",
        "lamp.yml, a YAML file",
        "lamp.qea, an Enterprise Architect project",
        "lamp.vpp, a Visual Paradigm project",
        "lamp.mdzip, a MagicDraw project",
        "lamp.slx, a Simulink or Stateflow model"
    })
    void itShowsInTheName(String name, String what) {
        assertRefused(name, "PK anything".getBytes(StandardCharsets.UTF_8), what);
    }

    @Test
    void whatPapyrusDrawsIsNotTheModel() {
        String notation = "<xmi:XMI xmlns:xmi='http://www.omg.org/XMI'/>";
        ModelFile file =
                ModelFile.read("lamp.notation", new ByteArrayInputStream(notation.getBytes(StandardCharsets.UTF_8)));

        assertThatThrownBy(file::only).hasMessageContaining("name the .uml file beside it");
    }

    @Test
    void aFileOfThousandsOfCommentsIsNoProblem() {
        assertRefused("model.smcat", "//\n".repeat(100_000).getBytes(StandardCharsets.UTF_8), "state-machine-cat");
    }
}
