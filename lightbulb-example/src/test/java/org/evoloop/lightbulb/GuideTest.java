package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The guides show code that compiles and tests that run. */
class GuideTest {
    private static final Path ROOT = Path.of(System.getProperty("evoloop.root"));
    private static final String IMPORTS = Stream.of(
                    "java.nio.file.Path",
                    "java.time.Duration",
                    "java.util.Map",
                    "java.util.Set",
                    "java.util.regex.Pattern",
                    "org.evoloop.console.*",
                    "org.evoloop.converter.*",
                    "org.evoloop.evolution.*",
                    "org.evoloop.gpio.*",
                    "org.evoloop.http.*",
                    "org.evoloop.line.*",
                    "org.evoloop.loop.LoopConfig",
                    "org.evoloop.time.*",
                    "org.evoloop.xmi.XmiFile")
            .map(name -> "import " + name + ";\n")
            .collect(Collectors.joining());

    private static List<String> javaIn(String page) throws IOException {
        return Pattern.compile("(?s)```java\n(.*?)```")
                .matcher(Files.readString(ROOT.resolve(page)))
                .results()
                .map(block -> block.group(1))
                .toList();
    }

    @Test
    void theFrontPagesConverterHas30LinesAndCompiles(@TempDir Path folder) throws IOException {
        assertThat(javaIn("README.md")).singleElement().satisfies(converter -> {
            assertThat(converter.lines().count()).isLessThanOrEqualTo(30);
            requireCompiles(folder.resolve("LampConverter.java"), converter);
        });
    }

    @Test
    void theReadyMonitorsAndExecutesCompile(@TempDir Path folder) throws IOException {
        StringBuilder type = new StringBuilder("final class Ready {\n");
        List<String> examples = javaIn("docs/ready-made.md");
        for (int index = 0; index < examples.size(); index++) {
            type.append("void example" + index + "(SystemEventConverter converter, Clock clock) throws Exception {\n")
                    .append(examples.get(index))
                    .append("}\n");
        }
        assertThat(examples).hasSizeGreaterThan(2);
        requireCompiles(folder.resolve("Ready.java"), type + "}\n");
    }

    private static void requireCompiles(Path file, String code) throws IOException {
        Files.writeString(file, IMPORTS + code);
        ByteArrayOutputStream messages = new ByteArrayOutputStream();
        int status = ToolProvider.getSystemJavaCompiler()
                .run(
                        null,
                        messages,
                        messages,
                        "-proc:none",
                        "-d",
                        file.getParent().toString(),
                        file.toString());
        assertThat(status).as(messages.toString(StandardCharsets.UTF_8)).isZero();
    }

    @Test
    void theTutorialShowsTheExamplesCode() throws IOException {
        Path sources = Path.of("src/main/java/org/evoloop/lightbulb");
        List<String> shown = javaIn("docs/lightbulb.md");
        assertThat(Files.readString(sources.resolve("LampExecute.java"))).endsWith(shown.get(0));
        assertThat(Files.readString(sources.resolve("LampKnowledge.java"))).endsWith(shown.get(1));
        assertThat(Files.readString(sources.resolve("Main.java")))
                .contains(shown.get(2).indent(8).replaceAll("(?m)^ +$", ""));
    }

    @Test
    void theFirstScenarioIsTheOneThatIsRun() throws IOException {
        String test = Files.readString(Path.of("src/test/java/org/evoloop/lightbulb/FirstScenarioTest.java"));
        String shown = test.substring(test.indexOf("class FirstScenarioTest"));
        assertThat(shown.lines().count()).as("lines of a first test").isLessThanOrEqualTo(20);
        assertThat(ROOT.resolve("docs/testing.md")).content().contains("```java\n" + shown + "```");
    }
}
