package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.evoloop.config.Options;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.Watcher;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** Functions that run in another program, by its standard input and output or behind a real broker. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class DeviceElsewhereTest {
    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Low : power
                Low --> Off : power
                Low --> High : speed
                High --> Low : speed
                High --> Off : power
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Low : power
                Low --> Off : power
                Low --> High : speed
                High --> Low : speed
                High --> Off : power
                Low --> Breeze : breeze
                High --> Breeze : breeze
                Breeze --> Off : power
                Breeze --> Low : calm
            ```
            """;

    private static final String FAN = """
            converter: fan
            models: {original: fan.md#original, new: fan.md#new}
            connections:
              fan: {program: [cat]}
              away: {AWAY}
            device:
              send: {power: {to: fan, line: PWR}, speed: {to: fan, line: SPD}}
            functions:
              Breeze: {elsewhere: away, sends: [speed], raises: [calm]}
            """;

    /** It changes the speed at each start, is calm when it is told so, and dies if there is a file for that. */
    private static final String SHELL = """
            while read line; do
              visit=${line#*'"visit":'}
              visit=${visit%%,*}
              case $line in
                *'"start"'*)
                  echo starts >> log
                  if [ -e die ]; then rm die; exit 3; fi
                  echo "{\\"do\\":\\"send\\",\\"visit\\":$visit,\\"event\\":\\"speed\\"}" ;;
                *'"stop"'*) echo stops >> log ;;
              esac
            done
            """;

    @RegisterExtension
    private final TypedConsole console = new TypedConsole();

    @TempDir
    private Path folder;

    @BeforeEach
    void draw() throws IOException {
        Files.writeString(folder.resolve("fan.md"), MODELS);
    }

    private Path file(String away) throws IOException {
        return Files.writeString(folder.resolve("fan.yaml"), FAN.replace("AWAY", away));
    }

    private Path shell() throws IOException {
        Path script = Files.writeString(folder.resolve("breeze.sh"), "cd " + folder + "\n" + SHELL);
        return file("program: [sh, " + script + "]");
    }

    static boolean hasPython() {
        try {
            return new ProcessBuilder("python3", "--version").start().waitFor() == 0;
        } catch (IOException none) {
            return false;
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    private void awaitFault() {
        await("a fault in the status").until(() -> {
            console.type("status --all");
            return console.printed().contains("ended in the middle of the visit");
        });
    }

    @Test
    @EnabledIf("hasPython")
    void theExampleOfTheDocumentationChangesTheSpeed() throws Exception {
        String page = Files.readString(Path.of("../../docs/device-files.md"));
        String example = Pattern.compile("```python\\n(.*?)```", Pattern.DOTALL)
                .matcher(page)
                .results()
                .map(MatchResult::group)
                .map(block -> block.replaceAll("```(python\\n)?", ""))
                .findFirst()
                .orElseThrow();
        assertThat(example.lines().count()).isLessThanOrEqualTo(20);
        Path program = Files.writeString(folder.resolve("gusts.py"), example);
        CompletableFuture<Integer> status = console.run(file("program: [python3, " + program + "]"), "--start");
        console.awaitStatus("link        up");
        console.type("press power");
        console.type("press breeze");
        console.awaitHistory("speed (asked by a function)  (Low, Breeze) -> (High, Breeze)");
        console.type("press power");
        console.awaitHistory("Breeze) -> (Off, Off)");
        console.exit(status);
    }

    @Test
    void aProgramThatDiesInTheMiddleOfAVisitIsStartedAgainForTheNextOne() throws Exception {
        Files.createFile(folder.resolve("die"));
        CompletableFuture<Integer> status = console.run(shell(), "--start");
        console.awaitStatus("link        up");
        console.type("press power");
        console.type("press breeze");
        awaitFault();
        console.type("press power");
        console.awaitStatus("link        up");
        console.type("press power");
        console.type("press breeze");
        console.awaitHistory("speed (asked by a function)  (Low, Breeze) -> (High, Breeze)");
        console.type("press power");
        await().until(() -> Files.readAllLines(folder.resolve("log")).contains("stops"));
        assertThat(Files.readAllLines(folder.resolve("log")))
                .startsWith("starts")
                .contains("stops");
        console.exit(status);
    }

    @Test
    void aProgramBehindABrokerRunsAFunctionToo() throws Exception {
        try (Mosquitto broker = new Mosquitto(folder).start();
                Watcher watcher = new Watcher(broker)) {
            CompletableFuture<Integer> status = console.run(file("mqtt: " + broker.url()), "--start");
            console.awaitStatus("link        up");
            console.type("press power");
            console.type("press breeze");
            watcher.awaitHeard("evoloop/fan/function/Breeze/start", "\"visit\":3");
            watcher.publish("evoloop/fan/function/Breeze/finish", "{\"visit\":2,\"event\":\"calm\"}", false);
            watcher.publish("evoloop/fan/function/Breeze/send", "{\"visit\":3,\"event\":\"speed\"}", false);
            console.awaitHistory("speed (asked by a function)  (Low, Breeze) -> (High, Breeze)");
            watcher.publish("evoloop/fan/function/Breeze/finish", "{\"visit\":3,\"event\":\"calm\"}", false);
            watcher.awaitHeard("evoloop/fan/function/Breeze/stop", "\"visit\":3");
            console.awaitHistory("calm (function)  (High, Breeze) -> (Low, Low)");

            console.type("press breeze");
            watcher.awaitHeard("evoloop/fan/function/Breeze/start", "\"visit\":5");
            watcher.publish("evoloop/fan/function/Breeze/fail", "{}", false);
            awaitFault();
            console.exit(status);
        }
    }

    @Test
    void aPlayedDeviceHasNoPrograms() throws Exception {
        CompletableFuture<Integer> status = console.run(shell(), "--simulate", "--start");
        console.awaitStatus("fan, running");
        console.type("press power");
        console.type("press breeze");
        await().until(() -> console.printed().contains("the function of Breeze runs at away"));
        console.exit(status);
        assertThat(folder.resolve("log")).doesNotExist();
    }

    @Test
    void whatAFunctionSaysIsCheckedAgainstTheModels() throws IOException {
        Path wrong = Files.writeString(
                folder.resolve("fan.yaml"),
                FAN.replace("AWAY", "gpio: true").replace("[speed]", "[sped]").replace("[calm]", "[clam]"));
        assertThatThrownBy(() -> DeviceFile.read(wrong, Options.of()))
                .isInstanceOf(DeviceFileException.class)
                .hasMessageContaining(
                        "fan.yaml:9: 'sped' is not an event that is sent to the device; did you mean speed?")
                .hasMessageContaining("fan.yaml:9: the new model has no transition for 'clam' in Breeze")
                .hasMessageContaining("fan.yaml:9: connection away, of the kind gpio, runs no functions");
    }
}
