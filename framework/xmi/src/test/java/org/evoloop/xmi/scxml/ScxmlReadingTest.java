package org.evoloop.xmi.scxml;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.xmi.ChartText;
import org.junit.jupiter.api.Test;

class ScxmlReadingTest {
    static String scxml(String content) {
        return "<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0'>\n" + content + "\n</scxml>";
    }

    @Test
    void shouldReadHierarchyWithInitialStatesAndHistory() {
        assertThat(ChartText.of(scxml("""
                        <state id='flow' initial='b'>
                          <history id='h' type='deep'><transition target='a'><log expr='1'/></transition></history>
                          <state id='a'/><state id='b'><transition event='next' target='end'/></state>
                          <final id='end'/>
                          <transition event='pause' target='out'/>
                        </state>
                        <state id='out'><transition event='resume' target='h'/></state>""")))
                .containsExactly(
                        "INITIAL #1",
                        "state flow flow",
                        "  INITIAL #2",
                        "  DEEP_HISTORY h h",
                        "  state a a",
                        "  state b b",
                        "  FINAL end end",
                        "  h -> a : / log(expr='1')",
                        "  b -> end : next",
                        "  #2 -> b",
                        "state out out",
                        "flow -> out : pause",
                        "out -> h : resume",
                        "#1 -> flow");
    }

    @Test
    void shouldReadParallelStatesAndForks() {
        assertThat(ChartText.of(scxml("""
                        <state id='s'><transition event='go' target='a2 b2'/></state>
                        <parallel id='p'>
                          <state id='a'><state id='a1'/><state id='a2'/></state>
                          <state id='b'><state id='b1'/><state id='b2'/></state>
                        </parallel>""")))
                .containsExactly(
                        "INITIAL #2",
                        "state s s",
                        "state p p",
                        "  region a",
                        "  INITIAL #3",
                        "  state a a",
                        "    INITIAL #4",
                        "    state a1 a1",
                        "    state a2 a2",
                        "    #4 -> a1",
                        "  #3 -> a",
                        "  region b",
                        "  INITIAL #5",
                        "  state b b",
                        "    INITIAL #6",
                        "    state b1 b1",
                        "    state b2 b2",
                        "    #6 -> b1",
                        "  #5 -> b",
                        "FORK #1",
                        "#1 -> a2",
                        "#1 -> b2",
                        "s -> #1 : go",
                        "#2 -> s");
    }

    @Test
    void shouldMatchEventsByPrefixAmongThoseOfTheDocument() {
        assertThat(ChartText.of(scxml("""
                        <state id='s'>
                          <transition event='a.b.*' cond='x' target='s'/><transition event='a' target='s'/>
                          <transition event='ab c' target='s'/><transition event='*' target='s'/>
                          <onentry><send event='a.x'/><send event='d'/></onentry>
                        </state>""")))
                .contains("s -> s : a.b [x]", "s -> s : a, a.b, a.x", "s -> s : ab, c", "s -> s : *, d");
    }

    @Test
    void shouldReadTimeTriggersThoughTheyHaveBlanks() {
        assertThat(ChartText.of(scxml("""
                        <state id='s'>
                          <transition event='after 2 s' target='s'/><transition event='a after  1.5 min b' target='s'/>
                          <transition event='tm( 3s ) after (4 s)' target='s'/><transition event='PT5S' target='s'/>
                          <transition event='after PT6S after 7' target='s'/><transition event='after' target='s'/>
                        </state>""")))
                .contains(
                        "s -> s : after 2 s",
                        "s -> s : a, after 1.5 min, b",
                        "s -> s : tm( 3s ), after (4 s)",
                        "s -> s : PT5S",
                        "s -> s : after PT6S, after 7",
                        "s -> s : after");
    }

    @Test
    void shouldKeepExecutableContentAsText() {
        assertThat(ChartText.of(scxml("""
                        <datamodel><data id='n' expr='1'/><data id='m'>[1, 2]</data></datamodel>
                        <script>start()</script>
                        <state id='s'>
                          <onentry><assign location='n' expr='n + 1'/><send event='e'/></onentry>
                          <onentry><send event='tick' target='http://x'/></onentry>
                          <onexit><if cond='n > 1'><log expr='n'/><else/><script>f()</script></if></onexit>
                          <invoke type='scxml' src='other.scxml'/>
                          <transition event='e'><script>g()</script></transition>
                        </state>""")))
                .containsExactly(
                        "INITIAL #1",
                        "state s s entry[n = n + 1, send(event='e'), send(event='tick', target='http://x')]"
                                + " exit[if(cond='n > 1') {log(expr='n'); else; f()}]"
                                + " do[invoke(type='scxml', src='other.scxml')]",
                        "  s -> s : e / g() INTERNAL",
                        "#1 -> s : / n = 1; m {[1, 2]}; start()");
    }

    @Test
    void shouldRunTheScriptAfterTheDataOfAllStates() {
        assertThat(ChartText.of(scxml("""
                        <script>start(n)</script>
                        <state id='s'><datamodel><data id='n' expr='1'/></datamodel></state>"""))).contains("#1 -> s : / n = 1; start(n)");
    }

    @Test
    void shouldTakeTransitionsWithoutEventForWhatTheyAre() {
        assertThat(ChartText.of(scxml("""
                        <state id='choose'><transition cond='x' target='wait'/><transition target='over'/></state>
                        <state id='wait'><transition cond='ready' target='over'/></state>
                        <final id='over'/>""")))
                .contains("choose -> wait : [x]", "choose -> over", "wait -> over : when ready");
    }

    @Test
    void shouldTakeBeingDoneForAnEvent() {
        assertThat(ChartText.of(scxml("""
                        <state id='outer'>
                          <state id='inner'><final id='f'/><transition event='done.state.inner' cond='x' target='b'/></state>
                          <state id='b'/>
                          <transition event='done.state.inner' target='c'/>
                        </state>
                        <state id='c'><transition event='done.state.elsewhere' target='b'/></state>""")))
                .contains("  inner -> b : done.state.inner [x]", "outer -> c : done.state.inner")
                .contains("c -> b : done.state.elsewhere");
    }

    @Test
    void shouldMatchNoTimeTriggerByPrefix() {
        assertThat(ChartText.of(scxml("""
                        <state id='s'><transition event='* after' target='t'/><transition event='PT1' target='s'/></state>
                        <state id='t'><transition event='after 5 s' target='s'/><transition event='PT1.5S' target='s'/>
                          <transition event='tm(7)' target='s'/><transition event='e' target='s'/></state>""")))
                .contains("s -> t : *, PT1, after, e", "t -> s : after 5 s", "t -> s : PT1.5S", "t -> s : tm(7)");
    }

    @Test
    void shouldDistinguishLocalTransitionsFromOthers() {
        assertThat(ChartText.of(scxml("""
                        <state id='s'><state id='a'/>
                        <transition event='e' type='internal' target='a'/><transition event='f' target='a'/></state>"""))).contains("s -> a : e LOCAL", "s -> a : f");
    }

    @Test
    void shouldKeepWhatAFinalStateDoes() {
        assertThat(ChartText.of(scxml("<final id='f'><onentry><log label='bye'/></onentry>"
                        + "<onexit><script>over</script></onexit></final>")))
                .containsExactly("INITIAL #1", "FINAL f f entry[log(label='bye')] exit[over]", "#1 -> f");
    }

    @Test
    void shouldReadWhatDraftsAndEditorsWrote() {
        assertThat(ChartText.of("""
                        <scxml xmlns='http://www.w3.org/2005/07/scxml' initialstate='b' xmlns:qt='http://www.qt.io/2015/02/scxml-ext'>
                        <qt:editorinfo geometry='1;2'/>
                        <state id='a' final='true'/>
                        <state id='b' qt:color='red'><initial><transition><target next='c'/></transition></initial>
                        <state id='c'><transition event='e'><target next='a'/></transition></state></state>
                        </scxml>"""))
                .containsExactly(
                        "INITIAL #1",
                        "FINAL a a",
                        "state b b",
                        "  INITIAL #2",
                        "  state c c",
                        "  c -> a : e",
                        "  #2 -> c",
                        "#1 -> b");
    }

    @Test
    void shouldCallAMachineByItsNameOrFile() {
        assertThat(ChartText.machines(scxml("<state id='s'/>")).get(0).name()).isEqualTo("F");
        assertThat(ChartText.machines("<scxml name='Robot'><state id='s'/></scxml>")
                        .get(0)
                        .name())
                .isEqualTo("Robot");
    }
}
