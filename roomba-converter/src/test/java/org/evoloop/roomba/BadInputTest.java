package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.link.Link;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;
import org.evoloop.natives.Pty;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * An error that the user can fix is reported once and clearly on standard error; standard output stays empty, and the
 * status is 2.
 */
@EnabledOnOs(OS.LINUX)
@Timeout(180)
class BadInputTest {
    private static final Path MODELS = Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml");

    private static final String MACHINE = "<UML:StateMachine xmi.id=";

    @TempDir
    Path folder;

    private void assertRefused(String message, String... arguments) throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, arguments);
        assertThat(result.err()).isEqualTo(message + "\n");
        assertThat(result.out()).isEmpty();
        assertThat(result.status()).isEqualTo(2);
    }

    @Test
    void helpKnowsEveryCommand() throws Exception {
        Program.Result result = Program.run(folder, "--help");
        assertThat(result.out()).contains("--port=PATH", "simulator", "demo", "camera", "marker", "calibrate");
        assertThat(result.status()).isZero();
    }

    /** One process each: they share how input is read and errors are reported. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "edge --device a/b --port /dev/x --mqtt mqtt://h --journal j | error: --device is 'a/b'; MQTT takes no "
                        + "'/', '+', '#' or spaces in its name, 200 characters at most",
                "edge --device a --port /dev/x --mqtt h --journal j | error: the broker's URL h names no broker; give "
                        + "it as mqtt://HOST, mqtt://USER@HOST:1883 or mqtts://USER@HOST",
                "edge --device a --port /dev/x --mqtt mqtt://h --journal /dev/null/j | error: --journal: /dev/null/j "
                        + "cannot be used: /dev/null/j: Not a directory; give a directory that this program may write",
                "edge --device a --port /dev/x --mqtt mqtt://h --journal j --spot-wait 0 | error: --spot-wait is 0.0, "
                        + "allowed is 0.1 to 3600 seconds",
                "--simulate --port /dev/x | error: choose a robot: --port PATH or --simulate",
                "--speed 2 --port /dev/x | error: --speed goes with --simulate; a real robot has its own pace",
                "--room living-room --port /dev/x | error: --room goes with --simulate; a real robot is in a room already",
                "--simulate --room none.txt | error: none.txt: cannot be read; it must be an existing, readable text file",
                "--simulate --speed 0 | error: --speed is 0.0, allowed is 0.01 to 1000.0 times real time",
                "--simulate --speed fast | error: --speed: 'fast' is not a number",
                "--simulate --start-point 1 | error: --start-point takes two numbers, X,Y in mm, for example 1000,500",
                "--simulate --start-point 0,NaN | error: --start-point takes two numbers, X,Y in mm, for example "
                        + "1000,500",
                "--simulate --spot-wait 0 | error: --spot-wait is 0.0, allowed is 0.1 to 3600 seconds",
                "--simulate --quiet-hours 22:00-07:00 | error: --quiet-hours says when QuietHours waits, but it runs "
                        + "in no state of the new model; leave the option out, or draw a state that is left by "
                        + "quietOver",
                "--simulate --clean-at 09:00 | error: --clean-at raises schedule, which the new model does not know; "
                        + "leave the option out, or draw a transition for it",
                "--simulate --camera sim --record-limit 9 | error: --record-limit goes with --record; give both or "
                        + "neither",
                "--simulate --new models.xml | error: --original and --new go together, and not with --models; "
                        + "give both or neither",
                "--simulate --nonsense | error: there is no option --nonsense; see roomba --help",
                "demo --speed 0 | error: --speed is 0.0, allowed is 0.01 to 1000.0 times real time",
                "demo --scenario dance | error: there is no scenario dance; there are remote-start, spot-from-clean, "
                        + "own-button, timeout, evolve",
                "--simulate demo --scenario dance | error: there is no scenario dance; there are remote-start, "
                        + "spot-from-clean, own-button, timeout, evolve",
            })
    void optionsThatMakeNoSense(String arguments, String message) throws Exception {
        assertRefused(message, arguments.split(" "));
    }

    @Test
    void noRobotAtAll() throws Exception {
        assertRefused("error: choose a robot: --port PATH or --simulate");
    }

    @Test
    void noSuchModelFile() throws Exception {
        Path missing = folder.resolve("missing.xml");
        assertRefused(
                "error: " + missing + ": does not exist; correct the path",
                "--simulate",
                "--models",
                missing.toString());
    }

    @Test
    void aModelFileThatIsNotXml() throws Exception {
        Path text = Files.writeString(folder.resolve("text.xml"), "Off --Clean--> On");
        Program.Result result = Program.run(folder, "--simulate", "--models", text.toString());
        assertThat(result.err())
                .startsWith("error: " + text + ": is damaged or not XML")
                .endsWith("\n");
        assertThat(result.err().lines()).hasSize(1);
        assertThat(result.out()).isEmpty();
        assertThat(result.status()).isEqualTo(2);
    }

    @Test
    void aModelFileWithoutStateMachines() throws Exception {
        String models = Files.readString(MODELS);
        Path empty = Files.writeString(
                folder.resolve("empty.xml"),
                models.replaceAll("(?s)<XMI\\.content>.*</XMI\\.content>", "<XMI.content/>"));
        assertRefused(
                "error: " + empty + ": holds no state machine; draw one and export the file again",
                "--simulate",
                "--models",
                empty.toString());
    }

    @Test
    void aMachineThatIsNotInTheFile() throws Exception {
        Program.Result result =
                Program.run(folder, "--simulate", "--original", MODELS + "#old", "--new", MODELS + "#new");
        assertThat(result.err())
                .startsWith("error: " + MODELS + ": no state machine is named 'old'; there is 'original' (machine ")
                .contains("), 'new' (machine ");
        assertThat(result.err().lines()).hasSize(1);
        assertThat(result.out()).isEmpty();
        assertThat(result.status()).isEqualTo(2);
    }

    @Test
    void aNewModelThatLacksWhatTheDeviceHas() throws Exception {
        assertRefused(
                "error: the models '" + MODELS + "#new' and '" + MODELS + "#original' are not an evolution: "
                        + "Condition 1: event arriveSpot is missing in the new model; "
                        + "Condition 1: event timeout is missing in the new model; "
                        + "Condition 2: state Move is missing in the new model; "
                        + "Condition 2: state SpotWait is missing in the new model. "
                        + "The other way round they would be: are the two models swapped? "
                        + "The new model must keep every state and event of the device; names are case-sensitive",
                "--simulate",
                "--original",
                MODELS + "#new",
                "--new",
                MODELS + "#original");
    }

    @Test
    void aNewModelThatAsksForWhatNoEventLeadsTo() throws Exception {
        // The machine "new" is the second one in the file; its timeout transition is redirected to Off.
        String text = Files.readString(MODELS);
        int evolved = text.indexOf(MACHINE, text.indexOf(MACHINE) + 1);
        String off = idOf(text, evolved, "name=\"Off\"");
        String on = idOf(text, evolved, "name=\"On\"");
        int timeout = text.indexOf("name=\"timeout\"", evolved);
        int target = text.indexOf(on, text.indexOf("<UML:Transition.target>", timeout));
        Path changed = Files.writeString(
                folder.resolve("unreachable.xml"),
                text.substring(0, target) + off + text.substring(target + on.length()));

        assertRefused(
                "error: the model '" + changed + "#new' cannot be carried out:\n"
                        + "  no plan in (Clean, SpotWait): event timeout leads to Off, but with the device in Clean no "
                        + "events that can be sent take it there (sendable: Clean, Spot)",
                "--simulate",
                "--models",
                changed.toString());
    }

    private static String idOf(String text, int from, String attribute) {
        String before = text.substring(0, text.indexOf(attribute, from));
        String id = before.substring(before.lastIndexOf("xmi.id=\"") + "xmi.id=\"".length());
        return id.substring(0, id.indexOf('"'));
    }

    @Test
    void aPortThatDoesNotExist() throws Exception {
        Path missing = folder.resolve("ttyNone");
        Program.Result result = Program.run(folder, "--port", missing.toString());
        assertThat(result.err()).startsWith("error: serial port " + missing + " at 115200 baud does not exist");
        assertThat(result.err().lines()).hasSize(1);
        assertThat(result.out()).isEmpty();
        assertThat(result.status()).isEqualTo(2);
    }

    @Test
    void aPortThatAnotherProgramHas() throws Exception {
        try (Pty pty = Pty.open();
                Link other = SerialLink.open(new SerialSettings(pty.path().toString()))) {
            assertThat(other.loss()).isNull();
            assertRefused(
                    "error: " + new SerialSettings(pty.path().toString()) + " is in use by java (process "
                            + ProcessHandle.current().pid() + "); end it first",
                    "--port",
                    pty.path().toString());
        }
    }

    @Test
    void aRobotThatDoesNotAnswer() throws Exception {
        try (Pty pty = Pty.open()) {
            Program.Result result = Program.run(folder, "--port", pty.path().toString());
            String port = new SerialSettings(pty.path().toString()).toString();
            assertThat(result.err().lines())
                    .satisfiesExactly(
                            meanwhile -> assertThat(meanwhile)
                                    .endsWith(
                                            "WARN  " + port + ": no answer yet; it is woken by its wake line and asked "
                                                    + "again, then also at 19200 baud. If it sleeps, press CLEAN on it"),
                            atLast -> assertThat(atLast)
                                    .isEqualTo("error: " + port
                                            + ": no answer at 115200 nor 19200 baud; the robot is asleep or off, or "
                                            + "its cable is not plugged in. Press CLEAN to wake it, or plug the cable "
                                            + "in"));
            assertThat(result.out()).isEmpty();
            assertThat(result.status()).isEqualTo(2);
        }
    }
}
