package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.util.List;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.astah.AstahDocument;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** In every dialect, a new state can say where the device must be, and what its function may send. */
class DeviceStatesInFilesTest {
    /** @param state the state B, with what is in it */
    private static String uml2(String state, String beside) {
        return """
                <uml:Model xmi:version="20131001" xmlns:xmi="http://www.omg.org/spec/XMI/20131001" xmlns:ev="urn:evoloop"
                  xmlns:uml="http://www.eclipse.org/uml2/5.0.0/UML" xmi:id="model" name="m">
                <packagedElement xmi:type="uml:StateMachine" xmi:id="m" name="M"><region xmi:id="r">
                <subvertex xmi:type="uml:Pseudostate" xmi:id="i"/>
                <subvertex xmi:type="uml:State" xmi:id="a" name="A"/>
                %s
                <transition xmi:id="t0" source="i" target="a"/>
                <transition xmi:id="t1" source="a" target="b"><trigger xmi:id="tr1" name="go"/></transition>
                </region></packagedElement>%s</uml:Model>""".formatted(state, beside);
    }

    private static String invariant(String specification) {
        return uml2(
                "<subvertex xmi:type='uml:State' xmi:id='b' name='B'><stateInvariant xmi:type='uml:Constraint'"
                        + " xmi:id='c'>" + specification + "</stateInvariant></subvertex>",
                "");
    }

    private static String uml1(String state, String beside) {
        return """
                <XMI xmi.version="1.2" xmlns:UML="org.omg.xmi.namespace.UML">
                <XMI.header><XMI.documentation><XMI.exporter>ArgoUML</XMI.exporter></XMI.documentation></XMI.header>
                <XMI.content><UML:Model xmi.id="model" name="m"><UML:Namespace.ownedElement>%s
                <UML:StateMachine xmi.id="m" name="M"><UML:StateMachine.top><UML:CompositeState xmi.id="top" name="top">
                <UML:CompositeState.subvertex><UML:Pseudostate xmi.id="i" kind="initial"/>
                <UML:SimpleState xmi.id="a" name="A"/>%s
                </UML:CompositeState.subvertex></UML:CompositeState></UML:StateMachine.top><UML:StateMachine.transitions>
                <UML:Transition xmi.id="t0" source="i" target="a"/><UML:Transition xmi.id="t1" source="a" target="b">
                <UML:Transition.trigger><UML:Event xmi.id="e" name="go"/></UML:Transition.trigger></UML:Transition>
                </UML:StateMachine.transitions></UML:StateMachine>
                </UML:Namespace.ownedElement></UML:Model></XMI.content></XMI>""".formatted(beside, state);
    }

    /** @param attributes of the state B */
    private static String scxml(String attributes) {
        return """
                <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" xmlns:ev="urn:evoloop" xmlns:my="urn:mine">
                <state id="A"><transition event="go" target="B"/></state>
                <state id="B" %s/>
                </scxml>""".formatted(attributes);
    }

    private static String astah(String name) {
        return new AstahDocument()
                .add(new AstahDocument.Machine("m", "M")
                        .initial("i", "a")
                        .state("a", "A")
                        .state("b", name)
                        .transition("t1", "a", "go", "b"))
                .text();
    }

    static List<Arguments> documents() {
        String keywords = "&lt;&lt;device Stop Up&gt;&gt; «sends speed, stop» B";
        String texts = "device Stop Up, sends speed, stop";
        return List.of(
                Arguments.of("Astah", astah("<<device Stop Up>> «sends speed, stop» B")),
                Arguments.of("UML 1.x", uml1("<UML:SimpleState xmi.id='b' name='" + keywords + "'/>", "")),
                Arguments.of(
                        "UML 1.x, stereotypes",
                        uml1(
                                "<UML:SimpleState xmi.id='b' name='B'><UML:ModelElement.stereotype>"
                                        + "<UML:Stereotype xmi.idref='s1'/><UML:Stereotype href='profile.xmi#s'/>"
                                        + "<UML:Stereotype xmi.idref='s2'/></UML:ModelElement.stereotype></UML:SimpleState>",
                                "<UML:Stereotype xmi.id='s1' name='device Stop Up'/>"
                                        + "<UML:Stereotype xmi.id='s2' name='sends speed, stop'/>")),
                Arguments.of(
                        "UML 2, keywords",
                        uml2("<subvertex xmi:type='uml:State' xmi:id='b' name='" + keywords + "'/>", "")),
                Arguments.of(
                        "UML 2, string",
                        invariant("<specification xmi:type='uml:LiteralString' value='" + texts + "'/>")),
                Arguments.of(
                        "UML 2, expression",
                        invariant("<specification xmi:type='uml:OpaqueExpression' xmi:id='x'><body>" + texts
                                + "</body></specification>")),
                Arguments.of(
                        "UML 2, reference",
                        uml2(
                                "<subvertex xmi:type='uml:State' xmi:id='b' name='B' stateInvariant='c'><ownedRule"
                                        + " xmi:type='uml:Constraint' xmi:id='c' name='" + texts + "'/></subvertex>",
                                "")),
                Arguments.of(
                        "UML 2, both",
                        uml2(
                                "<subvertex xmi:type='uml:State' xmi:id='b' name='«sends speed, stop» B'><stateInvariant"
                                        + " xmi:type='uml:Constraint' xmi:id='c' name='device Stop Up'/></subvertex>",
                                "")),
                Arguments.of("SCXML", scxml("ev:device='Stop Up' ev:sends='speed stop'")),
                Arguments.of(
                        "SCXML, other namespace", scxml("my:device=' Stop Up' my:sends='speed, stop' my:devise='x'")));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("documents")
    void shouldReadDeviceStateAndSends(String dialect, String document) {
        XmiMachine drawn = ChartText.machines(document).get(0);
        StateMachine machine = drawn.toStateMachine();
        State state = new State("B");
        assertThat(machine.states()).containsExactly(new State("A"), state);
        assertThat(machine.deviceState(state)).isEqualTo("Stop Up");
        assertThat(machine.sends(state)).containsExactly(new Event("speed"), new Event("stop"));
        assertThat(machine.deviceState(new State("A"))).isNull();
        assertThat(drawn.notes()).isEmpty();
    }

    static List<Arguments> misspelt() {
        return List.of(
                Arguments.of(astah("«devise X» B"), "unknown keyword 'devise X' (id 'b'); did you mean device?"),
                Arguments.of(
                        uml1("<UML:SimpleState xmi.id='b' name='«devise X» B'/>", ""),
                        "unknown keyword 'devise X' (id 'b'); did you mean device?"),
                Arguments.of(
                        uml1(
                                "<UML:SimpleState xmi.id='b' name='B' stereotype='s'/>",
                                "<UML:Stereotype xmi.id='s' name='devise X'/>"),
                        "'devise X'; did you mean device?"),
                Arguments.of(
                        uml2("<subvertex xmi:type='uml:State' xmi:id='b' name='«snds x» B'/>", ""),
                        "unknown keyword 'snds x' (id 'b'); did you mean sends?"),
                Arguments.of(
                        invariant("<specification xmi:type='uml:LiteralString' value='devise X'/>"),
                        "'devise X'; did you mean device?"),
                Arguments.of(
                        uml2(
                                "<subvertex xmi:type='uml:State' xmi:id='b' name='«device Y» B'><stateInvariant"
                                        + " xmi:type='uml:Constraint' xmi:id='c' name='device X'/></subvertex>",
                                ""),
                        "has two device states, Y and X; keep one"),
                Arguments.of(
                        uml2("<subvertex xmi:type='uml:State' xmi:id='b' name='B' ev:device='X'/>", ""),
                        "attribute evoloop:device of State 'B'"),
                Arguments.of(scxml("ev:devise='X'"), "attribute devise of urn:evoloop at state 'B'"),
                Arguments.of(scxml("ev:devise='X'"), "did you mean device?"),
                Arguments.of(
                        scxml("device='X'"), "not supported; write ev:device, and xmlns:ev=\"urn:evoloop\" in scxml"),
                Arguments.of(scxml("ev:spontaneous='true'"), "is not known there; there is device, name, sends"),
                Arguments.of(scxml("ev:device=' '"), "write a state of the original model"),
                Arguments.of(scxml("").replace("event=", "ev:sponteneous='true' event="), "did you mean spontaneous?"),
                Arguments.of(scxml("").replace("event=", "ev:spontaneous='yes' event="), "write true or false"),
                Arguments.of(scxml("").replace("event=", "ev:urgent='yes' event="), "write true or false"),
                Arguments.of(scxml("").replace("event=", "ev:urgend='true' event="), "urgent"),
                Arguments.of(
                        scxml("").replace("version=", "ev:device='X' version="), "device of urn:evoloop at scxml"));
    }

    @ParameterizedTest
    @MethodSource("misspelt")
    void shouldRefuseWhatIsMisspelt(String document, String message) {
        XmiMachine drawn = ChartText.machines(document).get(0);
        assertThat(catchThrowable(drawn::toStateMachine))
                .hasMessageContaining("has a problem:")
                .hasMessageContaining(message);
    }

    @ParameterizedTest
    @CsvSource({"temperature &lt; 100", "self.idle", "service running", "''"})
    void otherInvariantsStayRemarks(String text) {
        XmiMachine drawn = ChartText.machines(
                        invariant("<specification xmi:type='uml:LiteralString' value='" + text + "'/>"))
                .get(0);
        assertThat(drawn.toStateMachine().deviceState(new State("B"))).isNull();
        assertThat(drawn.notes()).singleElement().asString().contains("is not a guard and is ignored");
    }

    @Test
    void anExistingStateInsideIsItsOwnDeviceState() {
        StateMachine original =
                StateMachine.named("o").initial("A").transition("A", "go", "B").build();
        String composite = """
                <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" xmlns:ev="urn:evoloop">
                <state id="A"><transition event="go" target="N"/></state>
                <state id="Outer" ev:device="B"><state id="B"/><state id="N"/></state>
                </scxml>""";
        ModelPair pair =
                new ModelPair(original, ChartText.machines(composite).get(0).toStateMachine());

        pair.requireValid();
        assertThat(pair.whereDeviceMustBe(new State("N"))).containsExactly(new State("B"));
        assertThat(pair.whereDeviceMustBe(new State("B"))).containsExactly(new State("B"));
        assertThat(new ModelPair(
                                original,
                                ChartText.machines(scxml("ev:device='A'"))
                                        .get(0)
                                        .toStateMachine())
                        .deviceStateProblems())
                .singleElement()
                .asString()
                .contains("the device has state B itself");
    }
}
