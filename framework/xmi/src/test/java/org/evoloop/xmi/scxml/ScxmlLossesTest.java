package org.evoloop.xmi.scxml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.xmi.scxml.ScxmlReadingTest.scxml;

import java.util.List;
import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Texts, values and conditions that are easily lost. */
class ScxmlLossesTest {
    private static List<String> notes(String content) {
        return ChartText.machines(scxml(content)).get(0).notes();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<state id='a'><onentry>dark</onentry></state>  | text 'dark' in onentry of state 'a' is not an action; write <script>dark</script>",
                "<state id='a'><onexit><log/>dark</onexit></state> | text 'dark' in onexit of state 'a' is not an action",
                "<state id='a'><transition event='e' target='a'>click</transition></state> | text 'click' in transition of state 'a' is not",
                "<state id='a'><initial><transition target='b'>go</transition></initial><state id='b'/></state> | text 'go' in transition of state 'a'",
                "<state id='a'>dark</state>                     | text 'dark' in state 'a' means nothing; remove it",
                "<state id='a'/><final id='f'>over</final>      | text 'over' in final 'f' means nothing; remove it",
                "<state id='a'/>dark                            | text in scxml means nothing; remove it",
                "<state id='a'><onentry><assign location='x' expr='1'>2</assign></onentry></state> | assign of state 'a' has a value in an attribute and another",
                "<state id='a'><onentry><script src='x.js'>y()</script></onentry></state> | script of state 'a' has a value in an attribute and another",
                "<datamodel><data id='x' expr='1'>2</data></datamodel><state id='a'/> | data of scxml has a value in an attribute and another",
                "<state id='a'><transition event='e' target='a' type='inner'/></state> | transition of state 'a' is of the unknown type 'inner'; use internal or external",
                "<state id='a'><history id='h' type='Deep'/><state id='b'/></state> | history of state 'a' is of the unknown type 'Deep'; use shallow or deep",
                "<state id='a'><history id='h'><transition target='b' after='2s'/></history><state id='b'/></state>"
                        + " | attribute after of transition of history 'h' is not supported",
                "<state id='a' initial='b'/><state id='b'/>     | initial of state 'a' leads nowhere, since the state holds no other",
                "<state id='a'><transition event='e, f' target='a'/></state> | event 'e,' of transition of state 'a' ends in a separator",
            })
    void shouldRefuse(String content, String problem) {
        assertThat(ChartText.refusal(scxml(content)))
                .containsPattern("line [123]: ")
                .contains(problem);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "after 2,5 s    | has a comma; write a point before decimals",
                "tm(2,5s)       | has a comma; write a point before decimals",
                "after 1.500,5 s | has a comma; write a point before decimals",
                "after 2 parsec | needs a number and a unit",
            })
    void aTimeThatCannotBeReadIsNotTakenForSeveralEvents(String event, String problem) {
        XmiMachine machine = ChartText.machines(
                        scxml("<state id='a'><transition event='x %s y' target='a'/></state>".formatted(event)))
                .get(0);

        assertThat(ChartText.of(machine.statechart())).contains("a -> a : x, " + event + ", y");
        assertThatThrownBy(machine::toStateMachine)
                .hasMessageContaining("line 2: time trigger '" + event + "' " + problem);
    }

    @Test
    void textInAnothersElementsIsKept() {
        assertThat(ChartText.of(scxml("""
                        <state id='a'>
                          <onentry><x:say xmlns:x='urn:x'>hello</x:say></onentry>
                          <invoke><content>any <state>text</state></content></invoke>
                        </state>""")))
                .contains("state a a entry[say {hello}] do[invoke {content {any; state {text}}}]");
    }

    @ParameterizedTest
    @CsvSource({"true", "TRUE", "' true '", "true()"})
    void aConditionThatAlwaysHoldsIsNone(String condition) {
        String content = "<state id='a'><transition cond='x' target='b'/><transition cond='%s' target='c'/></state>"
                + "<state id='b'><transition event='e' cond='%s' target='a'/></state><state id='c'/>";

        assertThat(ChartText.of(scxml(content.formatted(condition, condition))))
                .contains("a -> b : [x]", "a -> c", "b -> a : e");
    }

    @ParameterizedTest
    @CsvSource({"else", "Else", "[else]", "otherwise"})
    void elseIsTakenIfNothingElseIs(String word) {
        String content = "<state id='a'><transition event='e' cond='%s' target='b'/>"
                + "<transition event='e' cond='x' target='c'/></state>"
                + "<state id='b'><transition cond='%s' target='a'/><transition cond='x' target='c'/></state><state id='c'/>";

        assertThat(ChartText.of(scxml(content.formatted(word, word))))
                .containsSubsequence("a -> c : e [x]", "a -> b : e", "b -> c : [x]", "b -> a");
    }

    @Test
    void aTransitionThatIsNeverTakenIsNoted() {
        String content = """
                <state id='a'>
                  <transition cond='x' target='b'/><transition cond='x' target='c'/>
                  <transition event='e' cond='false' target='b'/>
                </state><state id='b'/><state id='c'/>""";

        assertThat(ChartText.of(scxml(content))).contains("a -> b : when x").doesNotContain("a -> c : when x");
        assertThat(notes(content))
                .satisfiesExactly(
                        first -> assertThat(first)
                                .contains("line 3: transition of state 'a' is never taken, since an earlier one has"),
                        second -> assertThat(second)
                                .contains(
                                        "line 4: transition of state 'a' is never taken, since its condition is 'false'"));
    }
}
