package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A new model that only adds a history: states that differ only in what is remembered are states of the device. */
class AddedHistoryTest {
    @TempDir
    private Path directory;

    private String original = "";
    private String evolved = "";

    @BeforeEach
    void drawBoth() throws IOException {
        original = draw("original", "lit", "");
        evolved = draw("new", "memory", "<history id='memory'><transition target='On'/></history>");
    }

    private String draw(String name, String target, String history) throws IOException {
        return Files.writeString(directory.resolve(name + ".scxml"), """
                        <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" initial="lit" name="%s">
                          <state id="lit" initial="On">%s
                            <state id="On"><transition event="p" target="Dim"/></state>
                            <state id="Dim"><transition event="p" target="On"/></state>
                            <transition event="z" target="Dark"/>
                          </state>
                          <state id="Dark"><transition event="h" target="%s"/></state>
                        </scxml>
                        """.formatted(name, history, target))
                .toString();
    }

    @Test
    void nothingIsWrongAndNothingIsNew() {
        assertThat(Tool.run("check", original, evolved).out()).isEqualTo("nothing found\n");
        assertThat(Tool.run("diff", original, evolved).out())
                .contains(
                        "states\n  kept      On, Dim, Dark [history On], Dark [history Dim]\n  added     -\n  removed   -\n")
                .contains("rerouted  Dark [history Dim] --h--> Dim  (before: Dark --h--> On)");
        assertThat(Tool.run("plan", original, evolved).out())
                .contains("(Dark, Dark [history Dim])  Dark [history Dim] --h--> Dim:  path h, p")
                .doesNotContain("new function", "IMPOSSIBLE");
    }

    @Test
    void optionsAndPropertiesNameTheStatesAsDrawn() throws IOException {
        Path properties = Files.writeString(
                directory.resolve("properties.txt"), "Dark is dark: always Dark implies device Dark\n");

        Tool check = Tool.run("check", "--properties", properties.toString(), original, evolved);

        assertThat(check.out()).isEqualTo("nothing found\n");
        assertThat(check.err()).isEmpty();
        assertThat(Tool.run("plan", "--do-not-pass", "Dark", evolved, evolved).status())
                .isZero();
    }

    @Test
    void whatAFlatDrawingCannotSayIsNoted() {
        assertThat(Tool.run("flatten", "--format", "XMI", evolved).err())
                .contains("note: Dark [history Dim] is the state Dark with something remembered");
    }
}
