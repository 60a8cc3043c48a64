package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Names of instances, and the paths and owners of their sockets. */
class InstancesTest {
    @TempDir
    private Path runtime;

    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final PrintStream out = new PrintStream(printed, true, StandardCharsets.UTF_8);

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
        ServiceOptions options = ServiceOptions.of(ServiceOptions.OPTIONS.read(
                List.of("--name", "lamp-2", "--start", "--journal", "kept", "--on-trouble", "tell me"), Map.of()));

        assertThat(options)
                .isEqualTo(new ServiceOptions(true, "lamp-2", Path.of("kept"), Duration.ofSeconds(10), "tell me"));
        assertThatThrownBy(() -> ServiceOptions.OPTIONS.read(List.of("--on-trouble", " "), Map.of()))
                .hasMessage("--on-trouble: the command is empty; leave the option out to run nothing");
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
        Path directory = Files.createDirectory(runtime.resolve("evoloop"));
        Files.createFile(directory.resolve("dead.sock"));

        try (ControlServer lamp = new ControlServer(directory.resolve("lamp.sock"), new Echo(), new ManualClock())) {
            assertThat(lamp.commands().isEnding()).isFalse();
            assertThat(ctl()).isZero();
            assertThat(ctl("lamp", "press", "a b", "it's", "it's 5\"")).isZero();
            assertThat(ctl("lamp", "fail")).isEqualTo(1);
            assertThat(ctl("lamp", "x".repeat(4_095))).isZero();
            assertThat(ctl("lamp", "x".repeat(100_000))).isEqualTo(2);
            assertThat(ctl("lump", "status")).isEqualTo(2);
            assertThat(ctl("lamp")).isEqualTo(2);
            assertThat(ctl("a b", "status")).isEqualTo(2);
        }

        assertThat(printed.toString(StandardCharsets.UTF_8).lines())
                .contains("lamp", "press 'a b' \"it's\" 'it'\"'\"'s 5\"'", "no")
                .anyMatch(line -> line.startsWith("error: no instance named lump is running; did you mean lamp?"))
                .contains("error: give a command for lamp: ctl lamp help lists its commands")
                .contains("error: the command is longer than 4095 bytes")
                .doesNotContain("dead");
    }

    @Test
    void theClientTrustsNoDirectoryThatAnyoneMayHaveMade(@TempDir Path elsewhere) throws Exception {
        Path temporary = runtime.resolve("evoloop-user");
        Files.createFile(elsewhere.resolve("lamp.sock"));
        Files.createSymbolicLink(temporary, elsewhere);
        Instances instances = new Instances(Map.of(), temporary);
        assertThat(instances.sockets()).noneMatch(socket -> socket.startsWith(temporary));

        Files.delete(temporary);
        Files.createDirectory(temporary);
        Path own = Files.createFile(temporary.resolve("lamp.sock"));
        assertThat(instances.sockets()).contains(own);
    }

    @Test
    void theClientWaitsForASlowCommandWhileTheInstanceIsAlive() throws Exception {
        Path directory = Files.createDirectory(runtime.resolve("evoloop"));
        Echo slow = new Echo();

        try (ControlServer lamp = new ControlServer(directory.resolve("lamp.sock"), slow, new ManualClock())) {
            assertThat(lamp.commands().isEnding()).isFalse();
            // It takes until the client has asked whether the instance is alive.
            assertThat(new Ctl(instances(), out, out, false, Duration.ofSeconds(2)).call(List.of("lamp", "slow")))
                    .isZero();
        }

        assertThat(printed.toString(StandardCharsets.UTF_8)).isEqualToIgnoringNewLines("slow");
    }

    @Test
    void theClientNamesADirectoryThatIsClosedToItsUser() throws Exception {
        Path directory = Files.createDirectory(runtime.resolve("evoloop"));
        Files.setPosixFilePermissions(directory, Set.of());
        assumeFalse(Files.isReadable(directory), "root may read every directory");
        String closed = "instances in " + directory + " can be reached only by its owner and root; try it with sudo";

        assertThat(ctl()).isZero();
        assertThat(ctl("lamp", "status")).isEqualTo(2);

        Files.setPosixFilePermissions(directory, PosixFilePermissions.fromString("rwx------"));
        assertThat(printed.toString(StandardCharsets.UTF_8).lines())
                .contains("note: " + closed)
                .anyMatch(line -> line.startsWith("error: no instance named lamp is running") && line.contains(closed));
    }

    @Test
    void anAnswerThatCannotBeWrittenIsAFailure() {
        PrintStream full = new PrintStream(new OutputStream() {
            @Override
            public void write(int octet) throws IOException {
                throw new IOException("No space left on device");
            }
        });

        assertThat(new Ctl(instances(), full, out, false, Instance.PATIENCE).call(List.of("--help")))
                .isEqualTo(1);

        assertThat(printed.toString(StandardCharsets.UTF_8))
                .isEqualToIgnoringNewLines("error: standard output: the answer could not be written in full");
    }

    private Instances instances() {
        return new Instances(Map.of("XDG_RUNTIME_DIR", runtime.toString()));
    }

    private int ctl(String... words) {
        return new Ctl(instances(), out, out, false, Instance.PATIENCE).call(List.of(words));
    }

    private static final class Echo implements Commands {
        private final CountDownLatch sign = new CountDownLatch(1);

        @Override
        public int perform(String line, PrintStream results, PrintStream errors) throws InterruptedException {
            if (line.isEmpty()) {
                sign.countDown();
                return 0;
            }
            if (line.equals("slow")) {
                sign.await();
            }
            results.println(line.equals("fail") ? "no" : line);
            return line.equals("fail") ? 1 : 0;
        }

        @Override
        public boolean isEnding() {
            return false;
        }
    }
}
