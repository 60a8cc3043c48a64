package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Projects that are zip files with a document in them. */
class ZippedModelTest {
    private static final String DOCUMENT = """
            <XMI xmi.version='1.2' xmlns:UML='org.omg.xmi.namespace.UML'>
              <XMI.header><XMI.documentation><XMI.exporter>ArgoUML</XMI.exporter></XMI.documentation></XMI.header>
              <XMI.content><UML:StateMachine xmi.id='m' name='M'>
                <UML:StateMachine.top><UML:CompositeState xmi.id='top'><UML:CompositeState.subvertex>
                  <UML:Pseudostate xmi.id='i' kind='initial'/><UML:SimpleState xmi.id='a' name='A'/>
                </UML:CompositeState.subvertex></UML:CompositeState></UML:StateMachine.top>
                <UML:StateMachine.transitions><UML:Transition xmi.id='t' source='i' target='a'/>
                </UML:StateMachine.transitions>
              </UML:StateMachine></XMI.content>
            </XMI>
            """;

    @TempDir
    private Path directory;

    private Path zip(String... names) throws IOException {
        Path file = directory.resolve("robot.zargo");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
            for (String name : names) {
                zip.putNextEntry(new ZipEntry(name));
                zip.write(DOCUMENT.getBytes(StandardCharsets.UTF_8));
            }
        }
        return file;
    }

    @Test
    void readsTheOnlyDocument() throws IOException {
        Path project = zip("robot.argo", "robot.xmi", "robot_1.pgml");

        assertThat(ModelFile.read(project).only().initial()).hasToString("A");
        Files.delete(project);
    }

    @Test
    void refusesSeveralAndNone() throws IOException {
        Path several = zip("a.xmi", "b.xmi");
        assertThatThrownBy(() -> ModelFile.read(several))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("2 XMI documents in it (a.xmi, b.xmi); unpack it and name one");
        Path none = zip("project.jude");
        assertThatThrownBy(() -> ModelFile.read(none))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("is a zip archive");
    }

    /** As large as a document may be, and packed to a thousandth. */
    private Path bomb() throws IOException {
        Path file = directory.resolve("bomb.zargo");
        byte[] elements = "<a/>".repeat(1 << 18).getBytes(StandardCharsets.UTF_8);
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
            zip.putNextEntry(new ZipEntry("robot.xmi"));
            zip.write("<XMI xmi.version='1.2' xmlns:UML='org.omg.xmi.namespace.UML'>".getBytes(StandardCharsets.UTF_8));
            for (int i = 0; i < 32; i++) {
                zip.write(elements);
            }
        }
        return file;
    }

    @Test
    void refusesABombBeforeItIsUnpacked() throws IOException {
        Path bomb = bomb();

        assertThatThrownBy(() -> ModelFile.read(bomb))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining(
                        "bomb.zargo: is a zip archive whose document robot.xmi would have 32 MiB, more than 100")
                .hasMessageContaining("unpack it and name the document");
    }

    @Test
    void refusesABombThatSaysThatItIsSmall() throws IOException {
        byte[] bytes = Files.readAllBytes(bomb());
        // The uncompressed size in the central directory, at whose end the name is.
        int directoryEntry = new String(bytes, StandardCharsets.ISO_8859_1).indexOf("PK\001\002");
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(directoryEntry + 24, 1 << 20);
        Path liar = Files.write(directory.resolve("liar.zargo"), bytes);

        assertThatThrownBy(() -> ModelFile.read(liar))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("liar.zargo: is a damaged zip archive, whose document is longer than it says");
    }

    @Test
    void refusesADamagedArchive() throws IOException {
        Path damaged = Files.write(directory.resolve("x.zargo"), new byte[] {'P', 'K', 3, 4, 0, 0});
        assertThatThrownBy(() -> ModelFile.read(damaged))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("x.zargo: is a zip archive");
    }
}
