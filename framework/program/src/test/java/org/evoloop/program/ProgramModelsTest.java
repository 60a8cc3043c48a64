package org.evoloop.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.check.timing.TimeRules;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The models of a program, and what lies beside them. */
class ProgramModelsTest {
    private static final String MACHINE =
            "```mermaid\n---\ntitle: %s\n---\nstateDiagram-v2\n[*] --> off\noff --> on : go\n```\n";

    @TempDir
    private Path folder;

    private Path write(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text);
    }

    @Test
    void oneFileHasBothAndTheRequirementsOnTimeAreBesideIt() throws IOException {
        Path file = write("lamp.md", MACHINE.formatted("original") + "\n" + MACHINE.formatted("new"));
        assertThat(ProgramModels.in(file).time()).isEqualTo(TimeRules.NONE);

        write("lamp.properties.txt", "It does not burn for ever: on never longer than 3 h\n");
        ProgramModels read = ProgramModels.in(file);
        assertThat(read.pair().original().name()).isEqualTo("original");
        assertThat(read.pair().evolved().name()).isEqualTo("new");
        assertThat(read.time().properties()).hasSize(1);
        assertThat(read.offered()).isEqualTo(List.of(file + "#original", file + "#new"));

        Files.delete(folder.resolve("lamp.properties.txt"));
        Files.createDirectory(folder.resolve("lamp.properties.txt"));
        assertThatThrownBy(() -> ProgramModels.in(file))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith(folder.resolve("lamp.properties.txt") + ": cannot be read: ");
    }

    @Test
    void orTwoFilesHaveOneEach() throws IOException {
        Path original = write("original.md", MACHINE.formatted("as it is"));
        Path evolved = write("new.md", MACHINE.formatted("as it should be") + "\n" + MACHINE.formatted("another"));
        ProgramModels read = ProgramModels.of(
                ModelReference.parse(original.toString()), ModelReference.parse(evolved + "#as it should be"));

        assertThat(read.pair().evolved().name()).isEqualTo("as it should be");
        assertThat(read.offered()).containsExactly(evolved + "#as it should be", evolved + "#another");
    }
}
