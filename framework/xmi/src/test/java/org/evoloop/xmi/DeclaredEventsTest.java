package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.astah.AstahDocument;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** In every dialect, a model can declare which events the device does by itself. */
class DeclaredEventsTest {
    private static final String UML_2 = """
            <uml:Model xmi:version="20131001" xmlns:xmi="http://www.omg.org/spec/XMI/20131001"
              xmlns:uml="http://www.eclipse.org/uml2/5.0.0/UML" xmi:id="model" name="m">
            <packagedElement xmi:type="uml:StateMachine" xmi:id="m" name="M"><region xmi:id="r">
            <subvertex xmi:type="uml:Pseudostate" xmi:id="i"/>
            <subvertex xmi:type="uml:State" xmi:id="a" name="A"/><subvertex xmi:type="uml:State" xmi:id="b" name="B"/>
            <transition xmi:id="t0" source="i" target="a"/>
            <transition xmi:id="t1" source="a" target="b"><trigger xmi:id="tr1" event="e1"/></transition>
            <transition xmi:id="t2" source="b" target="a"><trigger xmi:id="tr2" event="e2"/></transition>
            </region></packagedElement>
            <packagedElement xmi:type="uml:AnyReceiveEvent" xmi:id="e1" name="«urgent» go"/>
            <packagedElement xmi:type="uml:AnyReceiveEvent" xmi:id="e2" name="«spontaneous»«urgent» done"/>
            </uml:Model>""";

    private static final String UML_1 = """
            <XMI xmi.version="1.2" xmlns:UML="org.omg.xmi.namespace.UML">
            <XMI.header><XMI.documentation><XMI.exporter>ArgoUML</XMI.exporter></XMI.documentation></XMI.header>
            <XMI.content><UML:Model xmi.id="model" name="m"><UML:Namespace.ownedElement>
            <UML:StateMachine xmi.id="m" name="M"><UML:StateMachine.top><UML:CompositeState xmi.id="top" name="top">
            <UML:CompositeState.subvertex><UML:Pseudostate xmi.id="i" kind="initial"/>
            <UML:SimpleState xmi.id="a" name="A"/><UML:SimpleState xmi.id="b" name="B"/>
            </UML:CompositeState.subvertex></UML:CompositeState></UML:StateMachine.top><UML:StateMachine.transitions>
            %s%s%s
            </UML:StateMachine.transitions></UML:StateMachine>
            </UML:Namespace.ownedElement></UML:Model></XMI.content></XMI>""".formatted(
                    arc("i", "a", ""),
                    arc("a", "b", "&lt;&lt;urgent&gt;&gt; go"),
                    arc("b", "a", "&lt;&lt;urgent, spontaneous&gt;&gt; done"));

    private static final String SCXML = """
            <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" xmlns:ev="urn:evoloop">
            <state id="A"><transition event="go" ev:urgent="true" target="B"/></state>
            <state id="B"><transition event="done" ev:spontaneous="true" ev:urgent="true" target="A"/></state>
            </scxml>""";

    private static String arc(String source, String target, String trigger) {
        return "<UML:Transition xmi.id='" + source + target + "'><UML:Transition.source><UML:StateVertex xmi.idref='"
                + source + "'/></UML:Transition.source><UML:Transition.target><UML:StateVertex xmi.idref='" + target
                + "'/></UML:Transition.target>"
                + (trigger.isEmpty()
                        ? ""
                        : "<UML:Transition.trigger><UML:Event xmi.id='e" + source + "' name='" + trigger
                                + "'/></UML:Transition.trigger>")
                + "</UML:Transition>";
    }

    static List<Arguments> documents() {
        String astah = new AstahDocument()
                .add(new AstahDocument.Machine("m", "M")
                        .initial("i", "a")
                        .state("a", "A")
                        .state("b", "B")
                        .transition("t1", "a", "«urgent» go", "b")
                        .transition("t2", "b", "«spontaneous, urgent» done", "a"))
                .text();
        return List.of(
                Arguments.of("Astah", astah),
                Arguments.of("UML 2", UML_2),
                Arguments.of("UML 1.x", UML_1),
                Arguments.of("SCXML", SCXML));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("documents")
    void shouldDeclareTheEventAndKeepItsName(String dialect, String document) {
        StateMachine machine = ChartText.machines(document).get(0).toStateMachine();
        assertThat(machine.spontaneous()).containsExactly(new Event("done"));
        assertThat(machine.urgent()).containsExactlyInAnyOrder(new Event("go"), new Event("done"));
        assertThat(machine.events()).containsExactlyInAnyOrder(new Event("go"), new Event("done"));
    }
}
