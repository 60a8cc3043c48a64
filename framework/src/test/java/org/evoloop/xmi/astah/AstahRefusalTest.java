package org.evoloop.xmi.astah;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.xmi.astah.AstahDocument.ends;
import static org.evoloop.xmi.astah.AstahDocument.offOn;
import static org.evoloop.xmi.astah.AstahDocument.trigger;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.XmiFile;
import org.evoloop.xmi.XmiMachine;
import org.evoloop.xmi.astah.AstahDocument.Machine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Nothing in a machine is ignored: what cannot be used is refused with kind, name, id, line and mend. */
class AstahRefusalTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "State.entry              | entry action",
                "State.exit               | exit action",
                "State.doActivity         | do action",
                "State.internalTransition | internal transition",
                "State.deferrableEvent    | deferrable event",
                "ModelElement.constraint  | element ModelElement.constraint",
            })
    void shouldRefuseWhatAStateDoes(String role, String words) {
        Machine machine = offOn("m")
                .vertex("<UML:CompositeState xmi.id=\"x\" name=\"Busy\"><UML:" + role
                        + "><UML:Thing xmi.id=\"y\" name=\"beep%28%29\"></UML:Thing></UML:" + role
                        + "></UML:CompositeState>");

        assertOneProblem(
                machine, machine.lineOfLastVertex(), words + " 'beep()' (id 'y') of state 'Busy' is not supported; ");
    }

    @Test
    void shouldRefuseEachInternalTransitionThoughStatesReferToIt() {
        String internal = "<UML:Transition xmi.id=\"%s\" name=\"%s\">" + ends("x", "x") + "</UML:Transition>";
        Machine machine = offOn("m")
                .vertex("<UML:CompositeState xmi.id=\"x\" name=\"Busy\"><UML:StateVertex.outgoing>"
                        + "<UML:Transition xmi.idref=\"p\"/><UML:Transition xmi.idref=\"q\"/></UML:StateVertex.outgoing>"
                        + "<UML:State.internalTransition>\n" + internal.formatted("p", "ping") + "\n"
                        + internal.formatted("q", "pong") + "</UML:State.internalTransition></UML:CompositeState>");

        assertThat(problems(machine))
                .satisfiesExactly(
                        first -> assertThat(first)
                                .startsWith(
                                        "line " + (machine.lineOfLastVertex() + 1) + ": internal transition 'ping'"),
                        second -> assertThat(second)
                                .startsWith(
                                        "line " + (machine.lineOfLastVertex() + 2) + ": internal transition 'pong'"));
    }

    @ParameterizedTest
    @CsvSource({"guard, guard", "effect, effect"})
    void shouldRefuseWhatATransitionCarries(String role, String words) {
        Machine machine = offOn("m")
                .transition("<UML:Transition xmi.id=\"x\" name=\"go+%5Bx%5D\"><UML:Transition." + role
                        + "><UML:Any xmi.id=\"y\" name=\"a+%3E+1\"></UML:Any></UML:Transition." + role + ">"
                        + trigger("e", "go") + ends("on", "off") + "</UML:Transition>");

        assertOneProblem(
                machine,
                machine.lineOfLastTransition(),
                words + " 'a > 1' (id 'y') of transition 'go [x]' is not supported; remove it");
    }

    @ParameterizedTest
    @CsvSource({
        "FinalState, final state",
        "SubmachineState, submachine state",
        "StubState, stub state",
        "SynchState, synch state",
        "ActionState, element ActionState"
    })
    void shouldRefuseOtherVerticesOnceThoughATransitionEntersThem(String element, String words) {
        Machine machine = offOn("m").vertex("<UML:" + element + " xmi.id=\"x\" name=\"End\"></UML:" + element + ">");
        int line = machine.lineOfLastVertex();
        machine.transition("t2", "on", "go", "x");

        assertOneProblem(machine, line, words + " 'End' (id 'x') is not supported; ");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "choice",
                "junction",
                "fork",
                "join",
                "deepHistory",
                "shallowHistory",
                "entryPoint",
                "exitPoint",
                "anything"
            })
    void shouldRefuseOtherPseudostatesOnceThoughTransitionsEndThere(String kind) {
        Machine machine =
                offOn("m").vertex("<UML:Pseudostate xmi.id=\"x\" name=\"P\" kind=\"" + kind + "\"></UML:Pseudostate>");
        int line = machine.lineOfLastVertex();
        machine.transition("t2", "on", "go", "x").transition("t3", "x", "", "on");

        assertOneProblem(machine, line, "pseudostate 'P' (id 'x') of kind '" + kind + "' is not supported; ");
    }

    @Test
    void shouldRefuseACompositeStateButNotMissWhatIsInside() {
        Machine machine = offOn("m")
                .vertex("<UML:CompositeState xmi.id=\"x\" name=\"Outer\"><UML:CompositeState.subvertex>\n"
                        + "<UML:Pseudostate xmi.id=\"i2\" name=\"\" kind=\"initial\"></UML:Pseudostate>\n"
                        + "<UML:Pseudostate xmi.id=\"c\" name=\"C\" kind=\"choice\"></UML:Pseudostate>\n"
                        + "<UML:CompositeState xmi.id=\"y\" name=\"On\"></UML:CompositeState>"
                        + "</UML:CompositeState.subvertex></UML:CompositeState>");
        int line = machine.lineOfLastVertex();
        machine.transition("t2", "i2", "", "y").transition("t3", "off", "go", "x");

        assertThat(problems(machine))
                .satisfiesExactly(
                        first -> assertThat(first)
                                .startsWith("line " + line + ": composite state 'Outer' (id 'x') is not supported; "),
                        second -> assertThat(second).startsWith("line " + (line + 2) + ": pseudostate 'C'"));
    }

    @Test
    void shouldRefuseOrthogonalRegionsAsOneProblem() {
        String region =
                "<UML:CompositeState xmi.id=\"%s\" name=\"\" isOrthogonal=\"false\"><UML:CompositeState.subvertex>"
                        + "<UML:CompositeState xmi.id=\"%s\" name=\"In\"/></UML:CompositeState.subvertex></UML:CompositeState>";
        Machine machine = offOn("m")
                .vertex(
                        "<UML:CompositeState xmi.id=\"x\" name=\"Both\" isOrthogonal=\"true\"><UML:CompositeState.subvertex>"
                                + region.formatted("r1", "s1") + region.formatted("r2", "s2")
                                + "</UML:CompositeState.subvertex></UML:CompositeState>");

        assertOneProblem(
                machine, machine.lineOfLastVertex(), "orthogonal regions in state 'Both' (id 'x') are not supported; ");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<UML:Extra xmi.id=\"x\" name=\"n\"/>                        | element Extra 'n' (id 'x') is not supported",
                "<UML:CompositeState xmi.id=\"x\" name=\"n\" isLeaf=\"true\"/> | unknown attribute isLeaf of state 'n'",
                "<UML:CompositeState xmi.id=\"x\" name=\"n\" xmlns:a=\"http://www.w3.org/2001/XMLSchema-instance\" a:nil=\"true\"/>"
                        + " | unknown attribute {http://www.w3.org/2001/XMLSchema-instance}nil",
                "<UML:CompositeState xmi.id=\"x\" name=\"n\">words</UML:CompositeState> | text between the elements of state 'n'",
                "<UML:CompositeState xmi.id=\"x\" name=\"+\"/>               | state without a name (id 'x'); give it one",
                "<UML:CompositeState xmi.id=\"x\" name=\"Off\"/>             | state 'Off' (id 'x') has the name of the state in line 13",
                "<UML:CompositeState xmi.id=\"off\" name=\"n\"/>             | id 'off' is also the id of an element in line 13",
                "<UML:Pseudostate xmi.id=\"x\" name=\"\" kind=\"initial\"/>  | second initial pseudostate",
            })
    void shouldRefuseAMalformedVertex(String xml, String problem) {
        Machine machine = offOn("m").vertex(xml);

        assertOneProblem(machine, machine.lineOfLastVertex(), problem);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "on | off  | ''    | transition 'go' (id 'x') has no trigger; give it an event",
                "on | gone | go    | reference to the unknown id 'gone' of transition 'go'; ",
                "on | t    | go    | the target of transition 'go' (id 'x') is no state but the element with the id 't'; ",
                "i  | on   | ''    | second transition 'go' (id 'x') from the initial pseudostate",
                "on | i    | go    | transition 'go' (id 'x') ends in the initial pseudostate; end it in a state",
            })
    void shouldRefuseAMalformedTransition(String source, String target, String event, String problem) {
        Machine machine = offOn("m")
                .transition("<UML:Transition xmi.id=\"x\" name=\"go\">" + (event.isEmpty() ? "" : trigger("e", event))
                        + ends(source, target) + "</UML:Transition>");

        assertOneProblem(machine, machine.lineOfLastTransition(), problem);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<UML:Transition.trigger><UML:Event xmi.idref=\"gone\"/></UML:Transition.trigger> | refers to the unknown event id 'gone'",
                "<UML:Transition.trigger><UML:Event xmi.id=\"e\" name=\"\"/></UML:Transition.trigger> | the trigger of transition 'go' (id 'x') has no name",
                "<UML:Transition.trigger><UML:Event xmi.id=\"e\" name=\"a\"/><UML:Event xmi.id=\"f\" name=\"b\"/></UML:Transition.trigger>"
                        + " | transition 'go' (id 'x') has 2 triggers; draw a transition for each",
            })
    void shouldRefuseAMalformedTrigger(String xml, String problem) {
        Machine machine = offOn("m")
                .transition(
                        "<UML:Transition xmi.id=\"x\" name=\"go\">" + xml + ends("on", "off") + "</UML:Transition>");

        assertOneProblem(machine, machine.lineOfLastTransition(), problem);
    }

    @Test
    void shouldRefuseATransitionWithoutOrWithTwoEnds() {
        Machine machine = offOn("m")
                .transition("<UML:Transition xmi.id=\"x\" name=\"go\">" + trigger("e", "go")
                        + "<UML:Transition.source><UML:StateVertex xmi.idref=\"on\"/><UML:StateVertex xmi.idref=\"off\"/>"
                        + "</UML:Transition.source></UML:Transition>");

        assertThat(problems(machine))
                .satisfiesExactlyInAnyOrder(
                        problem -> assertThat(problem).contains("transition 'go' (id 'x') has 2 source states"),
                        problem -> assertThat(problem).contains("transition 'go' (id 'x') has 0 target states"));
    }

    @Test
    void shouldRefuseATriggerOnTheInitialTransition() {
        Machine machine = new Machine("m", "M")
                .vertex("<UML:Pseudostate xmi.id=\"i\" name=\"\" kind=\"initial\"></UML:Pseudostate>")
                .state("on", "On")
                .transition("t", "i", "start", "on");

        assertOneProblem(
                machine,
                machine.lineOfLastTransition(),
                "trigger 'start' (id 't-e') of the transition from the initial pseudostate is not supported; remove it");
    }

    @Test
    void shouldRefuseAMachineWithoutAnInitialState() {
        assertThat(problems(new Machine("m", "M").state("on", "On")))
                .containsExactly("no initial pseudostate; draw one with a transition to the first state");
        assertThat(problems(new Machine("m", "M")
                        .state("on", "On")
                        .vertex("<UML:Pseudostate xmi.id=\"i\" name=\"P\" kind=\"initial\"></UML:Pseudostate>")))
                .containsExactly(
                        "line 13: no transition leaves the initial pseudostate 'P' (id 'i'); draw one to the first state");
    }

    @Test
    void shouldRefuseAnEmptyDiagram() {
        assertThat(problems(new Machine("m", "M")))
                .containsExactly("the diagram is empty; draw an initial pseudostate, states and transitions");
    }

    @Test
    void shouldReportEverythingAtOnceInTheOrderOfTheFile() {
        Machine machine = offOn("m")
                .vertex("<UML:FinalState xmi.id=\"f\" name=\"F\"></UML:FinalState>")
                .transition("t2", "off", "Clean", "off")
                .transition("t3", "on", "tm(2)", "off");

        assertThatThrownBy(() -> read(machine))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith(
                        "F.xml: state machine 'StateMachine0' (id 'm') (line 9) has 3 problems:\n  line 15: ");
        assertThat(problems(machine))
                .satisfiesExactly(
                        first -> assertThat(first).contains("final state 'F'"),
                        second -> assertThat(second)
                                .contains("two transitions leave state Off on event Clean")
                                .contains("line " + (machine.lineOfLastTransition() - 1)),
                        third ->
                                assertThat(third).contains("tm(2)").contains("line " + machine.lineOfLastTransition()));
    }

    @Test
    void shouldNameTheFirstHundredProblemsAndCountTheRest() {
        Machine machine = offOn("m");
        for (int i = 0; i < 250; i++) {
            machine.vertex("<UML:FinalState xmi.id=\"f" + i + "\" name=\"F\"></UML:FinalState>");
        }

        assertThat(problems(machine)).hasSize(101).last().isEqualTo("and 150 more");
    }

    @Test
    void shouldNotBeDisturbedByAnotherMachine() {
        Machine broken =
                new Machine("b", "Broken").vertex("<UML:FinalState xmi.id=\"off\" name=\"F\"></UML:FinalState>");
        List<XmiMachine> machines =
                machines(new AstahDocument().add(broken).add(offOn("m")).text());

        assertThat(machines.get(1).toStateMachine().transitions()).hasSize(1);
        assertThatThrownBy(machines.get(0)::toStateMachine).isInstanceOf(ModelException.class);
    }

    private static void assertOneProblem(Machine machine, int line, String problem) {
        assertThat(problems(machine))
                .singleElement()
                .asString()
                .startsWith("line " + line + ": ")
                .contains(problem);
    }

    /** The lines of the refusal, behind its heading. */
    private static List<String> problems(Machine machine) {
        try {
            read(machine);
            return List.of();
        } catch (ModelException refused) {
            return String.valueOf(refused.getMessage())
                    .lines()
                    .skip(1)
                    .map(String::strip)
                    .toList();
        }
    }

    private static void read(Machine machine) {
        machines(new AstahDocument().add(machine).text()).get(0).toStateMachine();
    }

    private static List<XmiMachine> machines(String document) {
        return XmiFile.read("F.xml", new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)))
                .machines();
    }
}
