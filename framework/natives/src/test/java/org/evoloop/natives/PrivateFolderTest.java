package org.evoloop.natives;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@EnabledOnOs(OS.LINUX)
class PrivateFolderTest {
    @Test
    void itIsItsOwnersAloneAndGoesWithAllThatIsInIt() throws Exception {
        Path path;
        try (PrivateFolder folder = PrivateFolder.make()) {
            path = folder.file("").toPath();
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(path)))
                    .isEqualTo("rwx------");
            assertThat(path.toFile().list()).containsExactly("lock");
            Files.writeString(path.resolve("library"), "x");
        }
        assertThat(path).doesNotExist();
    }

    @Test
    void noTwoHaveTheSameName() throws Exception {
        try (PrivateFolder one = PrivateFolder.make();
                PrivateFolder other = PrivateFolder.make()) {
            assertThat(one.file("")).isNotEqualTo(other.file(""));
        }
    }

    @TempDir
    private Path temporary;

    /** Makes a folder, and waits to be killed. */
    static final class Killed {
        public static void main(String[] args) throws Exception {
            PrivateFolder folder = PrivateFolder.make();
            Files.writeString(folder.file("library").toPath(), "x");
            System.out.println("made");
            System.in.read();
        }
    }

    private Process process() throws IOException {
        return new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-Djava.io.tmpdir=" + temporary,
                        "-cp",
                        System.getProperty("java.class.path"),
                        Killed.class.getName())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
    }

    private List<String> left() {
        return List.of(temporary.toFile().list((folder, name) -> name.startsWith("evoloop-native-")));
    }

    @Test
    void thatOfAKilledProcessIsDeletedByTheNextAndThatOfALivingOneIsNot() throws Exception {
        Process killed = process();
        Process living = null;
        try {
            assertThat(killed.inputReader().readLine()).isEqualTo("made");
            List<String> first = left();
            assertThat(first).hasSize(1);

            living = process();
            assertThat(living.inputReader().readLine()).isEqualTo("made");
            assertThat(left()).as("both live").hasSize(2).containsAll(first);

            killed.destroyForcibly().waitFor();
            Process third = process();
            assertThat(third.inputReader().readLine()).isEqualTo("made");
            third.destroyForcibly().waitFor();
            assertThat(left()).hasSize(2).doesNotContainAnyElementsOf(first);
        } finally {
            killed.destroyForcibly();
            if (living != null) {
                living.destroyForcibly();
            }
        }
    }

    /** What is not this program's own folder stays. */
    @Test
    void nothingElseIsDeleted() throws Exception {
        Path kept = Files.writeString(temporary.resolve("evoloop-native-file"), "x");
        Path elsewhere = Files.createDirectory(temporary.resolve("elsewhere"));
        Files.writeString(elsewhere.resolve("lock"), "x");
        Path link = Files.createSymbolicLink(temporary.resolve("evoloop-native-link"), elsewhere);
        Path young = Files.createDirectory(temporary.resolve("evoloop-native-young"));

        Process process = process();
        assertThat(process.inputReader().readLine()).isEqualTo("made");
        process.destroyForcibly().waitFor();

        assertThat(kept).exists();
        assertThat(link).exists();
        assertThat(elsewhere.resolve("lock")).exists();
        assertThat(young).exists();
    }
}
