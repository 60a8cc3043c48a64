package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.evoloop.statechart.Statechart;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is written in Mermaid and SCXML, and what is refused since they have no words for it. */
class ModelWriterTest {
    private static Statechart plantUml(String lines) {
        String text = "@startuml lamp\n" + lines.replace(" ; ", "\n") + "\n@enduml\n";
        return ModelFile.read("lamp.puml", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)))
                .findOnly()
                .statechart();
    }

    @Test
    void mermaidIsWrittenAsPeopleWriteIt() {
        Statechart chart = plantUml("""
                [*] --> Off : / boot
                Off --> Lit : «spontaneous» power, «urgent» key [x < 1] / say("a, b"), f(1, 2)
                state Lit {
                  [*] --> Low
                  Low --> High : a<U+002C> b
                  Low : tick / count
                  High --> [*]
                }
                Lit : entry / glow
                High --> Off : out {local}
                Lit --> Off
                """);

        assertThat(ModelWriter.MERMAID.write(chart)).isEqualTo("""
                        ---
                        title: lamp
                        ---
                        stateDiagram-v2
                            [*] --> Off : / boot
                            state "Lit<br>entry / glow" as Lit {
                                [*] --> Low
                                state "Low" as Low
                                Low : tick / count
                                Low --> High : a#44; b
                                High --> [*]
                            }
                            Off --> Lit : «spontaneous» power, «urgent» key [x < 1] / say("a, b"), f(1, 2)
                            Lit --> Off
                            High --> Off : out «local»
                        """);
    }

    @Test
    void mermaidTellsEventsThatAreCalledLikeBehaviorsFromThese() {
        String text = "stateDiagram-v2\n[*] --> A\nA : entry / on\nA : #101;ntry / x\nA : #68;o /\nA : exits / y\n"
                + "A : tick / #100;efer\nA : defer / later\nA --> A : later\n";
        String written = ModelWriter.MERMAID.write(
                ModelFile.read("A.mmd", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)))
                        .findOnly()
                        .statechart());

        assertThat(written.lines().map(String::strip))
                .contains(
                        "A : entry / on",
                        "A : defer / later",
                        "A : #101;ntry / x",
                        "A : #68;o /",
                        "A : exits / y",
                        "A : tick / #100;efer");
    }

    @Test
    void scxmlIsWrittenWithForksChoicesAndNames() {
        Statechart chart = plantUml("""
                state "(A, B)" as A
                [*] --> A
                A --> c : go / f
                state c <<choice>>
                c --> P : [x]
                c --> A : [else] / g
                state P {
                  [*] --> Q
                  --
                  [*] --> R
                  R --> S : e
                }
                A --> S : «spontaneous» s
                """);

        assertThat(ModelWriter.SCXML.write(chart)).isEqualTo("""
                        <?xml version="1.0" encoding="UTF-8"?>
                        <scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:ev="urn:evoloop" version="1.0" name="lamp">
                          <initial>
                            <transition target="state.1"/>
                          </initial>
                          <state id="state.1" ev:name="(A, B)">
                            <transition event="go" cond="x" target="P">
                              <script>f</script>
                            </transition>
                            <transition event="s" target="S" ev:spontaneous="true"/>
                            <transition event="go" cond="else" target="state.1">
                              <script>f</script>
                              <script>g</script>
                            </transition>
                          </state>
                          <parallel id="P">
                            <state id="Q"/>
                            <state id="region">
                              <initial>
                                <transition target="R"/>
                              </initial>
                              <state id="R">
                                <transition event="e" target="S"/>
                              </state>
                              <state id="S"/>
                            </state>
                          </parallel>
                        </scxml>
                        """);
    }

    @Test
    void whatAStateHasToDoWithTheDeviceIsWrittenToo() {
        Statechart chart = plantUml("[*] --> A ; state \"«device On» «sends stop» A\" as A ; A --> A : again");

        assertThat(ModelWriter.MERMAID.write(chart)).contains("state \"«device On» «sends stop» A\" as A\n");
        assertThat(ModelWriter.SCXML.write(chart)).contains("<state id=\"A\" ev:device=\"On\" ev:sends=\"stop\">");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "MERMAID | [*] --> A ; state A { ; [*] --> B ; B --> C : e ; } ; A --> A[H] : f | Mermaid has no shallow history",
                "MERMAID | [*] --> A ; state E <<end>> ; state \"the end\" as E ; A --> E : e | Mermaid's [*] has no name",
                "MERMAID | [*] --> A ; -- ; [*] --> B | Mermaid has regions in states only",
                "MERMAID | [*] --> A ; state A { ; [*] --> B ; state x <<exitPoint>> ; B --> x : e ; } ; x --> A | Mermaid has no exit point 'x'",
                "SCXML | [*] --> A ; A : defer / e ; A --> B : f ; B --> A : e | SCXML has no deferred events, and state 'A' defers e",
                "SCXML | [*] --> A ; A : do / hum ; A --> B : f | SCXML has no name for what state 'A' does, 'hum'",
                "SCXML | [*] --> A ; A --> B : two words | SCXML separates events by blanks, and one is called 'two words'",
                "SCXML | [*] --> A ; A --> B : e [x] [y] | has several, [x] [y]",
                "SCXML | [*] --> A ; A --> B : a ; A --> C : a.b | it would mean something else there",
                "SCXML | [*] --> A ; A --> B : e ; A --> C : e | two transitions leave",
            })
    void whatHasNoWordsIsRefusedWithTheReason(ModelWriter writer, String lines, String reason) {
        assertThatThrownBy(() -> writer.write(plantUml(lines)))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith("state machine 'lamp' cannot be written in ")
                .hasMessageContaining(reason);
    }
}
