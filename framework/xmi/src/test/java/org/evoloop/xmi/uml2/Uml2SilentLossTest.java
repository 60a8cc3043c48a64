package org.evoloop.xmi.uml2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.xmi.uml2.Uml2Text.machine;
import static org.evoloop.xmi.uml2.Uml2Text.model;
import static org.evoloop.xmi.uml2.Uml2Text.state;
import static org.evoloop.xmi.uml2.Uml2Text.transition;

import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Kinds of models of which a well-known loader silently loses parts. */
class Uml2SilentLossTest {

    @Test
    void shouldKeepATransitionThatACallTriggers() {
        String document = transition(
                "",
                "<trigger xmi:id='tr' event='e'/>",
                "<packagedElement xmi:type='uml:Class' xmi:id='c'><ownedOperation xmi:id='op' name='clean'",
                " xmi:type='uml:Operation'/></packagedElement>",
                "<packagedElement xmi:type='uml:CallEvent' xmi:id='e' name='CallEvent1' operation='op'/>");

        assertThat(ChartText.of(document)).contains("a -> b : clean");
    }

    @Test
    void shouldKeepATransitionWhoseTriggerHasANameAlone() {
        assertThat(ChartText.of(transition("", "<trigger xmi:id='tr' name='clean'/>")))
                .contains("a -> b : clean");
    }

    @Test
    void shouldKeepBothOfTwoGuardedTransitionsBetweenTheSameStates() {
        String guarded = "<transition xmi:id='%s' source='a' target='b'><trigger xmi:id='t%s' name='e'/>"
                + "<guard xmi:id='g%s'><specification xmi:type='uml:LiteralString' value='%s'/></guard></transition>";
        String document = machine(state("a", "A")
                + state("b", "B")
                + guarded.formatted("1", "1", "1", "x")
                + guarded.formatted("2", "2", "2", "y"));

        assertThat(ChartText.of(document)).containsSubsequence("a -> b : e [x]", "a -> b : e [y]");
    }

    @Test
    void shouldKeepStatesOfOneNameInTwoComposites() {
        String composite = "<subvertex xmi:type='uml:State' xmi:id='%s' name='%s'><region xmi:id='r%s'>"
                + "<subvertex xmi:type='uml:State' xmi:id='in%s' name='Waiting'/></region></subvertex>";
        String document = machine(composite.formatted("a", "A", "a", "a") + composite.formatted("b", "B", "b", "b"));

        assertThat(ChartText.of(document))
                .containsExactly("state a A", "  state ina Waiting", "state b B", "  state inb Waiting");
    }

    @Test
    void shouldKeepTwoStatesOfOneNameInOneRegion() {
        assertThat(ChartText.of(machine(state("1", "Off") + state("2", "Off"))))
                .containsExactly("state 1 Off", "state 2 Off");
    }

    @Test
    void shouldKeepTwoMachinesApart() {
        String one = "<packagedElement xmi:type='uml:StateMachine' xmi:id='%s' name='%s'><region xmi:id='r%s'>%s"
                + "</region></packagedElement>";
        String document = model(
                one.formatted("m1", "Old", "1", state("a", "A")), one.formatted("m2", "New", "2", state("b", "B")));

        assertThat(ChartText.machines(document)).extracting(XmiMachine::name).containsExactly("Old", "New");
        assertThat(ChartText.of(ChartText.machines(document).get(1).statechart()))
                .containsExactly("state b B");
    }

    @Test
    void shouldCallAStateWithoutNameByItsId() {
        XmiMachine machine = ChartText.machines(machine(state("a", ""))).get(0);

        assertThat(ChartText.of(machine.statechart())).containsExactly("state a a");
        assertThat(machine.notes())
                .singleElement()
                .asString()
                .contains("line " + Uml2Text.FIRST_LINE + ": state without a name is called by its id, 'a'");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "<guard xmi:type='uml:Constraint' xmi:id='c'/>",
                "<guard xmi:type='uml:Constraint' xmi:id='c'>"
                        + "<specification xmi:type='uml:OpaqueExpression' xmi:id='e'><body></body></specification></guard>"
            })
    void shouldNoteAGuardWithoutText(String guard) {
        XmiMachine machine = ChartText.machines(transition("", guard)).get(0);

        assertThat(ChartText.of(machine.statechart())).contains("a -> b");
        assertThat(machine.notes()).singleElement().asString().contains("guard '' (id 'c') has no text and is ignored");
    }

    @Test
    void shouldNoteAConstraintThatIsNoGuard() {
        XmiMachine machine = ChartText.machines(
                        transition("", "<ownedRule xmi:type='uml:Constraint' xmi:id='c' name='C'/>"))
                .get(0);

        assertThat(ChartText.of(machine.statechart())).contains("a -> b");
        assertThat(machine.notes())
                .singleElement()
                .asString()
                .contains("constraint 'C' (id 'c') of Transition '' (id 't') is not a guard and is ignored");
    }

    @Test
    void shouldReadAMachineThroughToItsFlatForm() {
        StateMachine machine = ChartText.machines(transition("", "<trigger xmi:id='tr' name='go'/>"))
                .get(0)
                .toStateMachine();

        assertThat(machine.initial().name()).isEqualTo("A");
        assertThat(machine.transitions()).hasSize(1);
    }
}
