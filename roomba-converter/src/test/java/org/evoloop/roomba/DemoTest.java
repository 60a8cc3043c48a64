package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The demo from end to end: processes, serial port, threads and time are real. */
@EnabledOnOs(OS.LINUX)
@Timeout(600)
class DemoTest {
    private static final String TWO_PROCESSES = "--two-processes";
    private static final String DOUBT = " WARN  the state of the device is in doubt: ";
    private static final int ATTEMPTS = 5;

    @TempDir
    Path folder;

    /** Without trailing spaces or consecutive empty lines. */
    private static List<String> tidy(String text) {
        List<String> lines = new ArrayList<>();
        for (String line : text.split("\n")) {
            String stripped = line.stripTrailing();
            boolean again = stripped.isEmpty()
                    && (lines.isEmpty() || lines.get(lines.size() - 1).isEmpty());
            if (!again) {
                lines.add(stripped);
            }
        }
        return lines;
    }

    private static List<String> expected(String scenario) throws IOException {
        try (InputStream resource =
                Objects.requireNonNull(DemoTest.class.getResourceAsStream(scenario + ".txt"), scenario)) {
            return tidy(new String(resource.readAllBytes(), StandardCharsets.UTF_8));
        }
    }

    /**
     * The errors without two warnings that a computer too busy for the demo's speed may cause: the simulator falls
     * behind, and late reports of the device leave the recorded state in doubt for a moment.
     */
    private static List<String> said(Program.Result result) {
        return result.err()
                .lines()
                .filter(line -> !line.contains(" WARN  the simulator fell "))
                .filter(line -> !line.contains(DOUBT))
                .toList();
    }

    /** Plays these scenarios until a run leaves no doubt, which its transcript would show; each run must end well. */
    private Program.Result play(List<String> scenarios, String... options) throws Exception {
        List<String> endings = scenarios.stream()
                .map(scenario -> "evoloop: " + scenario + " ended where it should, by the simulated robot's true state")
                .toList();
        List<String> arguments = new ArrayList<>(List.of("demo"));
        arguments.addAll(List.of(options));
        Program.Result result;
        int attempts = 0;
        do {
            result = Program.run(folder, arguments.toArray(String[]::new));
            assertThat(said(result)).as("%s", result).isEqualTo(endings);
            assertThat(result.status()).isZero();
            attempts++;
        } while (result.err().contains(DOUBT) && attempts < ATTEMPTS);
        return result;
    }

    @Test
    @Tag("slow")
    void remoteStartIsThePapersFirstListingInTwoProcessesToo() throws Exception {
        Program.Result result = play(List.of("remote-start"), "--scenario", "remote-start", TWO_PROCESSES);
        assertThat(tidy(result.out())).isEqualTo(expected("remote-start"));
    }

    @Test
    void spotFromCleanIsThePapersSecondListingInTwoProcessesToo() throws Exception {
        Program.Result result = play(List.of("spot-from-clean"), "--scenario", "spot-from-clean", TWO_PROCESSES);
        assertThat(fromThirdEvent(tidy(result.out()))).isEqualTo(expected("spot-from-clean"));
    }

    private static List<String> fromThirdEvent(List<String> lines) {
        return lines.subList(indexOfThirdEvent(lines), lines.size());
    }

    /** The part of the output of all scenarios that belongs to one of them. */
    private static List<String> played(String scenario, String out) {
        String header = "=== scenario: " + scenario + "\n";
        assertThat(out).contains(header);
        String rest = out.substring(out.indexOf(header) + header.length());
        int next = rest.indexOf("\n===");
        return tidy((next < 0 ? rest : rest.substring(0, next)).stripTrailing());
    }

    private static int indexOfThirdEvent(List<String> lines) {
        int events = 0;
        for (int line = 0; line < lines.size(); line++) {
            if (lines.get(line).startsWith("----   button_event") && ++events == 3) {
                return line;
            }
        }
        throw new AssertionError("fewer than three events in " + lines);
    }

    @Test
    void withoutAChoiceAllFiveArePlayedUnderTheirHeadersAndTwoOfThemAreThePapersListings() throws Exception {
        List<String> all = List.of("remote-start", "spot-from-clean", "own-button", "timeout", "evolve");
        Program.Result result = play(all, "--speed=5");
        assertThat(result.out().lines().filter(line -> line.startsWith("===")))
                .containsExactlyElementsOf(all.stream()
                        .map(scenario -> "=== scenario: " + scenario)
                        .toList());
        assertThat(result.out().lines().filter(line -> line.contains("internal_event : timeout")))
                .hasSize(1);
        assertThat(result.out().lines().filter(line -> line.startsWith("***  The converter")))
                .extracting(String::strip)
                .containsExactly(
                        "***  The converter has evolved to twice.  ***",
                        "***  The converter rolls back, as its owner asked for.  ***",
                        "***  The converter has evolved to new.  ***");
        assertThat(played("remote-start", result.out())).isEqualTo(expected("remote-start"));
        assertThat(fromThirdEvent(played("spot-from-clean", result.out()))).isEqualTo(expected("spot-from-clean"));
    }
}
