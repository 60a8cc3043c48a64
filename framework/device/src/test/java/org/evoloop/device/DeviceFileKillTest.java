package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.JavaProcess;
import org.evoloop.imitation.Faults;
import org.evoloop.imitation.Imitation;
import org.evoloop.mqtt.Gateway;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.Watcher;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * Whenever the converter of a device file, the broker or the device is killed, the record agrees with the device again, and
 * nothing is in doubt. Nothing is sent twice, nor anything that nobody asked for.
 */
@EnabledOnOs(OS.LINUX)
class DeviceFileKillTest {
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(60);
    private static final Pattern STATUS = Pattern.compile(
            "\"originalState\":\"(?<device>\\w+)\",\"newState\":\"(?<system>\\w+)\".*?\"doubt\":\"(?<doubt>[^\"]*)\"");

    private static final StateMachine HEATER = StateMachine.named("original")
            .initial("Off")
            .transition("Off", "power", "Warm")
            .transition("Warm", "power", "Off")
            .transition("Warm", "level", "Hot")
            .transition("Hot", "level", "Warm")
            .transition("Hot", "power", "Off")
            .build();

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
            ```
            """;

    private static final String FILE = """
            converter: heater
            models: {original: heater.md#original, new: heater.md#new}
            connections:
              broker: {mqtt: "BROKER", command-topic: heater/set, state-topic: heater}
            device:
              send: {power: "power ${number}", level: "level ${number}"}
              state: {json: /state, values: {Off: "Off", Warm: Warm, Hot: Hot}}
              confirmed: {within: 1 s}
              ask: {topic: heater/get, payload: ""}
            controller:
              press:
                - {topic: remote, pattern: "power (?<number>[0-9]+)", event: power}
                - {topic: remote, pattern: "level (?<number>[0-9]+)", event: level}
                - {topic: remote, pattern: "boost (?<number>[0-9]+)", event: boost}
            """;

    @TempDir
    private Path folder;

    private final long seed = Long.getLong("evoloop.seed", new Random().nextLong());
    private final Random random = new Random(seed);
    private final List<String> story = new ArrayList<>();
    private final Imitation device = new Imitation(HEATER, Faults.NONE, seed);
    private final List<Integer> mostCommands = new ArrayList<>();
    private int starts;
    private Process converter;

    @Test
    void someKills() throws Exception {
        kill(9);
    }

    @Test
    @Tag("slow")
    void manyKills() throws Exception {
        kill(200);
    }

    private void kill(int times) throws Exception {
        Files.writeString(folder.resolve("heater.md"), MODELS);
        try (Mosquitto broker = new Mosquitto(folder).start();
                Gateway gateway = new Gateway(broker, "heater", device)) {
            Files.writeString(folder.resolve("heater.yaml"), FILE.replace("BROKER", broker.url()));
            start();
            for (int kill = 0; kill < times; kill++) {
                killOne(broker, kill);
            }
        } catch (AssertionError | InterruptedException failed) {
            throw new AssertionError("seed " + seed + "\n" + String.join("\n", story) + "\n" + device.log(), failed);
        } finally {
            device.close();
            converter.destroyForcibly().waitFor();
        }
        assertThat(device.logged("obeys")).isGreaterThan(times / 4);
        System.out.println(times + " kills, seed " + seed + ": " + device.logged("obeys") + " commands were obeyed");
    }

    private void killOne(Mosquitto broker, int kill) throws Exception {
        settle();
        String at = device.truth();
        List<String> events = at.equals("Off") ? List.of("power", "boost") : List.of("power", "level");
        String event = events.get(random.nextInt(events.size()));
        press(broker, event + " " + kill);
        TimeUnit.MICROSECONDS.sleep(random.nextInt(30_000));
        int whom = kill % 3;
        story.add("press " + event + " in " + at + ", kills "
                + List.of("converter", "broker", "device").get(whom));
        switch (whom) {
            case 0 -> {
                converter.destroyForcibly().waitFor();
                start();
            }
            case 1 -> {
                broker.stop();
                broker.start();
            }
            default -> device.restart();
        }
        settle();
        // A device that forgets where it was is brought there again.
        mostCommands.add((event.equals("boost") ? 2 : 1) * (whom == 2 ? 2 : 1));
        for (int press = 0; press <= kill; press++) {
            assertThat(commandsFor(press))
                    .as("commands for press %d", press)
                    .isLessThanOrEqualTo(mostCommands.get(press));
        }
    }

    private long commandsFor(int press) {
        return device.log().stream()
                .filter(line -> line.startsWith("obeys ") && line.contains(" " + press + ","))
                .count();
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
                        folder.resolve("heater.yaml").toString(),
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

    /** Waits until the record agrees with the device, twice in a row. */
    private void settle() throws Exception {
        PrintWriter console = new PrintWriter(converter.getOutputStream(), true, StandardCharsets.UTF_8);
        long limit = System.nanoTime() + PATIENCE_NANOS;
        String last = "";
        for (int agreeing = 0; agreeing < 2; ) {
            assertThat(converter.isAlive() && System.nanoTime() < limit)
                    .as("the record %s agrees with the device in %s: %s", last, device.truth(), tail())
                    .isTrue();
            long answers = answers();
            console.println("status --json");
            while (answers() == answers && converter.isAlive() && System.nanoTime() < limit) {
                TimeUnit.MILLISECONDS.sleep(5);
            }
            last = lastStatus();
            Matcher status = STATUS.matcher(last);
            boolean agrees = status.find()
                    && status.group("doubt").isEmpty()
                    && status.group("device").equals(device.truth())
                    && status.group("system").equals(status.group("device"))
                    && last.contains("\"loop\":\"running\"")
                    && last.contains("\"link\":{\"up\":true");
            agreeing = agrees ? agreeing + 1 : 0;
        }
    }

    private String tail() throws IOException {
        List<String> lines = Files.readAllLines(said(starts));
        return String.join("\n", lines.subList(Math.max(0, lines.size() - 30), lines.size()));
    }

    private long answers() throws IOException {
        return Files.readAllLines(said(starts)).stream()
                .filter(line -> line.contains("\"originalState\""))
                .count();
    }

    private String lastStatus() throws IOException {
        return Files.readAllLines(said(starts)).stream()
                .filter(line -> line.contains("\"originalState\""))
                .reduce("", (first, second) -> second);
    }
}
