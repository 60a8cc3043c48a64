package org.evoloop.natives;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

@EnabledOnOs(OS.LINUX)
class PrivateFolderTest {
    @Test
    void itIsItsOwnersAloneAndGoesWithAllThatIsInIt() throws Exception {
        Path path;
        try (PrivateFolder folder = PrivateFolder.make()) {
            path = folder.file("").toPath();
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(path)))
                    .isEqualTo("rwx------");
            assertThat(path).isEmptyDirectory();
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
}
