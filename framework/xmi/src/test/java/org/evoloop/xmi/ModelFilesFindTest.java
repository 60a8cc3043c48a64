package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelFilesFindTest {
    private static final Path WORKING_DIRECTORY = Path.of("").toAbsolutePath();
    private static final Path BESIDE_THE_CLASSES = WORKING_DIRECTORY.resolve("target");

    @AfterEach
    void forgetHome() {
        System.clearProperty("evoloop.home");
    }

    @Test
    void theWorkingDirectoryComesFirst(@TempDir Path home) throws IOException {
        System.setProperty("evoloop.home", home.toString());
        Files.createFile(home.resolve("pom.xml"));

        assertThat(ModelFiles.find("pom.xml", ModelFilesFindTest.class))
                .isEqualTo(WORKING_DIRECTORY.resolve("pom.xml"));
    }

    @Test
    void thenThePlaceBesideTheJar() throws IOException {
        Path model = Files.createTempFile(BESIDE_THE_CLASSES, "model", ".xml");
        try {
            String name = model.getFileName().toString();
            assertThat(ModelFiles.find(name, ModelFilesFindTest.class)).isEqualTo(model);
        } finally {
            Files.delete(model);
        }
    }

    @Test
    void thenTheConfiguredHome(@TempDir Path home) throws IOException {
        System.setProperty("evoloop.home", home.toString());
        Path model = Files.createFile(home.resolve("model.xml"));

        assertThat(ModelFiles.find("model.xml", ModelFilesFindTest.class)).isEqualTo(model);
    }

    @Test
    void aFileThatIsNowhereIsRefusedWithAllPlaces(@TempDir Path home) {
        System.setProperty("evoloop.home", home.toString());

        assertThatThrownBy(() -> ModelFiles.find("models/none.xml", ModelFilesFindTest.class))
                .isInstanceOf(ModelException.class)
                .hasMessage("no file models/none.xml in " + WORKING_DIRECTORY + " or " + BESIDE_THE_CLASSES + " or "
                        + home + "; start the program in its directory, or name that with -Devoloop.home=DIRECTORY");
    }
}
