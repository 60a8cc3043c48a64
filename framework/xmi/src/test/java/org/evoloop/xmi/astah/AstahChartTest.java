package org.evoloop.xmi.astah;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.xmi.astah.AstahDocument.encode;
import static org.evoloop.xmi.astah.AstahDocument.ends;
import static org.evoloop.xmi.astah.AstahDocument.offOn;
import static org.evoloop.xmi.astah.AstahDocument.trigger;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.astah.AstahDocument.Machine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Each construct of Astah's state machine diagrams as Astah writes it, and the equivalent flat machine. */
class AstahChartTest {

    @Test
    void actionsOfStatesAndTransitions() {
        Machine machine = offOn("m")
                .vertex(state(
                        "busy",
                        "Busy",
                        actions("State.entry", "beep(1)")
                                + actions("State.exit", "hush")
                                + actions("State.doActivity", "hum")))
                .transition(arc("t2", "on", "busy", trigger("e2", "work") + actions("Transition.effect", "x = 1;")))
                .transition("t3", "busy", "stop", "on");

        StateMachine flat = read(machine);

        assertThat(lines(flat))
                .containsExactly(
                        "Off --Clean--> On", "On --work--> Busy / x = 1;, beep(1)", "Busy --stop--> On / hush");
        assertThat(flat.activities(new State("Busy"))).containsExactly("hum");
    }

    @Test
    void internalTransitionsThoughStatesReferToThem() {
        Machine machine = offOn("m")
                .vertex(state(
                        "busy",
                        "Busy",
                        "<UML:StateVertex.outgoing><UML:Transition xmi.idref=\"p\"/></UML:StateVertex.outgoing>"
                                + "<UML:State.internalTransition>"
                                + arc("p", "busy", "busy", trigger("e", "ping") + actions("Transition.effect", "pong"))
                                + "</UML:State.internalTransition>"))
                .transition("t2", "on", "work", "busy");

        assertThat(lines(read(machine))).contains("Busy --ping--> Busy / pong internal");
    }

    @Test
    void guardsAndChoiceAndJunction() {
        for (String kind : List.of("choice", "junction")) {
            Machine machine = offOn("m")
                    .vertex(pseudostate("c", kind))
                    .transition(arc(
                            "t2", "on", "c", trigger("e", "go") + guard("hot > 1") + actions("Transition.effect", "a")))
                    .transition(arc("t3", "c", "off", guard("full") + actions("Transition.effect", "b")))
                    .transition(arc("t4", "c", "on", guard("else")));

            assertThat(lines(read(machine)))
                    .containsExactly(
                            "Off --Clean--> On",
                            "On --go [hot > 1] [full]--> Off / a, b",
                            "On --go [hot > 1]--> On / a");
        }
    }

    @Test
    void compositeStatesWithTransitionsAcrossLevels() {
        Machine machine = offOn("m")
                .vertex(state(
                        "outer",
                        "Outer",
                        actions("State.entry", "in")
                                + actions("State.exit", "out")
                                + substates(
                                        initial("i2"),
                                        state("a", "A", actions("State.entry", "a in")),
                                        state("b", "On", actions("State.exit", "b out")))))
                .transition(arc("t2", "i2", "a", ""))
                .transition("t3", "on", "default", "outer")
                .transition("t4", "on", "inside", "b")
                .transition("t5", "b", "leave", "off")
                .transition("t6", "outer", "inner", "b");

        assertThat(lines(read(machine)))
                .containsExactly(
                        "Off --Clean--> On",
                        "On --default--> A / in, a in",
                        "On --inside--> Outer.On / in",
                        "A --inner--> Outer.On / out, in",
                        "Outer.On --leave--> Off / b out, out",
                        "Outer.On --inner--> Outer.On / b out, out, in");
    }

    @Test
    void orthogonalRegionsForkAndJoin() {
        Machine machine = offOn("m")
                .vertex(orthogonal(
                        "both",
                        "Both",
                        region("r1", initial("i1"), state("a1", "A1", ""), state("a2", "A2", "")),
                        region("r2", initial("i2"), state("b1", "B1", ""), state("b2", "B2", ""))))
                .vertex(pseudostate("f", "fork"))
                .vertex(pseudostate("j", "join"))
                .transition(arc("x1", "i1", "a1", ""))
                .transition(arc("x2", "i2", "b1", ""))
                .transition("t2", "on", "both", "both")
                .transition("t3", "on", "fork", "f")
                .transition(arc("f1", "f", "a2", ""))
                .transition(arc("f2", "f", "b2", ""))
                .transition("t4", "a1", "next", "a2")
                .transition("t5", "b1", "next", "b2")
                .transition(arc("j1", "a2", "j", ""))
                .transition(arc("j2", "b2", "j", ""))
                .transition(arc("j3", "j", "off", actions("Transition.effect", "joined")))
                .transition("t6", "b1", "b", "b1");

        assertThat(lines(read(machine)))
                .containsExactly(
                        "Off --Clean--> On",
                        "On --both--> (A1, B1)",
                        "On --fork--> Off / joined",
                        "(A1, B1) --next--> Off / joined",
                        "(A1, B1) --b--> (A1, B1)");
    }

    @ParameterizedTest
    @CsvSource({"shallowHistory, A1", "deepHistory, A2"})
    void histories(String kind, String back) {
        Machine machine = offOn("m")
                .vertex(state(
                        "outer",
                        "Outer",
                        substates(
                                initial("i2"),
                                pseudostate("h", kind),
                                state(
                                        "a",
                                        "A",
                                        substates(initial("i3"), state("a1", "A1", ""), state("a2", "A2", ""))))))
                .transition(arc("x2", "i2", "a", ""))
                .transition(arc("x3", "i3", "a1", ""))
                .transition("t2", "on", "back", "h")
                .transition("t3", "a1", "next", "a2")
                .transition("t4", "outer", "pause", "on");

        StateMachine flat = read(machine);

        State paused = flat.nextState(after(flat, "Clean", "back", "next"), event("pause"))
                .orElseThrow();
        assertThat(flat.nextState(paused, event("back"))).hasValue(new State(back));
        assertThat(flat.states()).hasSize(kind.startsWith("deep") ? 5 : 4);
    }

    @Test
    void entryPointsExitPointsAndFinalStates() {
        Machine machine = offOn("m")
                .vertex(state(
                        "outer",
                        "Outer",
                        actions("State.entry", "in")
                                + actions("State.exit", "out")
                                + substates(
                                        pseudostate("p", "entryPoint"),
                                        pseudostate("q", "exitPoint"),
                                        state("a", "A", ""),
                                        "<UML:FinalState xmi.id=\"end\" name=\"\"></UML:FinalState>")))
                .transition("t2", "on", "enter", "p")
                .transition(arc("t3", "p", "a", actions("Transition.effect", "to a")))
                .transition(arc("t4", "a", "q", trigger("e4", "escape") + actions("Transition.effect", "escaping")))
                .transition(arc("t5", "q", "off", actions("Transition.effect", "escaped")))
                .transition("t6", "a", "finish", "end")
                .transition(arc("t7", "outer", "on", actions("Transition.effect", "done")));

        assertThat(lines(read(machine)))
                .containsExactly(
                        "Off --Clean--> On",
                        "On --enter--> A / in, to a",
                        "A --escape--> Off / escaping, out, escaped",
                        "A --finish--> On / out, done");
    }

    @Test
    void submachineStatesAndStubStatesTwiceInOneMachine() {
        String sub =
                "<UML:SubmachineState xmi.id=\"%s\" name=\"%s\" isConcurrent=\"true\" isOrthogonal=\"false\" isRegion=\"true\">"
                        + "<UML:CompositeState.subvertex><UML:StubState xmi.id=\"stub-%s\" name=\"Second\" referenceState=\"\"></UML:StubState>"
                        + "</UML:CompositeState.subvertex><UML:SubmachineState.submachine><UML:StateMachine xmi.idref=\"n\"/>"
                        + "</UML:SubmachineState.submachine></UML:SubmachineState>";
        Machine machine = offOn("m")
                .vertex(sub.formatted("x", "X", "x"))
                .vertex(sub.formatted("y", "Y", "y"))
                .transition("t2", "off", "x", "x")
                .transition("t3", "off", "y", "stub-y")
                .transition("t4", "stub-x", "out", "off");
        Machine included = new Machine("n", "N")
                .initial("i", "first")
                .state("first", "First")
                .state("second", "Second")
                .transition("t", "first", "next", "second");

        assertThat(lines(read(machine, included)))
                .containsExactly(
                        "Off --Clean--> On",
                        "Off --x--> X.First",
                        "Off --y--> Y.Second",
                        "X.First --next--> X.Second",
                        "X.Second --out--> Off",
                        "Y.First --next--> Y.Second");
    }

    @Test
    void aTimerOfAnOuterStateKeepsRunningWhileInnerTransitionsAreTaken() {
        Machine machine = offOn("m")
                .vertex(state("outer", "Outer", substates(initial("i2"), state("a", "A", ""), state("b", "B", ""))))
                .transition(arc("x2", "i2", "a", ""))
                .transition("t2", "on", "enter", "outer")
                .transition("t3", "a", "next", "b")
                .transition("t4", "outer", "tm(5s)", "off")
                .transition("t5", "b", "again", "outer");

        StateMachine flat = read(machine);

        assertThat(flat.transition(new State("A"), event("next")).orElseThrow().keeps())
                .containsExactly("tm(5s)");
        assertThat(flat.transition(new State("B"), event("again")).orElseThrow().keeps())
                .isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Run [IsValid(x)] / DoWork(); | ''    | On --Run [IsValid(x)]--> Off / DoWork();",
                "[ready]                     | ''    | On --Run [ready]--> Off",
                "Run [a[1] > 2] / b[3]       | ''    | On --Run [a[1] > 2]--> Off / b[3]",
                "Run                         | ready | On --Run [ready]--> Off",
                "Run [other]                 | ready | On --Run [ready]--> Off",
                "Run[ready]/go               | ready | On --Run [ready]--> Off / go",
                "push %41                    | ''    | On --push %41--> Off",
            })
    void theTextOnATransitionSaysWhatElementsDoNot(String text, String guard, String line) {
        boolean withTrigger = text.startsWith("[");
        Machine machine = offOn("m")
                .transition("<UML:Transition xmi.id=\"x\" name=\"" + encode(text) + "\">"
                        + (withTrigger ? trigger("e", "Run") : "") + (guard.isEmpty() ? "" : guard(guard))
                        + ends("on", "off") + "</UML:Transition>");

        assertThat(lines(read(machine))).contains(line);
    }

    private static String state(String id, String name, String content) {
        return "<UML:CompositeState xmi.id=\"" + id + "\" name=\"" + encode(name)
                + "\" version=\"0\" unSolvedFlag=\"false\" isConcurrent=\"true\" isOrthogonal=\"false\" isRegion=\"true\">"
                + content + "</UML:CompositeState>";
    }

    private static String orthogonal(String id, String name, String... regions) {
        return state(id, name, substates(regions)).replaceFirst("isOrthogonal=\"false\"", "isOrthogonal=\"true\"");
    }

    private static String region(String id, String... vertices) {
        return state(id, "", substates(vertices));
    }

    private static String substates(String... vertices) {
        return "<UML:CompositeState.subvertex>" + String.join("", vertices) + "</UML:CompositeState.subvertex>";
    }

    private static String initial(String id) {
        return pseudostate(id, "initial");
    }

    private static String pseudostate(String id, String kind) {
        return "<UML:Pseudostate xmi.id=\"" + id + "\" name=\"" + kind + "\" kind=\"" + kind + "\"></UML:Pseudostate>";
    }

    private static String actions(String role, String text) {
        return "<UML:" + role + "><UML:Action name=\"" + encode(text)
                + "\" version=\"0\" unSolvedFlag=\"false\" isAsynchronous=\"false\" actionType=\"5\"></UML:Action></UML:"
                + role
                + ">";
    }

    private static String guard(String text) {
        return "<UML:Transition.guard><UML:Guard name=\"" + encode(text)
                + "\" version=\"0\" unSolvedFlag=\"false\"></UML:Guard></UML:Transition.guard>";
    }

    private static String arc(String id, String source, String target, String content) {
        return "<UML:Transition xmi.id=\"" + id + "\" name=\"\" version=\"0\" unSolvedFlag=\"false\">" + content
                + ends(source, target) + "</UML:Transition>";
    }

    private static org.evoloop.statemachine.Event event(String name) {
        return new org.evoloop.statemachine.Event(name);
    }

    private static State after(StateMachine machine, String... events) {
        State state = machine.initial();
        for (String event : events) {
            state = machine.nextState(state, event(event)).orElseThrow();
        }
        return state;
    }

    private static List<String> lines(StateMachine machine) {
        return machine.transitions().stream().map(AstahChartTest::line).toList();
    }

    private static String line(Transition transition) {
        return transition
                + (transition.effects().isEmpty() ? "" : " / " + String.join(", ", transition.effects()))
                + (transition.internal() ? " internal" : "");
    }

    private static StateMachine read(Machine... machines) {
        AstahDocument document = new AstahDocument();
        List.of(machines).forEach(document::add);
        byte[] bytes = document.text().getBytes(StandardCharsets.UTF_8);
        return ModelFile.read("F.xml", new ByteArrayInputStream(bytes))
                .machines()
                .get(0)
                .toStateMachine();
    }
}
