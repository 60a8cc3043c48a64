package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The whole program, connected by pipes. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD) // reading from a pipe cannot be interrupted
class MainTest {
    private static final File ROOT = new File(System.getProperty("evoloop.root"));

    private @Nullable Process program;

    private Process program(File directory, String... options) throws IOException {
        Process started =
                new ProcessBuilder(command(options)).directory(directory).start();
        program = started;
        return started;
    }

    /** The command line of the program, without the test classes, which silence the log. */
    static List<String> command(String... options) {
        String classPath = Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .filter(entry -> !entry.endsWith("test-classes"))
                .collect(Collectors.joining(File.pathSeparator));
        List<String> command = new ArrayList<>(List.of(
                System.getProperty("java.home") + "/bin/java",
                // As in the program's manifest.
                "--enable-native-access=ALL-UNNAMED",
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-cp",
                classPath,
                LightBulb.class.getName()));
        command.addAll(List.of(options));
        return command;
    }

    @AfterEach
    void leaveNoProcess() {
        if (program != null) {
            program.destroyForcibly();
        }
    }

    /** Reads lines until each of {@code last} was among them, and returns all of them. */
    private static List<String> readTo(BufferedReader lines, String... last) throws IOException {
        List<String> read = new ArrayList<>();
        do {
            String line = lines.readLine();
            assertThat(line).as("the line after " + read).isNotNull();
            read.add(line);
        } while (!read.containsAll(List.of(last)));
        return read;
    }

    @Test
    void theWholeStoryFromOffToOff() throws Exception {
        Process lamp = program(ROOT);
        BufferedReader screen = lamp.inputReader(StandardCharsets.UTF_8);
        try (Writer keyboard = lamp.outputWriter(StandardCharsets.UTF_8)) {
            keyboard.write("start\nswitch\n");
            keyboard.flush();
            assertThat(readTo(screen, " new_current_state: on"))
                    .containsExactly(
                            "running: original off, new off",
                            // The lamp comes first: its event is reported after it was processed.
                            "(*) daylight",
                            "----   button_event : switch   -----",
                            "",
                            "Monitor",
                            " inputs switch event.",
                            "Analyze",
                            " original_current_state: off",
                            " new_current_state: off",
                            " mode: Use existing functions",
                            "Plan",
                            "Execute",
                            " MAPE-K loop will send this event : switch",
                            " switch command",
                            " original_current_state: on",
                            " new_current_state: on");
            keyboard.write("switch\nswitch\n");
            keyboard.flush();
            // In either order: the new state's function does not wait for the report of the event.
            readTo(screen, " new_current_state: incandescentOn", "(*) incandescent");
            keyboard.write("switch\n");
            keyboard.flush();
            assertThat(readTo(screen, " new_current_state: off")).containsSubsequence("(*) daylight", "( ) dark");
            keyboard.write("switch\nswitch\n");
            keyboard.flush();
            readTo(screen, " new_current_state: wait");
            assertThat(readTo(screen, " new_current_state: off")).contains(" inputs timeout event.", "( ) dark");
        }

        assertThat(lamp.waitFor(20, TimeUnit.SECONDS)).isTrue();
        assertThat(lamp.exitValue()).isZero();
        assertThat(lamp.errorReader(StandardCharsets.UTF_8).lines()).isEmpty();
    }

    @Test
    void aLampWhoseConverterWasKilledIsStillOnAndGoesOff(@TempDir File folder) throws Exception {
        String kept = new File(folder, "journal").toString();
        Process killed = program(ROOT, "--start", "--journal", kept);
        Writer keyboard = killed.outputWriter(StandardCharsets.UTF_8);
        keyboard.write("switch\n");
        keyboard.flush();
        readTo(killed.inputReader(StandardCharsets.UTF_8), " new_current_state: on");
        killed.destroyForcibly().waitFor();

        Process next = program(ROOT, "--models", "models/light-bulb.xml", "--journal", kept);
        try (Writer again = next.outputWriter(StandardCharsets.UTF_8)) {
            again.write("history\nstart\nswitch\n");
            again.flush();
            assertThat(readTo(next.inputReader(StandardCharsets.UTF_8), " new_current_state: wait"))
                    .anyMatch(line -> line.contains("switch (controller)  (off, off) -> (on, on)  handled"));
        }
        assertThat(next.waitFor(20, TimeUnit.SECONDS)).isTrue();
        assertThat(next.exitValue()).isZero();
        assertRefused(program(ROOT, "--journal"), "error: --journal needs a value: --journal DIR");
        assertRefused(program(ROOT, "--journal", "/dev/null"), "error: the journal /dev/null cannot be written");
    }

    @Test
    void modelsThatAreNotThereAreOneLineOfError(@TempDir File elsewhere) throws Exception {
        assertRefused(program(elsewhere), "error: no file models/light-bulb.xml in ");
        assertRefused(program(elsewhere, "--models", "none.xml"), "error: --models is none.xml, which does not exist");
    }

    @Test
    void modelsOfAnotherDeviceAreRefusedWithAllThatDoesNotFit() throws Exception {
        List<String> errors = refusal(program(ROOT, "--models", "models/cleaning-robot.xml"));

        assertThat(errors.get(0)).startsWith("error: a function is registered for incandescentOn");
        assertThat(errors).anyMatch(line -> line.contains("LampExecute can send switch"));
    }

    @Test
    void optionsThatDoNotExistAreOneLineOfError() throws Exception {
        assertRefused(program(ROOT, "--model"), "error: there is no option --model; did you mean models?");
    }

    @Test
    void anInvalidBrokerIsOneLineOfErrorWithoutItsPassword() throws Exception {
        assertRefused(program(ROOT, "--mqtt", "broker"), "error: --mqtt: the broker's URL broker names no broker");
        assertRefused(
                program(ROOT, "--mqtt", "mqtt://ha:s3cret@b"),
                "error: --mqtt: the broker's URL mqtt://ha:***@b contains");
    }

    @Test
    void aFileOfOptionsIsGoneBy(@TempDir File folder) throws Exception {
        File file = new File(folder, "lamp.yaml");
        Files.writeString(file.toPath(), "models: gone.xml\nstart: yes\nnmae: lamp\n");
        assertThat(refusal(program(ROOT, "--config", file.toString())))
                .containsExactly(
                        "error: the options have 3 mistakes:",
                        "  " + file + ":1: models is " + folder + "/gone.xml, which does not exist; correct the path",
                        "  " + file + ":2: start: 'yes' is neither true nor false; write one of them",
                        "  " + file + ":3: there is no option nmae; did you mean name?");

        Files.writeString(file.toPath(), "page: 99999\nmodels: " + file + "\nswitch-pin: 28\n");
        assertThat(refusal(program(ROOT, "--config", file.toString(), "--print-config")))
                .satisfiesExactly(
                        line -> assertThat(line).isEqualTo("error: the options have 3 mistakes:"),
                        line -> assertThat(line).startsWith("  " + file + ":1: page takes a port"),
                        line -> assertThat(line).startsWith("  " + file + ":2: " + file + ": is a YAML file"),
                        line -> assertThat(line).startsWith("  " + file + ":3: switch-pin takes a GPIO number"));

        Files.writeString(file.toPath(), "program: lightbulb\nmodels: " + ROOT + "/models/light-bulb.xml\n");
        Process lamp = program(folder, "--config", file.toString());
        try (Writer keyboard = lamp.outputWriter(StandardCharsets.UTF_8)) {
            keyboard.write("start\nswitch\nexit\n");
        }
        assertThat(lamp.inputReader(StandardCharsets.UTF_8).lines()).contains(" switch command");
        assertThat(lamp.waitFor()).isZero();
    }

    /** All but what devices and other programs say. */
    @Test
    void printingTheOptionsFindsWhatAStartWouldRefuse(@TempDir File folder) throws Exception {
        File journal = new File(folder, "journal");
        try (Writer keyboard = program(ROOT, "--journal", journal.toString()).outputWriter(StandardCharsets.UTF_8)) {
            keyboard.write("start\nexit\n");
        }
        assertThat(Objects.requireNonNull(program).waitFor()).isZero();
        Process sound = program(ROOT, "--journal", journal.toString(), "--print-config");
        assertThat(sound.errorReader(StandardCharsets.UTF_8).lines()).isEmpty();
        assertThat(sound.waitFor()).isZero();

        Files.move(new File(journal, "0000000001.journal").toPath(), new File(journal, "0000000002.journal").toPath());
        assertSame("--journal", journal.toString());
        assertSame("--journal", folder + "/journal/0000000002.journal");
        assertSame("--name", "n".repeat(120));
        assertSame("--page", "no.such.host.invalid:80");
        assertSame("--page", "0", "--page-token-file", folder.toString());
        File models = new File(folder, "models.xml");
        Files.writeString(
                models.toPath(),
                Files.readString(ROOT.toPath().resolve("models/light-bulb.xml")).replace("\"switch\"", "\"swap\""));
        assertSame("--models", models.toString());
    }

    /** A start and its printed options are refused alike. */
    private void assertSame(String... options) throws Exception {
        List<String> printed = new ArrayList<>(List.of(options));
        printed.add("--print-config");
        assertThat(refusal(program(ROOT, printed.toArray(String[]::new)))).isEqualTo(refusal(program(ROOT, options)));
    }

    @Test
    void aFullDiskIsAnError() throws Exception {
        for (String asked : List.of("--print-config", "--help")) {
            Process lamp = new ProcessBuilder(command(asked))
                    .directory(ROOT)
                    .redirectOutput(new File("/dev/full"))
                    .start();
            program = lamp;
            assertThat(lamp.errorReader(StandardCharsets.UTF_8).lines())
                    .singleElement()
                    .asString()
                    .startsWith("error: standard output: the result could not be written in full");
            assertThat(lamp.waitFor()).isEqualTo(1);
        }
    }

    private static void assertRefused(Process lamp, String error) throws Exception {
        assertThat(refusal(lamp)).singleElement().asString().startsWith(error);
    }

    private static List<String> refusal(Process lamp) throws Exception {
        assertThat(lamp.waitFor(20, TimeUnit.SECONDS)).isTrue();
        assertThat(lamp.exitValue()).isEqualTo(2);
        assertThat(lamp.inputReader(StandardCharsets.UTF_8).lines()).isEmpty();
        return lamp.errorReader(StandardCharsets.UTF_8).lines().toList();
    }
}
