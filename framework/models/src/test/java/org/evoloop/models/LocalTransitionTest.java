package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A transition that is drawn as local is shown as such, and does not leave its state. */
class LocalTransitionTest {
    @TempDir
    private Path directory;

    private String drawn() throws IOException {
        return Files.writeString(directory.resolve("local.uml"), """
                        <uml:Model xmlns:xmi="http://www.omg.org/spec/XMI/20131001" xmi:id="model"
                            xmlns:uml="http://www.eclipse.org/uml2/5.0.0/UML">
                          <packagedElement xmi:type="uml:StateMachine" xmi:id="m" name="M">
                            <region xmi:id="r">
                              <subvertex xmi:type="uml:Pseudostate" xmi:id="i"/>
                              <subvertex xmi:type="uml:State" xmi:id="a" name="Bound">
                                <entry xmi:type="uml:OpaqueBehavior" xmi:id="e" name="start"/>
                              </subvertex>
                              <transition xmi:id="t0" source="i" target="a"/>
                              <transition xmi:id="t1" source="a" target="a" kind="local">
                                <trigger xmi:id="x" name="ack"/>
                              </transition>
                            </region>
                          </packagedElement>
                        </uml:Model>
                        """).toString();
    }

    @ParameterizedTest
    @CsvSource({"text, ack {local} -> Bound", "svg, ack {local}", "dot, ack {local}", "plantuml, ack {local}"})
    void isShownInEveryFormat(String format, String text) throws IOException {
        assertThat(Tool.run("show", "--format", format, drawn()).out()).contains(text);
    }

    @Test
    void doesNotEnterTheStateAgain() throws IOException {
        assertThat(Tool.run("show", "--format", "json", drawn()).out()).contains("\"local\"");
        assertThat(Tool.run("flatten", drawn()).out())
                .contains("Bound (internal)")
                .doesNotContain("start  ");
    }
}
