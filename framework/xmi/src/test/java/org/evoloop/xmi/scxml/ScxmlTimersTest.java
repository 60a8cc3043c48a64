package org.evoloop.xmi.scxml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.xmi.scxml.ScxmlReadingTest.scxml;

import java.util.List;
import org.evoloop.xmi.ChartText;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Events that a document sends or raises itself. */
class ScxmlTimersTest {
    private static final String LAMP = """
            <state id='off'><transition event='press' target='on'/></state>
            <state id='on'>%s<transition event='over' target='off'/><transition event='press' target='off'/></state>""";

    private static List<String> notes(String content) {
        return ChartText.machines(scxml(content)).get(0).notes();
    }

    @ParameterizedTest
    @CsvSource({
        "delay='2s',after 2 s",
        "delay=' 500 ms ',after 500 ms",
        "delay='.5s',after 0.5 s",
        "delay='1m',after 1 min",
        "delay='1500',after 1500",
        "delay='0s' type='scxml',after 0 s",
        "delayexpr=\"'2s'\",after 2 s"
    })
    void aSendWithADelayIsTheTimerOfTheStateThatTakesIt(String delay, String trigger) {
        String content = LAMP.formatted("<onentry><send event=\"over\" id='t' " + delay.replace("''", "'")
                + "/></onentry><onexit><cancel sendid='t'/><script>dark</script></onexit>");

        assertThat(ChartText.of(scxml(content)))
                .contains("state on on exit[dark]", "on -> off : " + trigger)
                .doesNotContain("on -> off : over");
        assertThat(notes(content)).isEmpty();
    }

    @Test
    void aTimerMayBeCancelledByTheTransitionThatLeavesItsState() {
        String content = """
                <state id='on'>
                  <onentry><send event='t.over' id='t' delay='2s'/></onentry>
                  <onentry><send event='t.long' id='u' delay='5s'/></onentry>
                  <transition event='press t' target='off'><cancel sendid='t'/><cancel sendid='u'/></transition>
                  <state id='dim'><transition event='out' target='off'><cancel sendid='t'/></transition></state>
                </state><state id='off'/>""";

        assertThat(ChartText.of(scxml(content)))
                .contains("on -> off : press, t, after 2 s, after 5 s", "  dim -> off : out");
        assertThat(notes(content)).isEmpty();
    }

    @Test
    void twoStatesMayGiveTheirTimersOneName() {
        assertThat(ChartText.of(scxml("""
                        <state id='red'><onentry><send event='next' delay='30s'/></onentry>
                          <transition event='next' target='green'/></state>
                        <state id='green'><onentry><send event='next' delay='20s'/></onentry>
                          <transition event='next' target='red'/></state>"""))).contains("red -> green : after 30 s", "green -> red : after 20 s");
    }

    @Test
    void itIsNotedThatATimerEndsWithItsState() {
        assertThat(notes(LAMP.formatted("<onentry><send event='over' delay='2s'/></onentry>")))
                .singleElement()
                .asString()
                .contains(
                        "line 3: send of 'over' is read as the timer 'after 2 s' of state 'on'",
                        "which ends when that is left, though SCXML would deliver it later, too");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<onentry><send event='over' delayexpr='x'/></onentry> | its delay is not a number with a unit; write event=\"after 2 s\"",
                "<onentry><send event='over' delay='2s' target='#_internal'/></onentry> | it goes to somebody else; write event=\"after 2 s\"",
                "<onentry><send event='over' delay='2s' type='http'/></onentry> | it goes to somebody else",
                "<onentry><send event='over' delay='2s' namelist='x'/></onentry> | it carries more than its event",
                "<onentry><send event='over' delay='2s'><param name='x'/></send></onentry> | it carries more than its event",
                "<onentry><send eventexpr='x' delay='2s'/></onentry> | it names no event",
                "<onentry><if cond='x'><send event='over' delay='5s'/></if></onentry> | it is not always run when a state is entered; write event=\"after 5 s\"",
                "<onexit><send event='over' delay='2s'/></onexit> | send in onexit of state 'on' is not the timer of a state",
                "<transition event='x'><send event='over' delay='2s'/></transition> | send in transition of state 'on' is not",
                "<onentry><send event='nobody' delay='2s'/></onentry> | no transition of state 'on' takes its event",
                "<onentry><send event='in' delay='2s'/></onentry><state id='a'><transition event='in' target='off'/></state>"
                        + " | no transition of state 'on' takes its event",
                "<onentry><send event='press' delay='2s'/></onentry> | state 'off' takes its event, too",
                "<onentry><send event='over' id='t' delay='2s'/></onentry><transition event='x'><cancel sendid='t'/></transition>"
                        + " | cancel in transition of state 'on' ends a timer while its state lasts",
                "<onentry><send event='over' id='t' delay='2s'/></onentry><onexit><cancel sendidexpr='x'/></onexit>"
                        + " | cancel in onexit of state 'on' does not name the timer",
            })
    void anyOtherSendWithADelayIsRefused(String content, String problem) {
        assertThat(ChartText.refusal(scxml(LAMP.formatted(content)))).contains("line 3: ", problem);
    }

    @Test
    void aStateThatRaisesTheEventOnWhichItIsLeftIsLeftAtOnce() {
        String content = """
                <state id='a'><transition event='go' target='b'/></state>
                <state id='b'><onentry><script>hello</script><raise event='auto.b'/></onentry>
                  <transition event='auto' target='a'/></state>""";

        assertThat(ChartText.of(scxml(content))).contains("state b b entry[hello]", "b -> a");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<onentry><raise event='over'/><raise event='x'/></onentry> | raise in onentry of state 'on' raises 'over' before all",
                "<onentry><if cond='x'><raise event='over'/></if></onentry> | raise in onentry of state 'on' raises 'over' before all",
                "<onentry><raise event='over'/></onentry><state id='inner'/> | raise in onentry of state 'on' raises 'over' before all",
                "<transition event='x'><raise event='over'/></transition> | raise in transition of state 'on' raises 'over' before all",
            })
    void anyOtherEventThatIsRaisedIsRefused(String content, String problem) {
        assertThat(ChartText.refusal(scxml(LAMP.formatted(content))))
                .contains("line 3: ", problem, "write <send event=\"over\"/>");
    }

    @Test
    void anEventThatNobodyTakesIsNoted() {
        String content = LAMP.formatted("<onentry><raise event='nobody'/></onentry>");

        assertThat(ChartText.of(scxml(content))).contains("state on on");
        assertThat(notes(content)).singleElement().asString().contains("raises 'nobody', which no transition takes");
    }
}
