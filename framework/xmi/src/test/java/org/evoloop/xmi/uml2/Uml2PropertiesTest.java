package org.evoloop.xmi.uml2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.xmi.uml2.Uml2Text.machine;
import static org.evoloop.xmi.uml2.Uml2Text.model;
import static org.evoloop.xmi.uml2.Uml2Text.state;
import static org.evoloop.xmi.uml2.Uml2Text.transition;

import java.util.List;
import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** XMI writes a property as an attribute or as an element; both mean the same. */
class Uml2PropertiesTest {

    @Test
    void aKindMayBeAnElement() {
        assertThat(ChartText.of(machine("""
                        <subvertex xmi:type='uml:Pseudostate' xmi:id='h'><kind>shallowHistory</kind></subvertex>
                        <subvertex xmi:type='uml:Pseudostate' xmi:id='x'><kind>terminate</kind></subvertex>
                        <subvertex xmi:type='uml:State' xmi:id='s'><name>S</name>
                          <region xmi:id='in'>
                            <subvertex xmi:type='uml:Pseudostate' xmi:id='p'><kind>exitPoint</kind><name>out</name></subvertex>
                          </region>
                        </subvertex>
                        <transition xmi:id='t'><kind>internal</kind><source>s</source><target>s</target>
                          <trigger xmi:id='tr'><name>tick</name></trigger></transition>""")))
                .containsExactly(
                        "SHALLOW_HISTORY h",
                        "TERMINATE x",
                        "state s S",
                        "  EXIT_POINT p out",
                        "  s -> s : tick INTERNAL");
    }

    @Test
    void aKindThatIsUnknownIsNotTakenForTheUsualOne() {
        assertThat(ChartText.refusal(
                        machine("<subvertex xmi:type='uml:Pseudostate' xmi:id='a'><kind>odd</kind></subvertex>")))
                .contains("pseudostate '' (id 'a') is of the unknown kind 'odd'");
    }

    @Test
    void theNamesOfWhatIsReferredToMayBeElements() {
        String document = transition(
                "",
                """
                <trigger xmi:id='tr'><event>e</event></trigger>
                <guard xmi:id='g'><specification xmi:type='uml:LiteralString' xmi:id='v'><value>warm</value></specification></guard>
                <effect xmi:type='uml:Activity' xmi:id='f'><name>beep</name></effect>""",
                "<packagedElement xmi:type='uml:Signal' xmi:id='sig'><name>Go</name></packagedElement>",
                "<packagedElement xmi:type='uml:SignalEvent' xmi:id='e'><name>E1</name><signal>sig</signal></packagedElement>");

        assertThat(ChartText.of(document)).contains("a -> b : Go [warm] / beep");
    }

    @Test
    void aTimeMayBeRelativeByAnElement() {
        String document = transition(
                "",
                "<trigger xmi:id='tr' event='e'/>",
                "<packagedElement xmi:type='uml:TimeEvent' xmi:id='e'><isRelative>true</isRelative><when xmi:id='w'>"
                        + "<expr xmi:type='uml:LiteralString' xmi:id='x'><value>2 s</value></expr></when></packagedElement>");

        assertThat(ChartText.of(document)).contains("a -> b : after 2 s");
    }

    @Test
    void aPackageWithLooseStatesMayBeNamedByAnElement() {
        assertThat(ChartText.machines(model(
                                "<packagedElement xmi:type='uml:Package' xmi:id='p'><name>new</name>",
                                state("a", "A").replace("subvertex", "ownedMember"),
                                "</packagedElement>"))
                        .get(0)
                        .machineName())
                .isEqualTo("new");
    }

    @Test
    void anInvariantOfAStateIsNoted() {
        for (String invariant : List.of(
                "stateInvariant='c'><ownedRule xmi:type='uml:Constraint' xmi:id='c' name='dark'/>",
                "><stateInvariant xmi:type='uml:Constraint' xmi:id='c' name='dark'/>")) {
            XmiMachine machine = ChartText.machines(machine(
                            "<subvertex xmi:type='uml:State' xmi:id='a' name='A' " + invariant + "</subvertex>"))
                    .get(0);

            assertThat(ChartText.of(machine.statechart())).containsExactly("state a A");
            assertThat(machine.notes())
                    .singleElement()
                    .asString()
                    .contains("constraint 'dark' (id 'c') of State 'A' (id 'a') is not a guard and is ignored");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"true", "[ TRUE ]"})
    void aGuardThatAlwaysHoldsIsNone(String guard) {
        assertThat(ChartText.of(transition(
                        "",
                        "<trigger xmi:id='tr' name='go'/><guard xmi:id='g'><specification xmi:type='uml:LiteralString'"
                                + " xmi:id='v' value='" + guard + "'/></guard>")))
                .contains("a -> b : go");
    }

    @Test
    void aNameThatAToolWritesByItselfSaysNothing() {
        assertThat(ChartText.of(transition("name='Transition12'", ""))).contains("a -> b");
    }
}
