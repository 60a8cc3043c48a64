package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import org.evoloop.config.ConfigException;
import org.evoloop.page.server.Gate;
import org.evoloop.page.server.PageServer;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A page's token that outlives the program, in a file. */
class TokenFileTest {
    @TempDir
    private Path folder;

    private static PageOptions options(Path file) {
        return PageOptions.of(
                PageOptions.OPTIONS.read(List.of("--page", "0", "--page-token-file", file.toString()), Map.of()));
    }

    private static String token(PageOptions options) throws IOException {
        try (Clock clock = new SystemClock();
                PageServer server = new PageServer(options.place(), 4096, clock)) {
            return server.gate().token();
        }
    }

    @Test
    void theTokenAndItsCookieSurviveARestart() throws IOException {
        Path file = folder.resolve("token");
        String token = token(options(file));

        assertThat(token).hasSize(24);
        assertThat(file).hasContent(token);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                .isEqualTo("rw-------");
        assertThat(token(options(file))).isEqualTo(token);
        assertThat(folder.toFile().list()).containsExactly("token");
        assertThat(new Gate("localhost", 1, token).admit(token))
                .isNotNull()
                .isEqualTo(new Gate("localhost", 1, token).admit(token))
                .doesNotContain(token);
        assertThat(token(PageOptions.at("0"))).isNotEqualTo(token(PageOptions.at("0")));
    }

    private void refused(Path file, String why) {
        assertThatThrownBy(() -> options(file))
                .isInstanceOf(ConfigException.class)
                .hasMessageContaining("--page-token-file is " + file + ", which " + why);
    }

    @Test
    void aFileThatOthersMayReadOrThatHoldsNoTokenIsRefused() throws IOException {
        Path file = Files.writeString(folder.resolve("token"), "a-token-of-my-own-choice\n");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r-----"));
        refused(file, "may be read or written by others; allow only its owner to (chmod 600)");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
        assertThat(token(options(file))).isEqualTo("a-token-of-my-own-choice");
        for (String bad : List.of("", "short", "with a blank in the middle", "x".repeat(129))) {
            Files.writeString(file, bad);
            refused(file, "holds no token of 16 to 128 letters, digits, _ and -; delete it");
        }
        refused(folder, "is not a regular file");
        assertThatThrownBy(() -> PageOptions.OPTIONS.read(List.of("--page-token-file", "token"), Map.of()))
                .hasMessageContaining("--page-token-file goes with --page");
    }

    @Test
    void aFileThatCannotBeWrittenIsOneMessage() throws IOException {
        Path nowhere = folder.resolve("nowhere/token");

        assertThatThrownBy(() -> token(options(nowhere)))
                .isInstanceOf(IOException.class)
                .hasMessageStartingWith("--page-token-file is " + nowhere + ", which cannot be written (");
    }

    @Test
    void aHostThatDoesNotExistIsAMistakeOfTheOptions() {
        assertThatThrownBy(() -> PageOptions.OPTIONS.read(List.of("--page", "no.such.host.invalid:80"), Map.of()))
                .isInstanceOf(ConfigException.class)
                .hasMessageContaining("there is no host no.such.host.invalid");
    }
}
