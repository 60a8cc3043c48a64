package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.xmi.astah.AstahDocument.offOn;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.astah.AstahDocument;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ModelFileTest {
    @TempDir
    Path directory;

    @Test
    void shouldReadTheOnlyMachineWithoutAName() throws IOException {
        Path file = write("one.xml", new AstahDocument().add(offOn("m")).text());

        assertThat(ModelFile.machine(file.toString()).transitions())
                .extracting(Transition::toString)
                .containsExactly("Off --Clean--> On");
        assertThat(ModelFile.read(file).machines()).extracting(XmiMachine::name).containsExactly("StateMachine0");
    }

    @Test
    void shouldListTheNamesWhenOneMustBeChosen() throws IOException {
        Path file = write("two.xml", twoMachines());

        assertThatThrownBy(() -> ModelFile.machine(file.toString()))
                .isInstanceOf(ModelException.class)
                .hasMessage(file + ": holds 2 state machines; choose one by " + file + "#NAME, there is"
                        + " 'now' (machine 'StateMachine0', id m1, line 9),"
                        + " 'StateMachine0' (machine 'StateMachine0', id m2, line 22)");
        assertThatThrownBy(() -> ModelFile.machine(file + "#later"))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith(file + ": no state machine is named 'later'; there is 'now' (");
    }

    @Test
    void shouldListTheIdsWhenANameIsAmbiguous() throws IOException {
        Path file = write("two.xml", twoMachines());

        assertThatThrownBy(() -> ModelFile.machine(file + "#StateMachine0"))
                .isInstanceOf(ModelException.class)
                .hasMessageContainingAll("names 2 state machines", "id m1", "id m2");
        assertThat(ModelFile.machine(file + "#m2").name()).isEqualTo("StateMachine0");
        assertThat(ModelFile.machine(file + "# now ").name()).isEqualTo("now");
    }

    @Test
    void shouldSayHowToDrawWhenThereIsNoMachine() throws IOException {
        String activity = "<UML:ActivityGraph xmi.id=\"a\" name=\"A\"><UML:StateMachine.top></UML:StateMachine.top>"
                + "</UML:ActivityGraph></UML:Namespace.ownedElement>";
        Path file =
                write("none.xml", new AstahDocument().text().replaceFirst("</UML:Namespace.ownedElement>", activity));

        assertThat(ModelFile.read(file).machines()).isEmpty();
        for (String reference : List.of(file.toString(), file + "#new")) {
            assertThatThrownBy(() -> ModelFile.machine(reference))
                    .isInstanceOf(ModelException.class)
                    .hasMessage(file + ": holds no state machine; draw one and export the file again");
        }
    }

    @Test
    void shouldFindAMachineInsideAClassAndAnEventOutsideOfItUnderOtherPrefixes() throws IOException {
        String machine = offOn("m")
                .transition(
                        "<UML:Transition xmi.id=\"x\" name=\"\"><UML:Transition.trigger><UML:Event xmi.idref=\"ev\"/>"
                                + "</UML:Transition.trigger>" + AstahDocument.ends("on", "off") + "</UML:Transition>")
                .text();
        String document = new AstahDocument()
                .text()
                .replaceFirst(
                        "</UML:Namespace.ownedElement>",
                        "<UML:Class xmi.id=\"c\" name=\"C\"><UML:ModelElement.behavior><UML:StateMachine xmi.idref=\"m\"/>"
                                + "</UML:ModelElement.behavior><UML:Namespace.ownedElement>" + machine
                                + "</UML:Namespace.ownedElement></UML:Class><UML:Event xmi.id=\"ev\" name=\"tm%282s%29\"/>"
                                + "</UML:Namespace.ownedElement>")
                .replace("UML:", "u:")
                .replace(":UML", ":u");

        assertThat(ModelFile.machine(write("class.xml", document).toString()).transitions())
                .extracting(Transition::toString)
                .containsExactly("Off --Clean--> On", "On --tm(2s)--> Off");
    }

    @Test
    void shouldReadCarriageReturnsAByteOrderMarkAndOtherEncodings() throws IOException {
        String document = new AstahDocument().add(offOn("m")).diagram("状態", "m").text();
        Path windows = write("windows.xml", "\uFEFF" + document.replace("\n", "\r\n"));
        Path wide = directory.resolve("wide.xml");
        Files.write(
                wide,
                document.replace("encoding = \"UTF-8\"", "encoding = \"UTF-16\"")
                        .getBytes(java.nio.charset.StandardCharsets.UTF_16));

        Path japanese = directory.resolve("japanese.xml");
        Files.write(japanese, document.replace("UTF-8", "Shift_JIS").getBytes("Shift_JIS"));

        for (Path file : List.of(windows, wide, japanese)) {
            assertThat(ModelFile.read(file).machines())
                    .extracting(XmiMachine::name)
                    .containsExactly("状態");
            assertThat(ModelFile.machine(file.toString()).states()).hasSize(2);
        }
    }

    @Test
    void shouldTakeAPathWithHashesWholeIfItExists() throws IOException {
        Path hashed = Files.createDirectory(directory.resolve("a#b"));
        Path file = Files.writeString(hashed.resolve("c#1.xml"), twoMachines());

        assertThat(ModelReference.parse(file.toString())).isEqualTo(new ModelReference(file, Optional.empty()));
        assertThat(ModelReference.parse(file + "#now")).isEqualTo(new ModelReference(file, Optional.of("now")));
        assertThat(ModelReference.parse(file + "#now")).hasToString(file + "#now");
        assertThat(ModelFile.machine(file + "#now").name()).isEqualTo("now");
    }

    @ParameterizedTest
    @CsvSource({
        "'', names no file",
        "#new, names no file",
        "robot.xml#, names no state machine after '#'",
        "robot.xml# , names no state machine after '#'",
        "a\0b.xml, is not the path of a file"
    })
    void shouldRefuseAReferenceThatNamesNothing(String reference, String problem) {
        assertThatThrownBy(() -> ModelReference.parse(reference))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining(problem);
    }

    private static String twoMachines() {
        return new AstahDocument()
                .add(offOn("m1"))
                .add(new AstahDocument.Machine("m2", "StateMachine0")
                        .initial("j", "s")
                        .state("s", "S"))
                .diagram("now", "m1")
                .text();
    }

    private Path write(String name, String text) throws IOException {
        return Files.writeString(directory.resolve(name), text);
    }

    @Test
    void saysThatUmbrelloSavesPictures() {
        String document =
                "<XMI xmi.version='1.2' xmlns:UML='http://schema.omg.org/spec/UML/1.4'><XMI.header><XMI.documentation>"
                        + "<XMI.exporter>umbrello uml modeller http://umbrello.kde.org</XMI.exporter></XMI.documentation>"
                        + "</XMI.header><XMI.content><UML:Model xmi.id='m'/></XMI.content></XMI>";

        assertThatThrownBy(() -> ModelFile.read(
                                "robot.xmi", new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)))
                        .only())
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("robot.xmi: was written by Umbrello, which saves state diagrams as pictures");
    }
}
