package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The program's options in a file, from a user's view. */
@EnabledOnOs(OS.LINUX)
@Timeout(180)
class ConfigTest {
    private static final Path ROOT = Path.of(System.getProperty("evoloop.root"));

    @TempDir
    Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("roomba.yaml"), text);
    }

    @Test
    void allMistakesAreOneMessageAndNothingStarts() throws Exception {
        Path file = file("""
                program: roomba
                prot: /dev/ttyUSB0
                port: /dev/ttyUSB0
                simulate: true
                speed: fast
                clean-at: [08:00, 25:00]
                quiet-hours: 22:00
                models: gone.xml
                mqtt: mqtt://ha:s3cret@b
                page: 99999
                camera-fov: 60
                field-of-view: 70
                start-point: [1, 2, 3]
                journal:
                """);
        Program.Result result = Program.run(folder, "--spot-wait", "0", "--config", file.toString());
        assertThat(result.err().replace(folder + "/", "").lines())
                .satisfiesExactly(
                        line -> assertThat(line).isEqualTo("error: the options have 12 mistakes:"),
                        line -> assertThat(line).isEqualTo("  --spot-wait is 0.0, allowed is 0.1 to 3600 seconds"),
                        line -> assertThat(line)
                                .isEqualTo("  roomba.yaml:2: there is no option prot; did you mean port?"),
                        line -> assertThat(line).isEqualTo("  roomba.yaml:3: choose a robot: port PATH or simulate"),
                        line -> assertThat(line).isEqualTo("  roomba.yaml:5: speed: 'fast' is not a number"),
                        line -> assertThat(line).startsWith("  roomba.yaml:6: clean-at is 25:00; give a time of day"),
                        line -> assertThat(line).startsWith("  roomba.yaml:7: quiet-hours is 22:00; give two times"),
                        line -> assertThat(line)
                                .isEqualTo("  roomba.yaml:8: gone.xml: does not exist; correct the path"),
                        line -> assertThat(line)
                                .startsWith(
                                        "  roomba.yaml:9: mqtt: the broker's URL mqtt://ha:***@b contains a password"),
                        line -> assertThat(line).startsWith("  roomba.yaml:10: page takes a port"),
                        line -> assertThat(line)
                                .isEqualTo(
                                        "  roomba.yaml:12: field-of-view is given twice, first in line 11; keep one"),
                        line -> assertThat(line).startsWith("  roomba.yaml:13: start-point takes two numbers"),
                        line -> assertThat(line).startsWith("  roomba.yaml:14: there is no value; write one"));
        assertThat(result.out()).isEmpty();
        assertThat(result.status()).isEqualTo(2);
    }

    @Test
    void whatIsInForceIsPrintedAndCanBeGivenBack() throws Exception {
        Path secret = Files.writeString(folder.resolve("secret"), "s3cret");
        Path file =
                file("port: /dev/ttyUSB0\nmqtt: mqtt://ha@broker\nmqtt-password-file: secret\nfunction: Move=Move\n");
        Program.Result first =
                Program.run(folder, "--config", file.toString(), "--simulate", "--speed", "4", "--print-config");
        assertThat(first.err()).isEmpty();
        assertThat(first.status()).isZero();
        assertThat(first.out().replaceAll(" +", " ").lines())
                .contains(
                        "program: roomba # what this file is for",
                        "simulate: true # command line",
                        "# port: # default: not set",
                        "speed: 4 # command line",
                        "search-limit: 300 # default",
                        "function: Move=Move # " + file + ":4",
                        "mqtt: 'mqtt://ha@broker' # " + file + ":2",
                        "# mqtt-password: (set, from " + secret + ")")
                .noneMatch(line -> line.contains("s3cret"));

        Path again = Files.writeString(folder.resolve("again.yaml"), first.out());
        Program.Result second = Program.run(folder, "--print-config", "--config", again.toString());
        assertThat(withoutOrigins(second.out())).isEqualTo(withoutOrigins(first.out()));
        assertThat(second.status()).isZero();
    }

    @Test
    void thePasswordInACamerasAddressIsNotPrinted() throws Exception {
        Path file = file("camera: http://me:s3cret@camera/stream?pwd=s3cret\n");
        for (List<String> given :
                List.of(List.of("--config", file.toString()), List.of("--camera", "http://me:s3cret@camera/?s3cret"))) {
            List<String> arguments = new ArrayList<>(given);
            arguments.add("--print-config");
            Program.Result result = Program.run(folder, arguments.toArray(String[]::new));
            assertThat(result.out()).contains("camera: 'http://***@camera/").doesNotContain("s3cret");
            assertThat(result.err()).isEmpty();
            assertThat(result.status()).isZero();
        }
    }

    /** What is no password in an address is shown as it is, so that the output is the same setting. */
    @Test
    void aCamerasAddressWithoutAPasswordIsShownAsItIs() throws Exception {
        Program.Result result = Program.run(folder, "--camera", "http://camera:8080/feed@2x", "--print-config");
        assertThat(result.out()).contains("camera: 'http://camera:8080/feed@2x'");
        assertThat(result.status()).isZero();
    }

    @Test
    void aJournalThatCannotBeContinuedIsFoundWithoutAStart() throws Exception {
        Path none = Files.createDirectory(folder.resolve("journal"));
        Files.writeString(none.resolve("0000000001.journal"), "no segment of a journal");
        Path file = file("simulate: true\njournal: journal\n");
        Program.Result result = Program.run(folder, "--config", file.toString(), "--print-config");
        assertThat(result.err())
                .contains(file + ":2: " + none.resolve("0000000001.journal")
                        + ", byte 0: it does not begin with EVOLOOPJ");
        assertThat(result.status()).isEqualTo(2);
    }

    /** A start builds the converter before it contacts the robot; printing the options does so, too. */
    @Test
    void whatBuildingRefusesIsFoundWithoutAStart() throws Exception {
        for (String[] given : new String[][] {{"--mode-offset", "7"}, {"--name", "n".repeat(120)}}) {
            List<String> arguments = new ArrayList<>(List.of(given));
            arguments.add("--simulate");
            Program.Result started = Program.run(folder, arguments.toArray(String[]::new));
            arguments.add("--print-config");
            Program.Result printed = Program.run(folder, arguments.toArray(String[]::new));
            assertThat(printed.err()).isNotEmpty().isEqualTo(started.err());
            assertThat(printed.status()).isEqualTo(2);
            assertThat(started.status()).isEqualTo(2);
        }
        Path broken = Files.writeString(folder.resolve("cleaning-robot.properties.txt"), "no property at all\n");
        Path models = Files.copy(ROOT.resolve("models/cleaning-robot.xml"), folder.resolve("cleaning-robot.xml"));
        Program.Result printed = Program.run(folder, "--models", models.toString(), "--print-config");
        assertThat(printed.err()).contains(broken.getFileName().toString());
        assertThat(printed.status()).isEqualTo(2);
    }

    private static String withoutOrigins(String printed) {
        return printed.replaceAll("(?m)  +# .*$", "");
    }

    @Test
    void theDefaultsCanBeLookedAtWithoutARobot() throws Exception {
        Program.Result result = Program.run(folder, "--print-config");
        assertThat(result.out()).contains("start: false").contains("# models:").contains("# port:");
        assertThat(result.err()).isEmpty();
        assertThat(result.status()).isZero();
    }

    @Test
    void theFilesOfGuideAndManualAreAccepted() throws Exception {
        String guide = Files.readString(ROOT.resolve("docs/configuration.md"));
        requireAccepted(guide.replaceFirst("(?s).*?```yaml\n(.*?)```.*", "$1"));
        String manual = Files.readString(ROOT.resolve("framework/package/man/evoloop.yaml.5"));
        requireAccepted(manual.replaceFirst("(?s).*\\.SH EXAMPLE\n\\.nf\n(.*?)\\.fi.*", "$1")
                .replace("\\-", "-")
                .replace("/usr/share/evoloop/models", "models"));
    }

    /** Beside the file are its models and its password. */
    private void requireAccepted(String text) throws Exception {
        Path file = file(text);
        Files.writeString(folder.resolve("mqtt-password"), "s3cret");
        Path models = Files.createDirectories(folder.resolve("models"));
        Files.copy(
                ROOT.resolve("models/roomba.xml"), models.resolve("roomba.xml"), StandardCopyOption.REPLACE_EXISTING);
        for (String[] more : new String[][] {{}, {"--simulate"}}) {
            List<String> arguments = new ArrayList<>(List.of("--config", file.toString(), "--print-config"));
            arguments.addAll(List.of(more));
            Program.Result result = Program.run(folder, arguments.toArray(String[]::new));
            assertThat(result.err()).isEmpty();
            assertThat(result.out()).contains("clean-at: ['MON,FRI 09:00', 'SAT 11:00']");
            assertThat(result.status()).isZero();
        }
    }

    @Test
    void aSimulatedRobotCanBeStartedWithAFileAlone() throws Exception {
        Path file = file("simulate: true\nspeed: 4\njournal: kept\n");
        Program.Result result = Program.runWithInput(folder, "start\nexit\n", "--config", file.toString());
        assertThat(result.status()).isZero();
        assertThat(folder.resolve("kept")).isDirectory();
    }
}
