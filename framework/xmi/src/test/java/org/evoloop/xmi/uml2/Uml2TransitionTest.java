package org.evoloop.xmi.uml2;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;
import static org.evoloop.xmi.uml2.Uml2Text.machine;
import static org.evoloop.xmi.uml2.Uml2Text.state;
import static org.evoloop.xmi.uml2.Uml2Text.transition;

import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The parts of transitions, as different tools write them. */
class Uml2TransitionTest {
    private static final String TRIGGER = "<trigger xmi:type='uml:Trigger' xmi:id='tr' event='e'/>";

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "SignalEvent   | signal='s'        |                                          | Start",
                "SignalEvent   | name='go'         |                                          | go",
                "CallEvent     | operation='o'     |                                          | run",
                "CallEvent     | name='called'     |                                          | called",
                "TimeEvent     | isRelative='true' | <when><expr xmi:type='uml:LiteralString' value='2 s'/></when>      | after 2 s",
                "TimeEvent     | isRelative='true' | <when><expr xmi:type='uml:LiteralInteger' value='1000'/></when>    | after 1000",
                "TimeEvent     | isRelative='true' | <when xmi:type='uml:TimeExpression'><expr xmi:type='uml:OpaqueExpression'><body>after(3 min)</body></expr></when> | after(3 min)",
                "TimeEvent     | name='x'          | <when><expr xmi:type='uml:LiteralString' value='12:00'/></when>    | at 12:00",
                "TimeEvent     | name='x'          | <when><expr xmi:type='uml:LiteralString' value='PT5S'/></when>     | PT5S",
                "TimeEvent     | isRelative='true' | <when><expr xmi:type='uml:LiteralString' value='P1DT2H'/></when>   | P1DT2H",
                "TimeEvent     | name='after 2 s'  |                                          | after 2 s",
                "ChangeEvent   | name='x'          | <changeExpression xmi:type='uml:OpaqueExpression' body='p &gt; 3'/> | when p > 3",
                "ChangeEvent   | name='full'       |                                          | full",
                "AnyReceiveEvent | name='bump'     |                                          | bump",
                "Event         | name='plain'      |                                          | plain",
            })
    void shouldCallAnEventByWhatItIsAbout(String type, String attributes, String content, String name) {
        String event = "<packagedElement xmi:type='uml:" + type + "' xmi:id='e' " + attributes + ">"
                + (content == null ? "" : content) + "</packagedElement>";

        assertThat(ChartText.of(transition(
                        "",
                        TRIGGER,
                        event,
                        "<packagedElement xmi:type='uml:Signal' xmi:id='s' name='Start'/>",
                        "<packagedElement xmi:type='uml:Operation' xmi:id='o' name='run'/>")))
                .contains("a -> b : " + name);
    }

    @Test
    void shouldReadATriggerInThePackage() {
        assertThat(ChartText.of(transition(
                        "kind='local'",
                        "<trigger xmi:idref='tr'/><effect xmi:type='uml:OpaqueBehavior' xmi:id='f' body='on()'/>",
                        "<packagedElement xmi:type='uml:Trigger' xmi:id='tr' name='toggle'>"
                                + "<event xmi:type='uml:Event' xmi:id='e'/></packagedElement>")))
                .contains("a -> b : toggle / on() LOCAL");
    }

    @Test
    void shouldReadTheEventsThatStarUmlWritesTwice() {
        String document = transition(
                        "",
                        "<ownedMember xmi:id='e' name='EV' xmi:type='uml:AnyReceiveEvent'/>"
                                + "<trigger xmi:id='tr' xmi:type='uml:Trigger' name='EV' event='e'/>"
                                + "<trigger xmi:id='e' name='EV' xmi:type='uml:AnyReceiveEvent'/>"
                                + "<guard xmi:id='g' xmi:type='uml:Constraint' specification='x &lt; 3'/>")
                .replace("<uml:Model", "<xmi:XMI xmlns:xmi='http://schema.omg.org/spec/XMI/2.1'><uml:Model")
                .replace("</uml:Model>", "</uml:Model></xmi:XMI>");

        assertThat(ChartText.of(document)).contains("a -> b : EV [x < 3]");
    }

    @Test
    void shouldReadSeveralTriggersWithTheirPorts() {
        assertThat(ChartText.of(transition(
                        "",
                        "<trigger xmi:id='t1' name='one'/><trigger xmi:id='t2' name='two' port='p'/>",
                        "<packagedElement xmi:type='uml:Port' xmi:id='p' name='left'/>")))
                .contains("a -> b : one, two from left");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "<guard xmi:id='g'><specification xmi:type='uml:OpaqueExpression'><language>C</language><body>x</body></specification></guard>",
                "<guard xmi:id='g'><specification xmi:type='uml:OpaqueExpression' body='x'/></guard>",
                "<guard xmi:id='g'><specification xmi:type='uml:LiteralString' value='[x]'/></guard>",
                "<guard xmi:id='g'><specification xmi:type='uml:Expression' symbol='x'/></guard>",
                "<guard xmi:id='g' name='x'/>",
            })
    void shouldReadAGuard(String guard) {
        assertThat(ChartText.of(transition("", guard))).contains("a -> b : [x]");
    }

    @Test
    void shouldReadAGuardThatIsAnOwnedRule() {
        assertThat(ChartText.of(transition(
                        "guard='g'",
                        "<ownedRule xmi:type='uml:Constraint' xmi:id='g'>"
                                + "<specification xmi:type='uml:LiteralBoolean' value='false'/></ownedRule>")))
                .contains("a -> b : [false]");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<guard xmi:id='g'><specification xmi:type='uml:LiteralBoolean' value='false'/></guard> | guard '' (id 'g') is false",
                "<guard xmi:id='g'><specification xmi:type='uml:LiteralBoolean'/></guard> | guard '' (id 'g') is false, so its",
                "<effect xmi:type='uml:OpaqueBehavior' xmi:id='f'/> | has neither a body nor a name and is ignored",
                "<effect xmi:type='uml:OpaqueBehavior' xmi:id='f'><body> </body></effect> | has neither a body nor a name",
            })
    void shouldNoteWhatIsNeverDone(String content, String note) {
        XmiMachine machine = ChartText.machines(transition("", content)).get(0);

        assertThat(machine.statechart().name()).isNotNull();
        assertThat(machine.notes()).singleElement().asString().contains(note);
    }

    @ParameterizedTest
    @ValueSource(strings = {"2 s", "1000", "1,5min"})
    void shouldRefuseADelayThatIsNotRelative(String delay) {
        assertThat(ChartText.refusal(transition(
                        "",
                        TRIGGER,
                        "<packagedElement xmi:type='uml:TimeEvent' xmi:id='e'><when>"
                                + "<expr xmi:type='uml:LiteralString' value='" + delay
                                + "'/></when></packagedElement>")))
                .contains("time event '' (id 'e') has the delay '" + delay + "', but isRelative is not true");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<effect xmi:type='uml:OpaqueBehavior' name='n'><body>beep()</body></effect>            | beep()",
                "<effect xmi:type='uml:OpaqueBehavior' name='n'><body/><body>beep</body></effect>       | beep",
                "<effect xmi:type='uml:OpaqueBehavior' name='beep'/>                                    | beep",
                "<effect xmi:type='uml:Activity' name='Sing'><node xmi:type='uml:InitialNode' xmi:id='n'/></effect> | Sing",
                "<effect xmi:type='uml:FunctionBehavior' name='f'/>                                     | f",
            })
    void shouldCallAnEffectByItsCodeOrName(String effect, String text) {
        assertThat(ChartText.of(transition("", effect))).contains("a -> b : / " + text);
    }

    @Test
    void shouldReadTheKindsOfTransition() {
        String composite = "<subvertex xmi:type='uml:State' xmi:id='c' name='C'><region>" + state("a", "A")
                + "</region></subvertex>";
        String arc = "<transition xmi:id='%s' source='%s' target='%s' kind='%s'/>";

        assertThat(ChartText.of(machine(composite
                        + state("b", "B")
                        + arc.formatted("1", "c", "a", "local")
                        + arc.formatted("2", "c", "b", "local")
                        + arc.formatted("3", "b", "b", "local")
                        + arc.formatted("4", "c", "c", "internal"))))
                .containsExactly(
                        "state c C",
                        "  c -> c : INTERNAL",
                        "  state a A",
                        "state b B",
                        "c -> a : LOCAL",
                        "c -> b : LOCAL",
                        "b -> b : LOCAL");
    }

    @Test
    void shouldNotLeaveAStateOnALocalTransitionToItself() {
        String document = machine("<subvertex xmi:type='uml:Pseudostate' xmi:id='i'/>"
                + "<subvertex xmi:type='uml:State' xmi:id='a' name='Bound'>"
                + "<entry xmi:type='uml:OpaqueBehavior' name='start'/></subvertex>"
                + "<transition xmi:id='0' source='i' target='a'/>"
                + "<transition xmi:id='1' source='a' target='a' kind='local'><trigger xmi:id='t' name='ack'/>"
                + "<effect xmi:type='uml:OpaqueBehavior' name='renew'/></transition>");

        Transition transition = ChartText.machines(document)
                .get(0)
                .toStateMachine()
                .transitions()
                .get(0);

        assertThat(transition.internal()).isTrue();
        assertThat(transition.effects()).containsExactly("renew");
    }

    @Test
    void shouldNoteThatEnterpriseArchitectMeansNothingByLocal() {
        String arc = "<transition xmi:id='%s' source='%s' target='%s' kind='local'/>";
        String document = machine("<subvertex xmi:type='uml:State' xmi:id='c' name='C'><region>" + state("a", "A")
                        + "</region></subvertex>"
                        + state("b", "B")
                        + arc.formatted("1", "c", "a")
                        + arc.formatted("2", "c", "b")
                        + arc.formatted("3", "b", "b"))
                .replace(
                        "<uml:Model",
                        "<xmi:XMI xmlns:xmi='http://schema.omg.org/spec/XMI/2.1'>"
                                + "<xmi:Documentation exporter='Enterprise Architect'/><uml:Model")
                .replace("</uml:Model>", "</uml:Model></xmi:XMI>");

        assertThat(ChartText.of(document)).contains("c -> a : LOCAL", "c -> b", "b -> b");
        assertThat(ChartText.machines(document).get(0).notes())
                .singleElement(as(STRING))
                .contains("F.xml: line 6: transition '' (id '3') is taken as external");
    }
}
