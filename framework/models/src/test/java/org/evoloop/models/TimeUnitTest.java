package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Time triggers with a number but no unit. */
class TimeUnitTest {
    @TempDir
    private Path directory;

    private String model = "";

    @BeforeEach
    void draw() throws IOException {
        model = Files.writeString(directory.resolve("lamp.scxml"), """
                        <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" name="lamp">
                          <state id="On"><transition event="after 2" target="Off"/></state>
                          <state id="Off"><transition event="press" target="On"/></state>
                        </scxml>
                        """).toString();
    }

    @ParameterizedTest
    @ValueSource(strings = {"flatten", "check", "diff", "plan"})
    void areRefusedWithTheOptionAsRemedy(String command) {
        String[] arguments =
                command.equals("flatten") ? new String[] {command, model} : new String[] {command, model, model};

        Tool run = Tool.run(arguments);

        assertThat(run.status()).isEqualTo(2);
        assertThat(run.out()).isEmpty();
        assertThat(run.err())
                .contains("lamp.scxml", "line 2", "'after 2' has no unit", "--time-unit ms or --time-unit s");
    }

    @Test
    void areOfTheUnitThatIsGiven() {
        assertThat(Tool.run("flatten", "--time-unit", "ms", model).out()).contains("after 2 ms");
        assertThat(Tool.run("plan", "--time-unit", "s", model, model).out()).contains("after 2 s");
        assertThat(Tool.run("check", "--time-unit", "s", model, model).err()).isEmpty();
        assertThat(Tool.run("diff", "--time-unit", "s", model, model).out()).contains("On --after 2 s--> Off");
    }

    @Test
    void anotherUnitIsRefused() {
        Tool run = Tool.run("flatten", "--time-unit", "fortnights", model);

        assertThat(run.status()).isEqualTo(2);
        assertThat(run.err()).contains("'fortnights' is not a unit of time triggers; give ms or s");
    }

    @Test
    void aScaffoldedProjectKnowsTheUnit() throws IOException {
        Path project = directory.resolve("project");
        Tool run = Tool.run(
                "scaffold", "--time-unit", "s", model, model, "--package", "lamp", "--out", project.toString());

        assertThat(run.status()).as(run.err()).isZero();
        assertThat(Files.readString(project.resolve("src/main/java/lamp/Models.java")))
                .contains("Optional.of(ChronoUnit.SECONDS)");
    }
}
