package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.link.SerialLink;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * Another user has planted files in a world-writable directory, under the names to which libraries unpack their native
 * parts.
 */
@EnabledOnOs(OS.LINUX)
@Timeout(120)
class PlantedLibrariesTest {
    private static final String SERIAL = "libjSerialComm.so";
    private static final Map<String, String> MACHINES = Map.of("amd64", "x86_64", "aarch64", "armv8_64", "x86", "x86");

    @TempDir
    Path folder;

    private Path everybodys;
    private Path precious;

    @BeforeEach
    void plant() throws IOException {
        String machine = MACHINES.get(System.getProperty("os.arch"));
        assumeTrue(machine != null, "no library to plant on this machine");
        everybodys = Files.createDirectory(folder.resolve("tmp"));
        Files.setPosixFilePermissions(everybodys, PosixFilePermissions.fromString("rwxrwxrwx"));
        SerialLink.prepare();
        Path place = Files.createDirectories(everybodys.resolve("jSerialComm").resolve(SerialPort.getVersion()));
        // The library itself, so that it would load; an attacker would plant a different one.
        try (InputStream library = SerialPort.class.getResourceAsStream("/Linux/" + machine + "/" + SERIAL)) {
            Files.copy(Objects.requireNonNull(library), place.resolve(SERIAL));
        }
        // jSerialComm deletes old files beside it.
        precious =
                Files.writeString(Files.createDirectory(folder.resolve("mine")).resolve("precious"), "precious");
        Files.createSymbolicLink(place.resolveSibling("1.0.0"), precious.getParent());
    }

    @Test
    void theConverterLoadsNothingThatWasPlanted() throws Exception {
        assertLoadsPrivately(Set.of(SERIAL, "libjnidispatch.so"), "--simulate");
    }

    @Test
    void theSimulatorLoadsNothingThatWasPlanted() throws Exception {
        String link = folder.resolve("robot").toString();
        assertLoadsPrivately(Set.of("libjnidispatch.so"), "simulator", "--link", link);
    }

    @Test
    void withoutADirectoryOfItsOwnItSaysSoAndLoadsNothing() throws Exception {
        Path missing = folder.resolve("missing");
        Path home = folder.resolve("no-home");
        Process program =
                Program.start(List.of("-Djava.io.tmpdir=" + missing, "-Duser.home=" + home), "--port", "/dev/null");
        // Newer JDKs warn about the folder, too.
        assertThat(program.inputReader().lines())
                .last()
                .isEqualTo("error: the native library libjnidispatch.so cannot be unpacked and loaded (no folder can"
                        + " be made in " + missing + "; no folder can be made in " + home + "); name a folder that can"
                        + " be written to with java -Djava.io.tmpdir=FOLDER");
        assertThat(program.waitFor()).isEqualTo(2);
    }

    private void assertLoadsPrivately(Set<String> libraries, String... arguments) throws Exception {
        Path home = folder.resolve("no-home");
        Process program = Program.start(List.of("-Djava.io.tmpdir=" + everybodys, "-Duser.home=" + home), arguments);
        try {
            await().atMost(Duration.ofSeconds(60))
                    .until(
                            () -> loaded(program)
                                    .map(Path::getFileName)
                                    .map(Path::toString)
                                    .collect(Collectors.toSet()),
                            names -> names.containsAll(libraries));
            assertThat(loaded(program).filter(library -> library.startsWith(folder)))
                    .allSatisfy(library -> assertThat(
                                    library.getParent().getFileName().toString())
                            .startsWith("evoloop-native-"));
            program.getOutputStream().close();
            assertThat(program.waitFor()).isZero();
        } finally {
            program.destroyForcibly();
        }
        assertThat(precious).hasContent("precious");
        try (Stream<Path> left = Files.list(everybodys)) {
            assertThat(left.map(Path::getFileName).map(Path::toString)).containsExactly("jSerialComm");
        }
    }

    /** The shared libraries that a process has loaded, including those whose files are gone. */
    private static Stream<Path> loaded(Process process) throws IOException {
        return Files.readAllLines(Path.of("/proc", Long.toString(process.pid()), "maps")).stream()
                .map(line -> line.split(" +", 6))
                .filter(words -> words.length == 6 && words[5].contains(".so"))
                .map(words -> Path.of(words[5].replace(" (deleted)", "")))
                .distinct();
    }
}
