package org.evoloop.models.scaffold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.io.Writer;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.evoloop.models.Tool;
import org.evoloop.models.flat.AstahWriter;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.launcher.LauncherDiscoveryRequest;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.junit.platform.launcher.listeners.SummaryGeneratingListener;
import org.junit.platform.launcher.listeners.TestExecutionSummary;

/** A generated project builds and passes its tests unchanged. */
class ScaffoldTest {
    static final String JAVA_PACKAGE = "com.example.made";

    @TempDir
    private Path directory;

    private Path scaffold(String original, String evolved, String... options) {
        Path project = directory.resolve("project");
        List<String> arguments = Stream.concat(
                        Stream.of(
                                "scaffold", original, evolved, "--package", JAVA_PACKAGE, "--out", project.toString()),
                        Stream.of(options))
                .toList();
        Tool run = Tool.run(arguments.toArray(String[]::new));
        assertThat(run.err()).isEmpty();
        assertThat(run.status()).isZero();
        return project;
    }

    private String model(String file, StateMachine machine) throws IOException {
        return Files.writeString(directory.resolve(file), AstahWriter.write(machine))
                .toString();
    }

    /** Compiles the project, and runs its tests. */
    private TestExecutionSummary test(Path project) throws Exception {
        return run(compile(project), "TransitionsTest");
    }

    /** Compiles the project as Maven would. */
    static Path compile(Path project) throws IOException {
        Path classes = Files.createDirectories(project.resolve("target/classes"));
        List<Path> sources;
        try (Stream<Path> files = Files.walk(project.resolve("src"))) {
            sources = files.filter(file -> file.toString().endsWith(".java")).toList();
        }
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter messages = new StringWriter();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            List<String> options = List.of(
                    "--release",
                    "17",
                    "-proc:none",
                    "-d",
                    classes.toString(),
                    "-cp",
                    System.getProperty("java.class.path"));
            boolean compiled = compiler.getTask(
                            messages, files, null, options, null, files.getJavaFileObjectsFromPaths(sources))
                    .call();
            assertThat(compiled).as(messages.toString()).isTrue();
        }
        // The models are beside the classes, as they are beside a program's jar.
        try (Stream<Path> models = Files.list(project.resolve("models"))) {
            Path beside = Files.createDirectories(classes.resolveSibling("models"));
            for (Path model : models.toList()) {
                Files.copy(model, beside.resolve(model.getFileName()));
            }
        }
        return classes;
    }

    static TestExecutionSummary run(Path classes, String test) throws Exception {
        SummaryGeneratingListener listener = new SummaryGeneratingListener();
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {classes.toUri().toURL()})) {
            LauncherDiscoveryRequest request = LauncherDiscoveryRequestBuilder.request()
                    .selectors(selectClass(loader.loadClass(JAVA_PACKAGE + "." + test)))
                    .build();
            LauncherFactory.create().execute(request, listener);
        }
        return listener.getSummary();
    }

    static void assertAllPassed(TestExecutionSummary summary, int tests) {
        assertThat(summary.getFailures())
                .as("failures")
                .extracting(failure -> failure.getTestIdentifier().getDisplayName() + ": " + failure.getException())
                .isEmpty();
        assertThat(summary.getTestsSucceededCount()).isEqualTo(tests);
    }

    @Test
    void theCleaningRobotsProjectPassesATestForEachTransition() throws Exception {
        Path project = scaffold(Tool.ROBOT + "#original", Tool.ROBOT + "#new", "--spontaneous", "endSpot");

        assertAllPassed(test(project), 8);
        assertThat(project.resolve("src/main/java/com/example/made/SpotWaitFunction.java"))
                .content()
                .contains("The state is left by timeout, Clean.", "visit.finish(\"timeout\")");
        assertThat(project.resolve("models/models.xml")).hasSameBinaryContentAs(Path.of(Tool.ROBOT));
        assertThat(project.resolve("mvnw")).isExecutable();
    }

    @Test
    void modelsInMarkdownAreKeptAsTheyAre() throws Exception {
        Path text = Files.writeString(
                directory.resolve("robot.md"),
                "# My robot\n\n"
                        + Tool.run("show", Tool.ROBOT, "--format", "mermaid").out());

        Path project = scaffold(text + "#original", text + "#new", "--spontaneous", "endSpot");

        assertAllPassed(test(project), 8);
        assertThat(project.resolve("models/models.md")).hasSameBinaryContentAs(text);
    }

    /** A gate of which the motor reports the ends; the new model adds a button and a time. */
    @Test
    void theProgramOffersWhatAControllerRaisesAndNothingElse() throws Exception {
        StateMachine gate = gate("original").build();
        StateMachine kept = gate("new")
                .transition("Up", "tm(5min)", "Sinking")
                .transition("Up", "stay", "Held")
                .transition("Held", "giveUp", "Up")
                .build();
        Path classes = compile(scaffold(
                model("original.xml", gate),
                model("new.xml", kept),
                "--spontaneous",
                "atTop",
                "--spontaneous",
                "atBottom"));
        Process program = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        classes + File.pathSeparator + System.getProperty("java.class.path"),
                        JAVA_PACKAGE + ".Main",
                        "--page",
                        "0")
                .start();
        try (BufferedReader errors = program.errorReader();
                Writer commands = program.outputWriter()) {
            Matcher page = Pattern.compile(".* (http://\\S+/)#token=(\\S+) .*")
                    .matcher(errors.lines()
                            .filter(line -> line.startsWith("page: "))
                            .findFirst()
                            .orElseThrow());
            assertThat(page.matches()).isTrue();
            assertThat(offered(page.group(1), page.group(2)))
                    .contains("\"name\":\"press\"")
                    .contains("\"choices\":[\"push\",\"stay\"]")
                    .doesNotContain("\"device\"", "atTop", "tm(5min)", "giveUp");
            commands.write("start\npress atTop\npress tm(5min)\npress giveUp\npress push\nexit\n");
            commands.flush();
            assertThat(errors.lines())
                    .containsExactly(
                            "error: there is no 'atTop' here; there is push, stay",
                            "error: there is no 'tm(5min)' here; there is push, stay",
                            "error: there is no 'giveUp' here; there is push, stay");
            assertThat(program.waitFor()).isZero();
        } finally {
            program.destroyForcibly();
        }
    }

    private static StateMachineBuilder gate(String name) {
        return StateMachine.named(name)
                .initial("Down")
                .transition("Down", "push", "Rising")
                .transition("Rising", "atTop", "Up")
                .transition("Up", "push", "Sinking")
                .transition("Sinking", "atBottom", "Down");
    }

    private static String offered(String address, String token) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(URI.create(address + "session"))
                .header("Origin", address.replaceFirst("/$", ""))
                .POST(HttpRequest.BodyPublishers.ofString(token))
                .build();
        return HttpClient.newHttpClient()
                .send(request, HttpResponse.BodyHandlers.ofString())
                .body();
    }

    /** Names that are not Java identifiers, guards, effects, time triggers, and functions of the device. */
    @Test
    void anythingThatCanBeDrawnCompilesAndPasses() throws Exception {
        StateMachineBuilder device = StateMachine.named("装置")
                .initial("New")
                .transition("New", "a \"quoted\" event", "two words")
                .transition("two words", "終わり", "New")
                .transition("two words", "tm(2s)", "New")
                .transition("New", "class", "two-words")
                .transition("two-words", "class", "New");
        StateMachineBuilder system = StateMachine.named("*/ } new")
                .initial("New")
                .transition("New", "a \"quoted\" event", "two words")
                .transition("two words", "終わり", "New")
                .transition("two words", "tm(2s)", "New")
                .transition("New", "class", "two-words")
                .transition("two-words", "back\\u000a", "New")
                .transition("New", "1st", "新しい")
                .transition("新しい", "tm(1.5s)", "Two Words!")
                .transition("Two Words!", "after 3 s", "new")
                .transition("Two Words!", "tm(1s)", "*/ evil {@code x}");
        guarded(system, "new", "go", "x > 1", "New");
        guarded(system, "new", "go", "\"ready\"", "新しい");
        system.transition("*/ evil {@code x}", "1st", "two words").transition("new", "go", "Two Words!");

        Path project = scaffold(
                model("original.xml", device.build()), model("new.xml", system.build()), "--spontaneous", "終わり");

        assertAllPassed(test(project), system.build().transitions().size());
    }

    private static void guarded(StateMachineBuilder system, String source, String event, String guard, String target) {
        system.transition(
                new Transition(
                        new State(source),
                        new Event(event, List.of(guard)),
                        new State(target),
                        List.of("say(\"" + guard + "\")"),
                        false),
                "");
    }

    @Test
    void namesAreMadeThatDifferInMoreThanCapitals() {
        JavaNames names = new JavaNames().reserve("NewFunction");

        assertThat(names.free(JavaNames.camel("new", "State") + "Function")).isEqualTo("NewFunction2");
        assertThat(names.free(JavaNames.camel("spot wait", "State"))).isEqualTo("SpotWait");
        assertThat(names.free(JavaNames.camel("Spotwait", "State"))).isEqualTo("Spotwait2");
        assertThat(names.free(JavaNames.camel("掃除中", "State"))).isEqualTo("State");
        assertThat(names.free(JavaNames.camel("待機中", "State"))).isEqualTo("State2");
        assertThat(JavaNames.camel("1st", "State")).isEqualTo("State1st");
    }
}
