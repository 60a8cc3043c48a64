package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Names of instances, and the paths and owners of their sockets. */
class InstancesTest {
    @TempDir
    private Path runtime;

    private Service open(String name) throws IOException {
        return Service.open(
                ServiceOptions.none().withName(name), new ManualClock(), Map.of("XDG_RUNTIME_DIR", runtime.toString()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "a b", "../lamp", "a/b", "-x", "lämpchen", "a.b", "a\n"})
    void aNameOfOtherCharactersIsRefused(String name) {
        assertThatThrownBy(() -> ServiceOptions.none().withName(name))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("use letters, digits, - and _");
    }

    @Test
    void aProgramIsInformedHowItRuns() {
        ServiceOptions options = ServiceOptions.of(
                ServiceOptions.OPTIONS.read(List.of("--name", "lamp-2", "--start", "--journal", "kept"), Map.of()));

        assertThat(options).isEqualTo(new ServiceOptions(true, "lamp-2", Path.of("kept")));
        assertThatThrownBy(() -> ServiceOptions.OPTIONS.read(List.of("--name", "a.b"), Map.of()))
                .hasMessage("--name: 'a.b' is not a name for an instance; use letters, digits, - and _, and no - in "
                        + "front, as in living-room");
    }

    @Test
    void theSocketIsInTheSessionsDirectoryOrTheUnitsOrTheUsersOwn() {
        assertThat(new Instances(Map.of("XDG_RUNTIME_DIR", "/s", "RUNTIME_DIRECTORY", "/r")).directory())
                .isEqualTo(Path.of("/s/evoloop"));
        assertThat(new Instances(Map.of("RUNTIME_DIRECTORY", "/r:/second")).directory())
                .isEqualTo(Path.of("/r"));
        assertThat(new Instances(Map.of()).directory())
                .isEqualTo(Path.of(System.getProperty("java.io.tmpdir"), "evoloop-" + System.getProperty("user.name")));
    }

    @Test
    void aPathThatIsTooLongIsReportedWithItsLength() {
        Path directory = Path.of("/" + "d".repeat(99));

        assertThat(Instances.socket(directory, "l")).isEqualTo(directory.resolve("l.sock"));
        assertThatThrownBy(() -> Instances.socket(directory, "la"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("a path of 108 bytes, and 107 are allowed");
    }

    @Test
    void aNameIsTakenOnceAndCanBeTakenAgain() throws Exception {
        try (Service first = open("lamp");
                Service other = open("lamp-2")) {
            assertThat(first).isNotSameAs(other);
            assertThatThrownBy(() -> open("lamp"))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("an instance named lamp is running already (process "
                            + ProcessHandle.current().pid()
                            + "); give this one another --name, or end that one: ctl lamp exit");
        }
        open("lamp").close();
    }

    @Test
    void theDirectoryIsPrivateAlsoIfItWasThere() throws Exception {
        Path directory = Files.createDirectory(runtime.resolve("evoloop"));
        Files.setPosixFilePermissions(directory, PosixFilePermissions.fromString("rwxr-xr-x"));

        open("lamp").close();

        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(directory)))
                .isEqualTo("rwx------");
    }

    @Test
    void aLinkInTheDirectorysPlaceIsNotFollowed(@TempDir Path elsewhere) throws Exception {
        Files.createSymbolicLink(runtime.resolve("evoloop"), elsewhere);

        assertThatThrownBy(() -> open("lamp"))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("is not a directory of this user");
    }

    @Test
    void theClientListsTheInstances() throws Exception {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        PrintStream all = new PrintStream(text, true, StandardCharsets.UTF_8);
        Ctl ctl = new Ctl(new Instances(Map.of("XDG_RUNTIME_DIR", runtime.toString())), all, all, false);
        Path directory = Files.createDirectory(runtime.resolve("evoloop"));
        Files.createFile(directory.resolve("dead.sock"));

        try (ControlServer lamp = new ControlServer(directory.resolve("lamp.sock"), new Echo(), new ManualClock())) {
            assertThat(lamp.commands().isEnding()).isFalse();
            assertThat(ctl.call(List.of())).isZero();
            assertThat(ctl.call(List.of("lamp", "press", "a b", "it's"))).isZero();
            assertThat(ctl.call(List.of("lamp", "fail"))).isEqualTo(1);
            assertThat(ctl.call(List.of("lamp", "x".repeat(4095)))).isZero();
            assertThat(ctl.call(List.of("lamp", "x".repeat(100_000)))).isEqualTo(2);
            assertThat(ctl.call(List.of("lump", "status"))).isEqualTo(2);
            assertThat(ctl.call(List.of("lamp"))).isEqualTo(2);
            assertThat(ctl.call(List.of("a b", "status"))).isEqualTo(2);
        }

        assertThat(text.toString(StandardCharsets.UTF_8).lines())
                .contains("lamp", "press 'a b' \"it's\"", "no")
                .anyMatch(line -> line.startsWith("error: no instance named lump is running; did you mean lamp?"))
                .contains("error: the command is longer than 4095 bytes")
                .contains("error: give a command for lamp: ctl lamp help lists its commands")
                .doesNotContain("dead");
    }

    @Test
    void theClientNamesADirectoryWhereItMayNotLook() throws Exception {
        ByteArrayOutputStream results = new ByteArrayOutputStream();
        ByteArrayOutputStream errors = new ByteArrayOutputStream();
        Ctl ctl = new Ctl(
                new Instances(Map.of("XDG_RUNTIME_DIR", runtime.toString())),
                new PrintStream(results, true, StandardCharsets.UTF_8),
                new PrintStream(errors, true, StandardCharsets.UTF_8),
                false);
        Path directory = Files.createDirectory(runtime.resolve("evoloop"));
        Files.setPosixFilePermissions(directory, PosixFilePermissions.fromString("---------"));
        try {
            assumeFalse(Files.isReadable(directory), "root may look everywhere");
            assertThat(ctl.call(List.of())).isZero();
            assertThat(ctl.call(List.of("lamp", "status"))).isEqualTo(2);
        } finally {
            Files.setPosixFilePermissions(directory, PosixFilePermissions.fromString("rwx------"));
        }
        assertThat(results.toString(StandardCharsets.UTF_8)).isEmpty();
        assertThat(errors.toString(StandardCharsets.UTF_8).lines())
                .containsExactly(
                        "the instances in " + directory + " belong to another user; use sudo to see them",
                        "error: no instance named lamp is running for this user; the instances in " + directory
                                + " belong to another user; use sudo to see them");
    }

    private static final class Echo implements Commands {
        @Override
        public int perform(String line, PrintStream results, PrintStream errors) {
            results.println(line.equals("fail") ? "no" : line);
            return line.equals("fail") ? 1 : 0;
        }

        @Override
        public boolean isEnding() {
            return false;
        }
    }
}
