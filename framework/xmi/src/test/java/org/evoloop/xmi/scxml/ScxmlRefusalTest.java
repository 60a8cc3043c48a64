package org.evoloop.xmi.scxml;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.xmi.ChartText;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Elements that do not belong in a chart are named, with the line and a remedy. */
class ScxmlRefusalTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''                                              | scxml has no state; write one",
                "<state id='a'/><state id='a'/>                  | state 'a' has the id of the state in line 2; give each an id of its own",
                "<state id='a' src='b.xml'/>                     | attribute src of state 'a' is not supported; remove it",
                "<state id='a'><transitoin/></state>             | element transitoin in state 'a' is not supported; remove it",
                "<state id='a'><x:t xmlns:x='urn:x'/></state>    | element t in state 'a' is not supported; remove it",
                "<state id='a'><transition event='e' target='b'/></state> | transition of state 'a' leads to 'b', which is not a state; correct the id",
                "<state id='a'><transition evnet='e' target='a'/></state> | attribute evnet of transition of state 'a' is not supported",
                "<state id='a' initial='c'><state id='b'/></state>        | initial leads to 'c', which is not a state",
                "<state id='a'><transition event='e' target='b c'/></state><state id='b c'/> | transition of state 'a' leads to 'b', which is not a state",
                "<state id='a'><initial/><state id='b'/></state>          | initial of state 'a' is not one transition; write one",
                "<state id='a'><transition event='e' target='b c'/></state><state id='b'/><state id='c'/>"
                        + " | transition of state 'a' has targets that do not stand in different children of one parallel state",
                "<state id='a' final='true'><state id='b'/></state> | state 'a' is final but goes on; let it end here",
            })
    void shouldRefuse(String content, String problem) {
        assertThat(ChartText.refusal(ScxmlReadingTest.scxml(content)))
                .containsPattern("line [12]: ")
                .contains(problem);
    }
}
