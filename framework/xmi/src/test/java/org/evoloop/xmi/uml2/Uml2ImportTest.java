package org.evoloop.xmi.uml2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.xmi.uml2.Uml2Text.machine;
import static org.evoloop.xmi.uml2.Uml2Text.state;
import static org.evoloop.xmi.uml2.Uml2Text.transition;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A mistake in a file to which another one refers is reported with that file's name. */
class Uml2ImportTest {
    @TempDir
    Path directory;

    private Path main;
    private Path imported;

    @BeforeEach
    void mainFile() throws IOException {
        main = directory.resolve("main.uml");
        imported = directory.resolve("parts/lib.uml");
        Files.createDirectories(imported.getParent());
        Files.writeString(
                main,
                machine("<subvertex xmi:type='uml:Pseudostate' xmi:id='start'/>"
                        + "<subvertex xmi:type='uml:State' xmi:id='s' name='S'><submachine href='parts/lib.uml#m'/></subvertex>"
                        + "<transition xmi:id='t' source='start' target='s'/>"));
    }

    private XmiMachine read(String importedText) throws IOException {
        Files.writeString(imported, importedText);
        return ModelFile.read(main).findOnly();
    }

    @Test
    void ofAnElementThatIsNotRead() throws IOException {
        XmiMachine machine =
                read(machine(state("a", "A") + "\n" + state("b", "B").replace("/>", " odd='1'/>")));

        assertThatThrownBy(machine::statechart)
                .hasMessageContaining(
                        imported + ", line " + (Uml2Text.FIRST_LINE + 1) + ": attribute odd of State 'B'");
    }

    @Test
    void ofANote() throws IOException {
        assertThat(read(machine("<subvertex xmi:type='uml:State' xmi:id='a'/>")).notes())
                .containsExactly(main + ": " + imported + ", line " + Uml2Text.FIRST_LINE
                        + ": state without a name is called by its id, 'a'; give it a name");
    }

    @Test
    void ofAMachineThatCannotBeFlattened() throws IOException {
        XmiMachine machine = read(transition("", "<trigger xmi:id='tr' name='after 2'/>"));

        assertThatThrownBy(machine::toStateMachine)
                .hasMessageContaining(
                        imported + ", line " + (Uml2Text.FIRST_LINE + 4) + ": time trigger 'after 2' has no")
                .hasMessageContaining("on 'after 2' (" + imported + ", line " + (Uml2Text.FIRST_LINE + 4) + ", id t)");
    }

    @Test
    void ofAFileThatCannotBeRead() throws IOException {
        assertThatThrownBy(read("<uml:Model")::statechart)
                .hasMessageContaining(
                        "refers to another file, 'parts/lib.uml#m': " + imported + ": is damaged or not XML");
        assertThatThrownBy(read("<scxml/>")::statechart)
                .hasMessageContaining(
                        "'parts/lib.uml#m': " + imported + ": found root element 'scxml', which is not UML 2");
        assertThatThrownBy(read(machine("").replace("xmi:id='m'", "xmi:id='n'"))::statechart)
                .hasMessageContaining("'parts/lib.uml#m', which holds no such element of a state machine; correct");
    }
}
