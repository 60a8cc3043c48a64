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
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.XmiMachine;
import org.evoloop.xmi.astah.AstahDocument.Machine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Nothing in a machine is ignored: unusable elements are refused with kind, name, id, line and remedy. */
class AstahRefusalTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<UML:Extra xmi.id=\"x\" name=\"n\"/>                        | element Extra 'n' (id 'x') is not supported",
                "<UML:CompositeState xmi.id=\"x\" name=\"n\" isLeaf=\"true\"/> | unknown attribute isLeaf of state 'n'",
                "<UML:CompositeState xmi.id=\"x\" name=\"n\" xmlns:a=\"http://www.w3.org/2001/XMLSchema-instance\" a:nil=\"true\"/>"
                        + " | unknown attribute {http://www.w3.org/2001/XMLSchema-instance}nil",
                "<UML:CompositeState xmi.id=\"x\" name=\"n\">words</UML:CompositeState> | text between the elements of state 'n'",
                "<UML:CompositeState xmi.id=\"x\" name=\"Off\"/>             | state 'Off' has the name of the state in line 13, id off (id 'x'); ",
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
                "on | gone | go    | reference to the unknown id 'gone' of transition 'go'; ",
                "on | t    | go    | the target of transition 'go' (id 'x') is not a state but the element with the id 't'; ",
                "on | i    | go    | (line 20, id x) ends in an initial pseudostate; end it in a state",
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
    void shouldRefuseAnEmptyDiagram() {
        assertThat(problems(new Machine("m", "M")))
                .containsExactly("the diagram is empty; draw an initial pseudostate, states and transitions");
    }

    @ParameterizedTest
    @CsvSource({
        "SynchState, synch state",
        "ActionState, element ActionState",
        "ObjectFlowState, element ObjectFlowState"
    })
    void shouldRefuseOtherVerticesOnceThoughATransitionEntersThem(String element, String words) {
        Machine machine = offOn("m").vertex("<UML:" + element + " xmi.id=\"x\" name=\"End\"></UML:" + element + ">");
        int line = machine.lineOfLastVertex();
        machine.transition("t2", "on", "go", "x");

        assertOneProblem(machine, line, words + " 'End' (id 'x') is not supported; ");
    }

    @Test
    void shouldRefuseAnUnknownKindOfPseudostateOnceThoughTransitionsEndThere() {
        Machine machine =
                offOn("m").vertex("<UML:Pseudostate xmi.id=\"x\" name=\"P\" kind=\"anything\"></UML:Pseudostate>");
        int line = machine.lineOfLastVertex();
        machine.transition("t2", "on", "go", "x");

        assertOneProblem(machine, line, "pseudostate 'P' (id 'x') of kind 'anything' is not known; ");
    }

    @ParameterizedTest
    @CsvSource({"ModelElement.constraint", "ModelElement.stereotype"})
    void shouldRefuseWhatMayMeanAnything(String role) {
        Machine machine = offOn("m")
                .vertex("<UML:CompositeState xmi.id=\"x\" name=\"Busy\"><UML:" + role
                        + "><UML:Thing xmi.id=\"y\" name=\"beep%28%29\"></UML:Thing></UML:" + role
                        + "></UML:CompositeState>");

        assertOneProblem(
                machine,
                machine.lineOfLastVertex(),
                "element " + role + " 'beep()' (id 'y') of state 'Busy' is not supported; remove it");
    }

    @Test
    void shouldRefuseTwoGuardsOnATransition() {
        Machine machine = offOn("m")
                .transition(
                        "<UML:Transition xmi.id=\"x\" name=\"\"><UML:Transition.guard><UML:Guard xmi.id=\"g\" name=\"a\"/>"
                                + "<UML:Guard xmi.id=\"h\" name=\"b\"/></UML:Transition.guard>" + trigger("e", "go")
                                + ends("on", "off") + "</UML:Transition>");

        assertOneProblem(
                machine, machine.lineOfLastTransition(), "second guard 'b' (id 'h') of transition '' (id 'x'); ");
    }

    @Test
    void shouldRefuseAnInternalTransitionThatLeadsElsewhere() {
        Machine machine = offOn("m")
                .vertex("<UML:CompositeState xmi.id=\"x\" name=\"Busy\"><UML:State.internalTransition>"
                        + "<UML:Transition xmi.id=\"p\" name=\"ping\">" + trigger("e", "ping") + ends("x", "on")
                        + "</UML:Transition></UML:State.internalTransition></UML:CompositeState>");

        assertOneProblem(
                machine,
                machine.lineOfLastVertex(),
                "internal transition 'ping' (id 'p') of state 'Busy' (id 'x') leads from or to another state; ");
    }

    @Test
    void shouldRefuseAStateBetweenRegionsAndBehaviorOfARegion() {
        String region =
                "<UML:CompositeState xmi.id=\"r\" name=\"\"><UML:State.entry><UML:Action xmi.id=\"a\" name=\"beep\"/>"
                        + "</UML:State.entry></UML:CompositeState>";
        Machine machine = offOn("m")
                .vertex(
                        "<UML:CompositeState xmi.id=\"x\" name=\"Both\" isOrthogonal=\"true\"><UML:CompositeState.subvertex>\n"
                                + region + "\n<UML:FinalState xmi.id=\"f\" name=\"F\"/>"
                                + "</UML:CompositeState.subvertex></UML:CompositeState>");
        int line = machine.lineOfLastVertex();

        assertThat(problems(machine))
                .containsExactly(
                        "line " + (line + 1) + ": behavior 'beep' (id 'a') of a region; draw it at a state",
                        "line " + (line + 2) + ": final state 'F' (id 'f') stands between the regions of state 'Both'"
                                + " (id 'x'); draw it inside one of them");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''                            | is linked to no state machine; link it to one of this file",
                "<UML:StateMachine xmi.idref=\"gone\"/> | is linked to the unknown state machine 'gone'; ",
                "<UML:StateMachine xmi.idref=\"m\"/> | includes state machine 'StateMachine0' (id 'm'), which includes it; ",
            })
    void shouldRefuseASubmachineStateWithoutASubmachineOnceThoughItContainsAStub(String reference, String problem) {
        Machine machine = offOn("m")
                .vertex("<UML:SubmachineState xmi.id=\"x\" name=\"Sub\"><UML:CompositeState.subvertex>"
                        + "<UML:StubState xmi.id=\"stub\" name=\"In\" referenceState=\"\"/></UML:CompositeState.subvertex>"
                        + "<UML:SubmachineState.submachine>" + reference
                        + "</UML:SubmachineState.submachine></UML:SubmachineState>");
        int line = machine.lineOfLastVertex();
        machine.transition("t2", "on", "go", "stub");

        assertOneProblem(machine, line, "submachine state 'Sub' (id 'x') " + problem);
    }

    @Test
    void shouldRefuseAStubThatRefersToNothing() {
        Machine machine = offOn("m")
                .vertex("<UML:SubmachineState xmi.id=\"x\" name=\"Sub\"><UML:CompositeState.subvertex>"
                        + "<UML:StubState xmi.id=\"stub\" name=\"In\"/></UML:CompositeState.subvertex>"
                        + "<UML:SubmachineState.submachine><UML:StateMachine xmi.idref=\"n\"/>"
                        + "</UML:SubmachineState.submachine></UML:SubmachineState>");
        int line = machine.lineOfLastVertex();
        machine.transition("t2", "on", "go", "stub");

        assertThat(problems(new AstahDocument()
                        .add(machine)
                        .add(new Machine("n", "N").initial("j", "s").state("s", "S"))))
                .singleElement()
                .asString()
                .startsWith("line " + line
                        + ": stub state 'In' (id 'stub') of submachine state 'Sub' (id 'x') stands for no state");
    }

    @Test
    void shouldRefuseSubmachinesThatMultiplyBeyondMeasure() {
        AstahDocument document = new AstahDocument();
        for (int level = 0; level < 40; level++) {
            Machine machine = new Machine("m" + level, "M" + level).initial("i", "a");
            for (String id : List.of("a", "b")) {
                machine.vertex("<UML:SubmachineState xmi.id=\"" + id + "\" name=\"" + id
                        + "\"><UML:SubmachineState.submachine><UML:StateMachine xmi.idref=\"m" + (level + 1)
                        + "\"/></UML:SubmachineState.submachine></UML:SubmachineState>");
            }
            document.add(machine);
        }
        document.add(new Machine("m40", "M40").initial("i", "s").state("s", "S"));

        assertThat(problems(document))
                .containsExactly("with its submachines the machine has more than 500000 states and transitions;"
                        + " include fewer of them");
    }

    @Test
    void shouldRefuseAnEntryPointOfTheMachineItself() {
        Machine machine =
                offOn("m").vertex("<UML:Pseudostate xmi.id=\"x\" name=\"P\" kind=\"entryPoint\"></UML:Pseudostate>");

        assertOneProblem(
                machine,
                machine.lineOfLastVertex(),
                "pseudostate 'P' (id 'x') is an entry or exit point of the machine itself; ");
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
                "on 'start' (line 17, id t) has a trigger but does not leave a state; ");
    }

    @Test
    void shouldRefuseAMachineWithoutAnInitialState() {
        assertThat(problems(new Machine("m", "M").state("on", "On")))
                .singleElement()
                .asString()
                .contains(
                        "no initial pseudostate in the machine (id 'top-m'); draw one with a transition to the first state");
        assertThat(problems(new Machine("m", "M")
                        .state("on", "On")
                        .vertex("<UML:Pseudostate xmi.id=\"i\" name=\"P\" kind=\"initial\"></UML:Pseudostate>")))
                .containsExactly(
                        "line 13: no transition leaves the initial pseudostate 'P' (id 'i'); draw one to a state");
    }

    @Test
    void shouldReportEverythingAtOnceInTheOrderOfTheFile() {
        Machine machine = offOn("m")
                .vertex("<UML:SynchState xmi.id=\"f\" name=\"F\"></UML:SynchState>")
                .transition("<UML:Transition xmi.id=\"x\" name=\"\">" + ends("on", "gone") + "</UML:Transition>");

        assertThatThrownBy(() -> read(new AstahDocument().add(machine)))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith(
                        "F.xml: state machine 'StateMachine0' (id 'm') (line 9) has 2 problems:\n  line 15: ");
        assertThat(problems(machine))
                .satisfiesExactly(
                        first -> assertThat(first).contains("synch state 'F'"),
                        second -> assertThat(second).contains("unknown id 'gone'"));
    }

    @Test
    void shouldReportEverythingThatHasNoMeaningAtOnceInTheOrderOfTheFile() {
        Machine machine = offOn("m").transition("t2", "off", "Clean", "off").transition("t3", "on", "tm(2)", "off");
        int line = machine.lineOfLastTransition();

        assertThat(problems(machine))
                .satisfiesExactly(
                        first -> assertThat(first)
                                .contains("two transitions leave state 'Off' on event Clean")
                                .contains("id t)")
                                .contains("(line " + (line - 1) + ", id t2)"),
                        second -> assertThat(second).startsWith("line " + line).contains("tm(2)"));
    }

    @Test
    void shouldNameTheFirstHundredProblemsAndCountTheRest() {
        Machine machine = offOn("m");
        for (int i = 0; i < 250; i++) {
            machine.vertex("<UML:SynchState xmi.id=\"f" + i + "\" name=\"F\"></UML:SynchState>");
        }

        assertThat(problems(machine)).hasSize(101).last().isEqualTo("and 150 more");
    }

    @Test
    void shouldNotBeDisturbedByAnotherMachine() {
        Machine broken =
                new Machine("b", "Broken").vertex("<UML:SynchState xmi.id=\"off\" name=\"F\"></UML:SynchState>");
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

    /** The problems of the refusal: the lines after its heading, or the only one behind it. */
    private static List<String> problems(Machine machine) {
        return problems(new AstahDocument().add(machine));
    }

    private static List<String> problems(AstahDocument document) {
        try {
            read(document);
            return List.of();
        } catch (ModelException refused) {
            String problems = String.valueOf(refused.getMessage()).replaceFirst(".* has (a|[0-9]+) problems?:", "");
            return problems.strip().lines().map(String::strip).toList();
        }
    }

    private static void read(AstahDocument document) {
        machines(document.text()).get(0).toStateMachine();
    }

    private static List<XmiMachine> machines(String document) {
        return ModelFile.read("F.xml", new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)))
                .machines();
    }
}
