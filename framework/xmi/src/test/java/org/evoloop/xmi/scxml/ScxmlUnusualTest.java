package org.evoloop.xmi.scxml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.xmi.scxml.ScxmlReadingTest.scxml;

import java.util.List;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;

/** Unusual constructs that can be read; if reading loses something, that is noted. */
class ScxmlUnusualTest {
    private static List<String> notes(String content) {
        return ChartText.machines(scxml(content)).get(0).notes();
    }

    private static StateMachine flat(String content) {
        return ChartText.machines(scxml(content)).get(0).toStateMachine();
    }

    @Test
    void ofTwoTransitionsOnOneEventTheFirstCounts() {
        String content = """
                <state id='a'>
                  <transition event='e' target='b'/><transition event='e' target='a'/>
                  <transition event='f' cond='x' target='a'/><transition event='f' cond='x' target='b'/>
                  <transition event='f e' target='b'/>
                </state><state id='b'/>""";

        assertThat(ChartText.of(scxml(content)))
                .contains("a -> b : e", "a -> a : f [x]", "a -> b : f")
                .doesNotContain("a -> a : e", "a -> b : f [x]");
        assertThat(notes(content))
                .hasSize(2)
                .allMatch(note -> note.contains("is never taken, since earlier ones always take its events"));
        assertThat(flat(content).nextState(new State("a"), new Event("e"))).contains(new State("b"));
    }

    @Test
    void aFinalStateMayDoSomethingOnExit() {
        StateMachine inner = flat("<state id='s'><state id='a'><transition event='e' target='f'/></state>"
                + "<final id='f'><onexit><script>bye</script></onexit></final>"
                + "<transition event='out' target='b'/></state><state id='b'/>");
        assertThat(effects(inner, "a", "e")).isEmpty();
        assertThat(effects(inner, "f", "out")).containsExactly("bye");

        StateMachine outermost = flat("<state id='a'><transition event='e' target='f'/></state>"
                + "<final id='f'><onentry><script>hi</script></onentry><onexit><script>bye</script></onexit></final>");
        assertThat(effects(outermost, "a", "e")).containsExactly("hi", "bye");
    }

    private static List<String> effects(StateMachine machine, String state, String event) {
        return machine.transition(new State(state), new Event(event))
                .orElseThrow()
                .effects();
    }

    @Test
    void whoWaitsForAStateThatIsNotThereIsTold() {
        assertThat(notes("<state id='P'><state id='i'><transition event='e' target='f'/></state><final id='f'/>"
                        + "<transition event='done.state.Q' target='R'/></state><state id='R'/>"))
                .singleElement()
                .asString()
                .contains("waits for 'Q' to be done, but no state has this id");
    }

    @Test
    void whoWaitsForWhatIsNeverDoneIsTold() {
        String content = "<parallel id='p'><state id='a'><final id='f'/></state><state id='b'/>"
                + "<transition event='done.state.p' target='c'/><transition event='done.state.a' target='c'/></parallel>"
                + "<state id='c'><transition event='done.state.c' target='p'/></state>";

        assertThat(notes(content))
                .hasSize(2)
                .anyMatch(note -> note.contains("waits for parallel 'p' to be done, which never happens"))
                .anyMatch(note -> note.contains("waits for state 'c' to be done, which never happens"));
        assertThat(flat(content).initial()).isEqualTo(new State("c"));
        assertThat(flat(content).events()).isEmpty();
    }

    @Test
    void aGuardOfTheInitialTransitionIsNotAsked() {
        String content = "<state id='s'><initial><transition cond='x' target='a'/></initial>"
                + "<state id='a'><transition event='e' target='s'/></state></state>";

        assertThat(ChartText.of(scxml(content))).contains("  #2 -> a : [x]");
        assertThat(flat(content).initial()).isEqualTo(new State("a"));
        assertThat(notes(content)).singleElement().asString().contains("the guard [x]", "is not evaluated");
    }

    @Test
    void aHistoryOfAParallelStateIsOneOfAllItsRegions() {
        String parallel = """
                <parallel id='p'>
                  <history id='h' type='%s'><transition target='a2'><script>first</script></transition></history>
                  <state id='a'><state id='a1'><transition event='x' target='a2'/></state><state id='a2'/></state>
                  <state id='b'><state id='b1'><transition event='x' target='b2'/></state><state id='b2'/></state>
                  <transition event='out' target='o'/>
                </parallel>
                <state id='o'><transition event='back' target='h'/></state>""";

        StateMachine deep =
                flat("<state id='s'><transition event='go' target='p'/></state>".concat(parallel.formatted("deep")));
        assertThat(run(deep, "go", "x", "out", "back")).isEqualTo("(a2, b2)");
        assertThat(run(deep, "go", "out", "back")).isEqualTo("(a1, b1)");

        StateMachine shallow =
                flat("<state id='s'><transition event='go' target='p'/></state>".concat(parallel.formatted("shallow")));
        assertThat(run(shallow, "go", "x", "out", "back")).isEqualTo("(a1, b1)");

        StateMachine never =
                flat("<state id='s'><transition event='go' target='h'/></state>".concat(parallel.formatted("deep")));
        assertThat(run(never, "go")).isEqualTo("(a2, b1)");
        assertThat(never.transition(never.initial(), new Event("go"))
                        .orElseThrow()
                        .effects())
                .containsExactly("first");
    }

    private static String run(StateMachine machine, String... events) {
        State at = machine.initial();
        for (String event : events) {
            at = machine.nextState(at, new Event(event)).orElseThrow();
        }
        return machine.withoutMemory(at).name();
    }

    @Test
    void aStateWithoutIdIsCalledByItsLine() {
        XmiMachine machine = ChartText.machines(scxml("<state/><parallel><state id='b'/></parallel>"))
                .get(0);

        assertThat(ChartText.of(machine.statechart())).contains("state #1 state of line 2");
        assertThat(machine.notes()).hasSize(2);
    }

    @Test
    void whatIsWrittenOverSeveralLinesCanBeRead() {
        StateMachine machine = flat("""
                <state id='a&#x85;b'>
                  <transition event='e' cond='x&#10;and y' target='a&#x85;b'><script>one();
                two();</script></transition>
                </state>""");

        assertThat(machine.initial().name()).isEqualTo("a\u0085b");
        assertThat(machine.guards()).containsExactly("x\nand y");
        assertThat(machine.transitions().get(0).effects()).containsExactly("one();\ntwo();");
    }
}
