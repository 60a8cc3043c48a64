package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.JavaProcess;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.Watcher;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * Whenever the converter of a device file, the broker, the device, or the program of a function is killed, the record agrees with the device again, and
 * nothing is in doubt. Nothing is sent twice, nor anything that nobody asked for.
 */
@EnabledOnOs(OS.LINUX)
class DeviceFileKillTest {
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(60);
    private static final Pattern STATUS = Pattern.compile(
            "\"originalState\":\"(?<device>\\w+)\",\"newState\":\"(?<system>\\w+)\".*?\"doubt\":\"(?<doubt>[^\"]*)\"");

    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Warm : power
                Warm --> Off : power
                Warm --> Hot : level
                Hot --> Warm : level
                Hot --> Off : power
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Warm : power
                Warm --> Off : power
                Warm --> Hot : level
                Hot --> Warm : level
                Hot --> Off : power
                Off --> Hot : boost
                Off --> Soak : soak
                Soak --> Hot : soaked
                Soak --> Off : power
            ```
            """;

    private static final String FILE = """
            converter: heater
            models: {original: heater.md#original, new: heater.md#new}
            connections:
              broker: {mqtt: "BROKER", command-topic: heater/set, state-topic: heater}
              soaking: {program: [sh, SOAKING]}
            device:
              send:
                power: {to: broker, payload: "power ${number}"}
                level: {to: broker, payload: "level ${number}"}
              state: {from: broker, json: /state, values: {Off: "Off", Warm: Warm, Hot: Hot}}
              confirmed: {within: 1 s}
              ask: {topic: heater/get, payload: ""}
            controller:
              press:
                - {from: broker, topic: remote, pattern: "power (?<number>[0-9]+)", event: power}
                - {from: broker, topic: remote, pattern: "level (?<number>[0-9]+)", event: level}
                - {from: broker, topic: remote, pattern: "boost (?<number>[0-9]+)", event: boost}
                - {from: broker, topic: remote, pattern: "soak (?<number>[0-9]+)", event: soak}
            functions:
              Soak: {elsewhere: soaking, sends: [power, level], raises: [soaked]}
            """;

    /** The function of Soak: it switches the heater on, makes it hot, and ends. Resumed, it only ends. */
    private static final String SOAKING = """
            while read line; do
              visit=${line#*'"visit":'}
              visit=${visit%%,*}
              number=${line#*'"number":"'}
              number=${number%%'"'*}
              say() { echo "{\\"do\\":\\"$1\\",\\"visit\\":$visit,\\"event\\":\\"$2\\",\\"values\\":{\\"number\\":\\"$number\\"}}"; }
              case $line in
                *'"start"'*'"new"'*)
                  say send power
                  say send level
                  say finish soaked ;;
                *'"start"'*) say finish soaked ;;
              esac
            done
            """;

    @TempDir
    private Path folder;

    private final long seed = Long.getLong("evoloop.seed", new Random().nextLong());
    private final Random random = new Random(seed);
    private final List<String> story = new ArrayList<>();
    private final List<Integer> mostCommands = new ArrayList<>();
    private String pressedIn = "";
    private int starts;
    private Process converter;
    private Process device;

    @Test
    void someKills() throws Exception {
        kill(12);
    }

    @Test
    @Tag("slow")
    void manyKills() throws Exception {
        kill(200);
    }

    private void kill(int times) throws Exception {
        Files.writeString(folder.resolve("heater.md"), MODELS);
        Path soaking = Files.writeString(folder.resolve("soaking.sh"), SOAKING);
        try (Mosquitto broker = new Mosquitto(folder).start()) {
            Files.writeString(file(), FILE.replace("BROKER", broker.url()).replace("SOAKING", soaking.toString()));
            Files.createFile(folder.resolve("device.log"));
            startDevice(broker);
            start();
            for (int kill = 0; kill < times; kill++) {
                killOne(broker, kill);
            }
        } catch (AssertionError | InterruptedException failed) {
            throw new AssertionError(
                    "seed " + seed + "\n" + String.join("\n", story) + "\n" + String.join("\n", log()), failed);
        } finally {
            device.destroyForcibly().waitFor();
            converter.destroyForcibly().waitFor();
        }
        long obeyed = log().stream().filter(line -> line.startsWith("obeys ")).count();
        assertThat(obeyed).isGreaterThan(times / 4);
        System.out.println(times + " kills, seed " + seed + ": " + obeyed + " commands were obeyed");
    }

    private void killOne(Mosquitto broker, int kill) throws Exception {
        String system = settle();
        boolean halfway = !system.equals("Soak") && !system.equals(truth());
        List<String> events = switch (system) {
            case "Off" -> halfway ? List.of("power") : List.of("power", "boost", "soak");
            case "Soak" -> List.of("power");
            default -> List.of("power", "level");
        };
        String event = events.get(random.nextInt(events.size()));
        pressedIn = system;
        press(broker, event + " " + kill);
        TimeUnit.MICROSECONDS.sleep(random.nextInt(30_000));
        Victim victim = Victim.values()[kill % Victim.values().length];
        story.add("press " + event + " in " + system + ", kills the " + victim);
        switch (victim) {
            case CONVERTER -> {
                converter.destroyForcibly().waitFor();
                start();
            }
            case BROKER -> {
                broker.stop();
                broker.start();
            }
            case DEVICE -> {
                device.destroyForcibly().waitFor();
                startDevice(broker);
            }
            case FUNCTION -> converter.descendants().forEach(ProcessHandle::destroyForcibly);
        }
        settle();
        // A device that forgets where it was is brought there again.
        boolean isOne = event.equals("power") || event.equals("level");
        mostCommands.add((isOne ? 1 : 2) * (victim == Victim.DEVICE ? 2 : 1));
        for (int press = 0; press <= kill; press++) {
            assertThat(commandsFor(press))
                    .as("commands for press %d", press)
                    .isLessThanOrEqualTo(mostCommands.get(press));
        }
    }

    private long commandsFor(int press) throws IOException {
        return log().stream()
                .filter(line -> line.startsWith("obeys ") && line.contains(" " + press + ","))
                .count();
    }

    private Path file() {
        return folder.resolve("heater.yaml");
    }

    /** What the device really did, in all its lives. */
    private List<String> log() throws IOException {
        return Files.readAllLines(folder.resolve("device.log"));
    }

    /** Where the device really is. */
    private String truth() throws IOException {
        return log().stream().reduce("", (before, line) -> line).replaceFirst(".* ", "");
    }

    /** Starts it, and waits until it is in its first state. */
    private void startDevice(Mosquitto broker) throws IOException {
        int lines = log().size();
        device = new ProcessBuilder(JavaProcess.command(
                        KilledDevice.class,
                        file().toString(),
                        Integer.toString(broker.port()),
                        "heater",
                        folder.resolve("device.log").toString()))
                .inheritIO()
                .start();
        await().atMost(Duration.ofSeconds(60)).until(() -> log().size() > lines);
    }

    private void press(Mosquitto broker, String event) throws Exception {
        try (Watcher remote = new Watcher(broker)) {
            remote.publish("remote", event, false);
        }
    }

    private void start() throws IOException {
        Path said = said(++starts);
        converter = new ProcessBuilder(JavaProcess.command(
                        KilledConverter.class,
                        file().toString(),
                        "--start",
                        "--journal",
                        folder.resolve("journal").toString()))
                .redirectErrorStream(true)
                .redirectOutput(said.toFile())
                .start();
    }

    private Path said(int number) {
        return folder.resolve("converter-" + number + ".log");
    }

    /**
     * Waits until the record agrees with the device, twice in a row. Returns the state of the new model: the device's,
     * Soak, or where the last press began if the link was lost between its steps, so that it has failed halfway.
     */
    private String settle() throws Exception {
        PrintWriter console = new PrintWriter(converter.getOutputStream(), true, StandardCharsets.UTF_8);
        long limit = System.nanoTime() + PATIENCE_NANOS;
        String system = "";
        for (int agreeing = 0; agreeing < 2; ) {
            assertThat(converter.isAlive() && System.nanoTime() < limit)
                    .as("the record agrees with the device in %s: %s", truth(), tail())
                    .isTrue();
            int answers = answers().size();
            console.println("status --json");
            await().pollInterval(Duration.ofMillis(5))
                    .atMost(Duration.ofSeconds(60))
                    .until(() -> answers().size() > answers || !converter.isAlive());
            String last = answers().stream().reduce("", (before, answer) -> answer);
            Matcher status = STATUS.matcher(last);
            boolean agrees = status.find()
                    && status.group("doubt").isEmpty()
                    && status.group("device").equals(truth())
                    && (status.group("system").equals(truth())
                            || status.group("system").equals("Soak")
                            || status.group("system").equals(pressedIn) && hasFailed(last))
                    && last.contains("\"loop\":\"running\"")
                    && last.contains("\"link\":{\"up\":true");
            agreeing = agrees ? agreeing + 1 : 0;
            system = agrees ? status.group("system") : "";
        }
        return system;
    }

    /** Whether a step was not sent, and nothing goes on. */
    private static boolean hasFailed(String status) {
        return status.contains("was not sent\"")
                && status.contains("\"waiting\":0")
                && status.contains("\"inProgress\":0");
    }

    private String tail() throws IOException {
        List<String> lines = Files.readAllLines(said(starts));
        return String.join("\n", lines.subList(Math.max(0, lines.size() - 30), lines.size()));
    }

    private List<String> answers() throws IOException {
        return Files.readAllLines(said(starts)).stream()
                .filter(line -> line.contains("\"originalState\""))
                .toList();
    }

    private enum Victim {
        CONVERTER,
        BROKER,
        DEVICE,
        FUNCTION
    }
}
