package org.evoloop.roomba.simulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.concurrent.TimeUnit;
import org.evoloop.natives.Pty;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

@EnabledOnOs(OS.LINUX)
@Timeout(60)
class SimulatorCommandTest {
    private static final SimulatedRoomba ANY_ROBOT = new SimulatedRoomba(RobotOptions.defaults(), bytes -> {});

    @TempDir
    Path folder;

    private final StringWriter output = new StringWriter();
    private final StringWriter errors = new StringWriter();

    private int run(String input, String... arguments) {
        CommandLine line =
                new CommandLine(new SimulatorCommand(new ByteArrayInputStream(input.getBytes(StandardCharsets.UTF_8))));
        return line.setOut(new PrintWriter(output))
                .setErr(new PrintWriter(errors))
                .execute(arguments);
    }

    @Test
    void itReportsThatItIsReadyAnswersAndQuits() {
        Path link = folder.resolve("roomba");
        int exitCode = run("press clean\nnonsense\nexit\nstate\n", "--link", link.toString());
        assertThat(output.toString().lines())
                .containsExactly(
                        "ready " + link,
                        "ok",
                        "error: 'nonsense' is not a command; there are " + new WorldCommands(ANY_ROBOT).execute("help"),
                        "ok");
        assertThat(errors.toString()).isEmpty();
        assertThat(exitCode).isZero();
        assertThat(Files.exists(link, LinkOption.NOFOLLOW_LINKS)).isFalse();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--speed 1             | Missing required option: '--link=PATH'",
                "--link L --speed fast | Invalid value for option '--speed': 'fast' is not a double",
                "--link L --speed 0    | cannot start the simulator: speed is 0.0; allowed is 0.01 to 1000.0 times "
                        + "real time",
                "--link L --spot-duration 1 | cannot start the simulator: spot duration is 1000 ms; allowed is 8000 "
                        + "to 600000 ms",
                "--link L --battery 0 | cannot start the simulator: battery is 0 %; allowed is 1 to 100 %",
                "--link L --drop 0.6 | cannot start the simulator: drop is 0.6; allowed is 0 to 0.5",
                "--link L --firmware x | Invalid value for option '--firmware': 'x' is not a firmware version; write "
                        + "one such as 3.2.6",
                "--link L --checksum md5 | Invalid value for option '--checksum': 'md5' is unknown; there are real "
                        + "and spec500",
                "--link L --room none.txt | cannot start the simulator: none.txt: cannot be read; it must be an "
                        + "existing, readable text file",
                "--link L --svg no/such/folder.svg | cannot write no/such/folder.svg (--svg); its folder must exist "
                        + "and be writable",
                "--link L --camera 70000 | cannot start the simulator: camera port is 70000; allowed is 0 to 65535",
                "--link L --camera web | Invalid value for option '--camera': 'web' is not an int",
                "--link L --camera-fps 5 | cannot start the simulator: --camera-quality, --camera-size, --camera-fov "
                        + "and --camera-fps go with --camera PORT",
                "--link L --camera 0 --camera-quality best | cannot start the simulator: camera quality is 'best'; "
                        + "there are clean, typical and hard",
                "--link L --camera 0 --camera-size big | cannot start the simulator: --camera-size is 'big'; it takes "
                        + "WxH in pixels, for example 640x480",
                "--link L --camera 0 --camera-size 8x480 | cannot start the simulator: picture width in pixels is 8; "
                        + "allowed is 16 to 1920",
                "--link L --camera 0 --camera-fov 180 | cannot start the simulator: field of view in degrees is 180; "
                        + "allowed is 20 to 120",
                "--link L --camera 0 --camera-fps 0 | cannot start the simulator: camera frames per second are 0.0; "
                        + "allowed is 0.1 to 60",
                "--link . | cannot start the simulator: . exists and is not a symbolic link; remove it or choose "
                        + "another path",
            })
    void aWrongOptionIsOneClearMessageAndCode2(String arguments, String message) {
        assertThat(run(
                        "",
                        arguments
                                .replace("L", folder.resolve("roomba").toString())
                                .split(" ")))
                .isEqualTo(2);
        assertThat(errors.toString().lines().findFirst()).contains(message);
        assertThat(output.toString()).isEmpty();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void allMistakesAreReportedAtOnce() {
        String link = folder.resolve("roomba").toString();
        assertThat(run("", "--link", link, "--battery", "101", "--baud", "9601", "--mode-offset", "2"))
                .isEqualTo(2);
        assertThat(errors.toString())
                .contains("battery is 101 %; allowed", "baud is 9601; allowed", "mode offset is 2; allowed");
    }

    @Test
    void aRoomsMistakeNamesFileAndLine() throws IOException {
        Path room = Files.writeString(folder.resolve("room.txt"), "wall 0 0 5000 4000\nsofa 1 2 3 4\n");
        assertThat(run("", "--link", folder.resolve("roomba").toString(), "--room", room.toString()))
                .isEqualTo(2);
        assertThat(errors.toString().lines().findFirst())
                .contains("cannot start the simulator: " + room
                        + ", line 2: 'sofa' is unknown; a line begins with wall,"
                        + " obstacle, cliff, dock, start or marker");
    }

    @Test
    void aCameraPrintsItsAddress() {
        String link = folder.resolve("roomba").toString();
        assertThat(run("camera stall\nexit\n", "--link", link, "--camera", "0", "--camera-size", "320x240"))
                .isZero();
        assertThat(output.toString().lines()).hasSize(4).first().isEqualTo("ready " + link);
        assertThat(output.toString().lines().skip(1).findFirst().orElseThrow())
                .matches("camera http://127\\.0\\.0\\.1:\\d+/stream");
    }

    @Test
    void aTakenPortIsOneClearMessageAndCode2() throws IOException {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String port = Integer.toString(taken.getLocalPort());
            assertThat(run("", "--link", folder.resolve("roomba").toString(), "--camera", port))
                    .isEqualTo(2);
            assertThat(errors.toString().lines().findFirst())
                    .contains("cannot start the simulator: the camera's port " + port
                            + " cannot be used (Address already in use); choose another, or 0 for any that is free");
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void theDrawingIsWrittenAtTheEnd() throws IOException {
        Path svg = folder.resolve("room.svg");
        assertThat(run("dock\nexit\n", "--link", folder.resolve("roomba").toString(), "--svg", svg.toString()))
                .isZero();
        assertThat(svg).content().startsWith("<svg ").endsWith("</svg>\n");
    }

    @Test
    void theEndOfInputIsItsEnd() {
        Path link = folder.resolve("roomba");
        assertThat(run("press clean\n", "--link", link.toString())).isZero();
        assertThat(output.toString().lines()).containsExactly("ready " + link, "ok");
        assertThat(Files.exists(link, LinkOption.NOFOLLOW_LINKS)).isFalse();
    }

    @Test
    void thePortOfALivingSimulatorIsRefusedAndOneLeftBehindIsTaken() throws Exception {
        Path link = folder.resolve("roomba");
        try (Clock clock = new SystemClock();
                SimulatorServer living = SimulatorServer.start(link, RobotOptions.defaults(), clock, 1)) {
            Path port = Files.readSymbolicLink(link);
            assertThat(run("exit\n", "--link", link.toString())).isEqualTo(2);
            assertThat(errors.toString().lines().findFirst())
                    .contains("cannot start the simulator: " + link + " is the port of a running simulator, " + port
                            + "; end that one or choose another path");
            assertThat(Files.readSymbolicLink(link)).isEqualTo(port);
            assertThat(living.robot().state().timeMillis()).isNotNegative();
        }
        Process killed = inBackground(link);
        killed.destroyForcibly().waitFor();
        assertThat(link).as("left behind").isSymbolicLink();
        assertThat(run("exit\n", "--link", link.toString())).isZero();

        Files.createSymbolicLink(link, Path.of("/dev/pts/31415"));
        assertThat(run("exit\n", "--link", link.toString())).isZero();
    }

    @Test
    void aYoungerTerminalAtTheEndOfAnOldLinkIsNotTheSimulators() throws Exception {
        Path link = folder.resolve("roomba");
        try (Pty early = Pty.open()) {
            Files.createSymbolicLink(link, early.slavePath());
        }
        // The kernel assigns the lowest free number; until its clock ticks, both have the same age.
        Pty younger = Pty.open();
        while (changed(younger.slavePath()).compareTo(changed(link)) <= 0) {
            younger.close();
            younger = Pty.open();
        }
        try (Pty terminal = younger) {
            assertThat(Files.readSymbolicLink(link)).isEqualTo(terminal.slavePath());
            assertThat(run("exit\n", "--link", link.toString())).isZero();
        }
    }

    private static FileTime changed(Path path) throws IOException {
        return (FileTime) Files.getAttribute(path, "unix:ctime", LinkOption.NOFOLLOW_LINKS);
    }

    private static Process inBackground(Path link) throws IOException {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "--enable-native-access=ALL-UNNAMED",
                        "-XX:+UseSerialGC",
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        System.getProperty("java.class.path"),
                        Program.class.getName(),
                        "--keep-running",
                        "--link",
                        link.toString())
                .redirectErrorStream(true)
                .start();
        process.getOutputStream().close();
        assertThat(process.inputReader().readLine()).isEqualTo("ready " + link);
        return process;
    }

    @Test
    void onRequestItContinuesAtTheEndOfInputAndASignalEndsIt() throws Exception {
        Path link = folder.resolve("roomba");
        Process process = inBackground(link);
        try {
            assertThat(process.isAlive()).isTrue();
            assertThat(link).isSymbolicLink();
            process.destroy();
            assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
            assertThat(process.exitValue()).isZero();
            assertThat(Files.exists(link, LinkOption.NOFOLLOW_LINKS)).isFalse();
        } finally {
            process.destroyForcibly();
        }
    }

    /** The command as a process of its own. */
    static final class Program {
        private Program() {}

        public static void main(String[] arguments) {
            System.exit(new CommandLine(new SimulatorCommand()).execute(arguments));
        }
    }
}
