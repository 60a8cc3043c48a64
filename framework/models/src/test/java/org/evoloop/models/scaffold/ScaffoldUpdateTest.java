package org.evoloop.models.scaffold;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.evoloop.models.Tool;
import org.evoloop.models.flat.AstahWriter;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Updating a project keeps what its author wrote, and reports what is new. */
class ScaffoldUpdateTest {
    private static final String SOURCES = "src/main/java/com/example/made/";
    private static final String PROPERTY = "Always back: always can Off\n";

    @TempDir
    private Path directory;

    private Path project;

    @BeforeEach
    void aProject() throws IOException {
        project = directory.resolve("project");
        model("original", lamp("original"));
        model("new", lamp("new").transition("On", "dim", "暗い").transition("暗い", "press", "Off"));
        Files.writeString(directory.resolve("new.properties.txt"), PROPERTY);
        assertThat(scaffold().err()).isEmpty();
    }

    private static StateMachineBuilder lamp(String name) {
        return StateMachine.named(name)
                .initial("Off")
                .transition("Off", "press", "On")
                .transition("On", "press", "Off");
    }

    private void model(String name, StateMachineBuilder machine) throws IOException {
        Files.writeString(directory.resolve(name + ".xml"), AstahWriter.write(machine.build()));
    }

    private void aNewState() throws IOException {
        model(
                "new",
                lamp("new")
                        .transition("On", "glow", "赤い")
                        .transition("赤い", "press", "Off")
                        .transition("On", "dim", "暗い")
                        .transition("暗い", "press", "Off"));
    }

    private Tool scaffold(String... options) {
        return scaffoldAs("com.example.made", options);
    }

    private Tool scaffoldAs(String javaPackage, String... options) {
        Stream<String> arguments = Stream.of(
                "scaffold",
                directory.resolve("original.xml").toString(),
                directory.resolve("new.xml").toString(),
                "--package",
                javaPackage,
                "--out",
                project.toString());
        return Tool.run(Stream.concat(arguments, Stream.of(options)).toArray(String[]::new));
    }

    private String update() {
        Tool update = scaffold("--update");
        assertThat(update.err()).isEmpty();
        assertThat(update.status()).isZero();
        return update.out();
    }

    /** A class of the project, in UTF-8 whatever the locale. */
    private String source(String file) throws IOException {
        return Files.readString(project.resolve(SOURCES + file));
    }

    private void write(String path, String text) throws IOException {
        Files.writeString(project.resolve(path), text);
    }

    @Test
    void thePropertiesGoAlongAndStandWhereACheckLooksForThem() throws IOException {
        assertThat(project.resolve("models/new.properties.txt")).hasContent(PROPERTY);

        write("models/new.properties.txt", "Never: never On\n");
        Tool check = Tool.run(
                "check",
                project.resolve("models/original.xml").toString(),
                project.resolve("models/new.xml").toString());
        assertThat(check.out()).contains("property: 'Never'");
    }

    @Test
    void aModelThatHasNotChangedBringsNothing() throws IOException {
        assertThat(update()).isEqualTo("nothing is new\n");

        write(SOURCES + "ExecuteCommand.java", "mine");
        assertThat(update()).isEqualTo("nothing is new\n");
        assertThat(source("ExecuteCommand.java")).isEqualTo("mine");
    }

    @Test
    void unchangedFilesFollowTheModels() throws IOException {
        String before = source("StateFunction.java");
        aNewState();

        assertThat(update().lines())
                .contains(
                        "updated   models/new.xml",
                        "new       " + SOURCES + "StateFunction2.java",
                        "updated   " + SOURCES + "KnowledgeState.java",
                        "updated   src/test/java/com/example/made/TransitionsTest.java")
                .noneMatch(line -> line.startsWith("kept"));
        // A state keeps its class although another state now precedes it and both class names are generated.
        assertThat(source("StateFunction.java")).isEqualTo(before);
        assertThat(source("KnowledgeState.java"))
                .contains("function(\"暗い\", new StateFunction());")
                .contains("function(\"赤い\", new StateFunction2());");
    }

    @Test
    void whatItsAuthorWroteIsKeptAndWhatIsNewIsReported() throws IOException {
        String knowledge = source("KnowledgeState.java") + "// mine\n";
        write(SOURCES + "KnowledgeState.java", knowledge);
        write(SOURCES + "StateFunction.java", "mine");
        Files.delete(project.resolve(SOURCES + "MonitorEvent.java"));
        aNewState();

        assertThat(update())
                .contains("kept      " + SOURCES + "KnowledgeState.java, which you changed; the new lines in it:\n"
                        + "  + function(\"赤い\", new StateFunction2());\n")
                .contains("left out  " + SOURCES + "MonitorEvent.java, which was removed\n")
                .doesNotContain(SOURCES + "StateFunction.java");
        assertThat(source("KnowledgeState.java")).isEqualTo(knowledge);
        assertThat(source("StateFunction.java")).isEqualTo("mine");
        assertThat(update()).isEqualTo("left out  " + SOURCES + "MonitorEvent.java, which was removed\n");
    }

    @Test
    void aClassThatIsNoLongerNeededRemainsAndIsReported() throws IOException {
        write(SOURCES + "StateFunction.java", "mine");
        model("new", lamp("new").event("dim"));

        assertThat(update()).contains("unneeded  " + SOURCES + "StateFunction.java; remove it if ");
        assertThat(source("StateFunction.java")).isEqualTo("mine");
        assertThat(update()).isEqualTo("nothing is new\n");
    }

    @Test
    void modelsThatWereChangedInTheProjectAreNotOverwritten() throws IOException {
        write("models/new.xml", AstahWriter.write(lamp("changed").build()));
        aNewState();
        Tool refused = scaffold("--update");

        assertThat(refused.status()).isEqualTo(2);
        assertThat(refused.err()).startsWith("error: --update: ").contains("new.xml was changed there");

        Tool fromThere = Tool.run(
                "scaffold",
                project.resolve("models/original.xml").toString(),
                project.resolve("models/new.xml").toString(),
                "--package",
                "com.example.made",
                "--out",
                project.toString(),
                "--update");
        assertThat(fromThere.err()).isEmpty();
        assertThat(fromThere.out()).contains("unneeded  " + SOURCES + "StateFunction.java");
    }

    @Test
    void anotherPackageIsRefused() {
        Tool refused = scaffoldAs("other", "--update");

        assertThat(refused.status()).isEqualTo(2);
        assertThat(refused.err()).contains("--package: the project was begun as com.example.made");
    }
}
