package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.Journal;
import org.evoloop.testkit.ConverterHarness;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The guides show code that compiles, and programs and tests that run. */
@Timeout(120)
class GuideTest {
    private static final Path ROOT = Path.of(System.getProperty("evoloop.root"));

    /** Code of the project that this guide makes; docs/commands/test_retrofit.py follows it. */
    private static final String OWN_PROJECT = "docs/retrofit.md";

    @TempDir
    private Path folder;

    @TestFactory
    Stream<DynamicTest> everySnippetCompiles() throws IOException {
        List<Path> pages = new ArrayList<>(List.of(Path.of("README.md"), Path.of("models/README.md")));
        try (Stream<Path> guides = Files.list(ROOT.resolve("docs"))) {
            guides.filter(guide -> guide.toString().endsWith(".md"))
                    .map(ROOT::relativize)
                    .sorted()
                    .forEach(pages::add);
        }
        pages.remove(Path.of(OWN_PROJECT));
        // Its snippets are parts of the example, which another test compares.
        pages.remove(Path.of("docs/lightbulb.md"));
        List<Snippet> snippets = new ArrayList<>();
        for (Path page : pages) {
            snippets.addAll(Snippet.in(ROOT, page.toString()));
        }
        assertThat(snippets).hasSizeGreaterThan(20);
        return snippets.stream()
                .map(snippet -> DynamicTest.dynamicTest(snippet.place(), () -> snippet.compile(folder)));
    }

    private static Snippet snippet(String page, String part) throws IOException {
        return Snippet.in(ROOT, page).stream()
                .filter(snippet -> snippet.code().contains(part))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void theFrontPagesConverterHas30LinesAndRunsAsItIsPrinted() throws Exception {
        String program = snippet("README.md", "class LampConverter").code();
        assertThat(program.substring(program.indexOf("public final class")).lines())
                .hasSizeLessThanOrEqualTo(30);
        Path file = Files.writeString(folder.resolve("LampConverter.java"), program);
        Process running = start(ROOT, file.toString());
        try (Writer commands = running.outputWriter();
                BufferedReader printed = running.inputReader()) {
            commands.write("start\nswitch\nswitch\nswitch\n");
            commands.flush();
            assertThat(printed.lines().takeWhile(line -> !line.equals("warm filter on")))
                    .contains("the lamp gets switch");
            commands.write("exit\n");
            commands.flush();
            assertThat(printed.lines()).contains("warm filter off");
            assertThat(running.waitFor()).isZero();
        } finally {
            running.destroyForcibly();
        }
    }

    @Test
    void theFirstScenarioIsTheOneThatIsRun() throws IOException {
        String test = Files.readString(Path.of("src/test/java/org/evoloop/lightbulb/FirstScenarioTest.java"));
        assertThat(test.substring(test.indexOf("class FirstScenarioTest")).lines())
                .as("lines of a first test")
                .hasSizeLessThanOrEqualTo(20);
        assertThat(ROOT.resolve("docs/testing.md"))
                .content()
                .contains("```java\n" + test.substring(test.indexOf("import ")) + "```");
    }

    /** In a project of its own, with a recording of what the harness has done. */
    @Test
    void yesterdaysEventsAreATest() throws Exception {
        Path models = Files.createDirectories(folder.resolve("models"));
        for (String name : List.of("light-bulb.xml", "light-bulb.properties.txt")) {
            Files.copy(ROOT.resolve("models").resolve(name), models.resolve(name));
        }
        ModelFile machines = ModelFile.read(models.resolve("light-bulb.xml"));
        LightBulb lamp = new LightBulb();
        Path recording =
                Files.createDirectories(folder.resolve("src/test/recordings")).resolve("sunday");
        try (ConverterHarness converter = ConverterHarness.of(
                        lamp.knowledge(new ModelPair(machines.pick("original"), machines.pick("new"))))
                .with(lamp.execute())
                .with(Journal.in(recording))
                .start()) {
            converter.press("switch").press("switch").advance(Duration.ofSeconds(2));
        }
        runTests("docs/testing.md", "theLampStillDecidesAsOnSunday");
    }

    @Test
    void theRoombaAtItsPortCleans() throws Exception {
        runTests("docs/testing.md", "SimulatedRoombaExtension");
    }

    private void runTests(String page, String part) throws Exception {
        String type = snippet(page, part).compile(folder);
        Process running = start(folder, TestRun.class.getName(), type);
        String printed = new String(running.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(printed).contains("1 passed, 0 failed");
    }

    /** Starts a Java program in a directory, with the compiled snippets on its class path. */
    private Process start(Path directory, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                folder + File.pathSeparator + System.getProperty("java.class.path")));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command)
                .directory(directory.toFile())
                .redirectErrorStream(true)
                .start();
    }

    @Test
    void theTutorialShowsTheExamplesCode() throws IOException {
        String code = Files.readString(Path.of("src/main/java/org/evoloop/lightbulb/LightBulb.java"));
        List<Snippet> shown = Snippet.in(ROOT, "docs/lightbulb.md");
        assertThat(shown)
                .hasSize(3)
                .allSatisfy(snippet ->
                        assertThat(code).contains(snippet.code().indent(4).replaceAll("(?m)^ +$", "")));
    }
}
