package org.evoloop.xmi.uml14;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class Uml14ReadingTest {
    static final int FIRST_LINE = 9;
    static final String TRANSITIONS = "</UML:CompositeState.subvertex></UML:CompositeState></UML:StateMachine.top>"
            + "<UML:StateMachine.transitions>";

    static String document(String machines) {
        return """
                <?xml version = '1.0' encoding = 'UTF-8' ?>
                <XMI xmi.version = '1.2' xmlns:UML = 'org.omg.xmi.namespace.UML'>
                <XMI.header><XMI.documentation><XMI.exporter>ArgoUML</XMI.exporter></XMI.documentation></XMI.header>
                <XMI.content><UML:Model xmi.id='model' name='m'><UML:Namespace.ownedElement>
                """ + machines + "\n</UML:Namespace.ownedElement></UML:Model></XMI.content></XMI>";
    }

    /** @param vertices and, after {@link #TRANSITIONS}, transitions */
    static String machine(String id, String vertices) {
        String end = vertices.contains("<UML:StateMachine.transitions>")
                ? "</UML:StateMachine.transitions>"
                : "</UML:CompositeState.subvertex></UML:CompositeState></UML:StateMachine.top>";
        return "<UML:StateMachine xmi.id='" + id + "' name='" + id
                + "' isSpecification='false'>\n<UML:StateMachine.top>\n"
                + "<UML:CompositeState xmi.id='top" + id + "' name='top' isConcurrent='false'>\n"
                + "<UML:CompositeState.subvertex>\n" + vertices + end + "\n</UML:StateMachine>";
    }

    static String transition(String content, String... beside) {
        return document(machine(
                        "m",
                        "<UML:SimpleState xmi.id='a' name='A'/><UML:SimpleState xmi.id='b' name='B'/>" + TRANSITIONS
                                + "<UML:Transition xmi.id='t'><UML:Transition.source><UML:SimpleState xmi.idref='a'/>"
                                + "</UML:Transition.source><UML:Transition.target><UML:SimpleState xmi.idref='b'/>"
                                + "</UML:Transition.target>" + content + "</UML:Transition>")
                + String.join("\n", beside));
    }

    private static String action(String role, String text) {
        return "<UML:" + role + "><UML:CallAction xmi.id='ac" + text + "' name='anon'><UML:Action.script>"
                + "<UML:ActionExpression xmi.id='ex" + text + "' language='' body='" + text + "'/></UML:Action.script>"
                + "</UML:CallAction></UML:" + role + ">";
    }

    @Test
    void shouldReadStatesWithActionsAndRegions() {
        assertThat(ChartText.of(document(machine(
                        "m",
                        "<UML:CompositeState xmi.id='c' name='C' isConcurrent='true'><UML:CompositeState.subvertex>"
                                + "<UML:CompositeState xmi.id='r1' name='left'><UML:CompositeState.subvertex>"
                                + "<UML:FinalState xmi.id='f'/></UML:CompositeState.subvertex></UML:CompositeState>"
                                + "<UML:CompositeState xmi.id='r2'><UML:CompositeState.subvertex>"
                                + "<UML:Pseudostate xmi.id='h' kind='deepHistory'/>"
                                + "</UML:CompositeState.subvertex></UML:CompositeState>"
                                + "</UML:CompositeState.subvertex></UML:CompositeState>"
                                + "<UML:SimpleState xmi.id='s' name='S'>" + action("State.entry", "in")
                                + action("State.exit", "out") + action("State.doActivity", "work")
                                + "<UML:State.internalTransition><UML:Transition xmi.id='i'><UML:Transition.trigger>"
                                + "<UML:Event xmi.id='e' name='tick'/></UML:Transition.trigger></UML:Transition>"
                                + "</UML:State.internalTransition><UML:State.deferrableEvent>"
                                + "<UML:SignalEvent xmi.idref='e'/></UML:State.deferrableEvent></UML:SimpleState>"
                                + "<UML:CompositeState xmi.id='k' name='K'/>"))))
                .containsExactly(
                        "state c C",
                        "  region left",
                        "  FINAL f",
                        "  DEEP_HISTORY h",
                        "state s S entry[in] exit[out] do[work] defer[tick]",
                        "  s -> s : tick INTERNAL",
                        "state k K");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<UML:SignalEvent xmi.id='e' name='EV'/>          | EV",
                "<UML:SignalEvent xmi.id='e' signal='s'/>         | Sig",
                "<UML:CallEvent xmi.id='e' name='call()'/>        | call()",
                "<UML:ChangeEvent xmi.id='e' name='c'/>           | c",
                "<UML:ChangeEvent xmi.id='e'><UML:ChangeEvent.changeExpression><UML:BooleanExpression body='x &gt; 1'/></UML:ChangeEvent.changeExpression></UML:ChangeEvent> | when x > 1",
                "<UML:TimeEvent xmi.id='e'><UML:TimeEvent.when><UML:TimeExpression body='2 s'/></UML:TimeEvent.when></UML:TimeEvent> | after 2 s",
                "<UML:TimeEvent xmi.id='e' name='after(2 s)'/>    | after(2 s)",
                "<UML:Event xmi.id='e'><UML:ModelElement.namespace><UML:Namespace><UML:Namespace.ownedElement><UML:CallEvent xmi.id='w' name='call'/></UML:Namespace.ownedElement></UML:Namespace></UML:ModelElement.namespace></UML:Event> | call",
            })
    void shouldCallAnEventByWhatIsDrawn(String event, String name) {
        String signal = "<UML:Signal xmi.id='s' name='Sig'/>";
        String reference = "<UML:Transition.trigger><UML:Event xmi.idref='e'/></UML:Transition.trigger>";

        assertThat(ChartText.of(transition(reference, event, signal))).contains("a -> b : " + name);
        assertThat(ChartText.of(transition("<UML:Transition.trigger>" + event + "</UML:Transition.trigger>", signal)))
                .contains("a -> b : " + name);
    }

    @Test
    void shouldReadGuardsAndEffectsInOrder() {
        assertThat(ChartText.of(transition(
                        "<UML:Transition.guard><UML:Guard xmi.id='g'><UML:Guard.expression>"
                                + "<UML:BooleanExpression xmi.id='x' language='' body='else'/></UML:Guard.expression></UML:Guard>"
                                + "</UML:Transition.guard><UML:Transition.effect><UML:ActionSequence xmi.id='q' name='both'>"
                                + "<UML:ActionSequence.action><UML:UninterpretedAction name='one'/><UML:SendAction signal='s'/>"
                                + "</UML:ActionSequence.action></UML:ActionSequence></UML:Transition.effect>"
                                + "<UML:ModelElement.taggedValue><UML:TaggedValue tag='ea' value='x'/>"
                                + "</UML:ModelElement.taggedValue>",
                        "<UML:Signal xmi.id='s' name='two'/>")))
                .contains("a -> b : [else] / one; two");
    }

    @Test
    void shouldReadReferencesInAttributes() {
        assertThat(ChartText.of(document(machine(
                                "m",
                                "<UML:PseudoState xmi.id='i' kind='initial'/><UML:PseudoState xmi.id='f' kind='final'/>"
                                        + TRANSITIONS
                                        + "<UML:Transition xmi.id='t' source='i' target='f' trigger='e'/>")
                        + "<UML:SignalEvent xmi.id='e' name='EV'/>")))
                .containsExactly("INITIAL i", "FINAL f", "i -> f : EV");
    }

    @Test
    void shouldReadXmi10() {
        String core = "Foundation.Core.ModelElement.name";
        String states = "Behavioral_Elements.State_Machines.";

        assertThat(ChartText.of("<XMI xmi.version='1.0'><XMI.content><" + states + "StateMachine xmi.id='m'><" + core
                        + ">M</" + core + "><" + states + "StateMachine.top><" + states + "CompositeState xmi.id='c'><"
                        + states + "CompositeState.isConcurrent xmi.value='false'/><" + states
                        + "CompositeState.subvertex><" + states + "SimpleState xmi.id='a'><" + core + ">A</" + core
                        + "></" + states + "SimpleState><" + states + "Pseudostate xmi.id='p'><" + states
                        + "Pseudostate.kind xmi.value='branch'/></" + states + "Pseudostate></" + states
                        + "CompositeState.subvertex></" + states + "CompositeState></" + states + "StateMachine.top></"
                        + states + "StateMachine></XMI.content></XMI>"))
                .containsExactly("state a A", "JUNCTION p");
    }

    @Test
    void shouldPutASubmachineIntoItsState() {
        String submachine = "<UML:SubmachineState xmi.id='u' name='U'><UML:SubmachineState.submachine>"
                + "<UML:StateMachine xmi.idref='n'/></UML:SubmachineState.submachine><UML:CompositeState.subvertex>"
                + "<UML:StubState xmi.id='stub' referenceState='Sub::In'/></UML:CompositeState.subvertex>"
                + "</UML:SubmachineState>" + TRANSITIONS + "<UML:Transition xmi.id='t' source='u' target='stub'/>";

        String document = document(machine("m", submachine) + machine("n", "<UML:SimpleState xmi.id='in' name='In'/>"));

        assertThat(ChartText.of(document)).containsExactly("state u U", "  state u/in In", "u -> u/in");
        assertThat(ChartText.machines(document)).extracting(XmiMachine::name).containsExactly("m", "n");
    }

    @Test
    void shouldSayWhereEnterpriseArchitectKeepsItsStates() {
        String model = "<UML:ActivityModel xmi.id='e' name='ActivityModel'><UML:StateMachine.top>"
                + "<UML:CompositeState xmi.id='top'><UML:CompositeState.substate><UML:%s xmi.id='a' name='A'/>"
                + "</UML:CompositeState.substate></UML:CompositeState></UML:StateMachine.top></UML:ActivityModel>"
                + "<UML:StateMachine xmi.id='m' name='M'/>";

        assertThat(ChartText.refusal(document(model.formatted("SimpleState"))))
                .contains(
                        "stand in the ActivityModel 'ActivityModel' (id 'e'), which is not supported; export XMI 2.1");
        assertThat(ChartText.machines(document(model.formatted("SimpleState")))).hasSize(1);
        assertThat(ChartText.machines(document(model.formatted("ActionState"))))
                .extracting(XmiMachine::id)
                .containsExactly("m");
    }

    @Test
    void shouldLeaveActivityGraphsOut() {
        assertThat(ChartText.machines(document("<UML:ActivityGraph xmi.id='g' name='G'>"
                        + machine("m", "<UML:SimpleState xmi.id='a' name='A'/>") + "</UML:ActivityGraph>")))
                .isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<UML:SimpleState xmi.id='a' name='A'/><UML:SimpleState xmi.id='a' name='B'/> | SimpleState 'B' (id 'a') has the id of another vertex",
                "<UML:SynchState xmi.id='a' name='A'/>        | SynchState 'A' (id 'a') is not supported; draw states",
                "<UML:Pseudostate xmi.id='a' kind='odd'/>     | pseudostate '' (id 'a') is of the unknown kind 'odd'",
                "<UML:SimpleState xmi.id='a' name='A'><UML:State.odd/></UML:SimpleState> | element State.odd of SimpleState 'A' (id 'a') is not supported; remove it",
                "<UML:SimpleState xmi.id='a' name='A' odd='1'/> | attribute odd of SimpleState 'A' (id 'a') is not supported; remove it",
                "<UML:SubmachineState xmi.id='a' name='A' submachine='m'/> | holds state machine 'm' (id 'm'), which contains this state; break the cycle",
                "<UML:SubmachineState xmi.id='a' name='A' submachine='no'/> | submachine of SubmachineState 'A' (id 'a') refers to the unknown id 'no'",
                "<UML:CompositeState xmi.id='a' name='A' isConcurrent='true'><UML:CompositeState.subvertex><UML:SimpleState xmi.id='b' name='B'/></UML:CompositeState.subvertex></UML:CompositeState>"
                        + " | SimpleState 'B' (id 'b') stands directly in the concurrent state 'A' (id 'a')",
            })
    void shouldRefuseAVertex(String vertex, String problem) {
        assertThat(ChartText.refusal(document(machine("m", vertex))))
                .contains("line " + FIRST_LINE + ": ")
                .contains(problem);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<UML:Transition.trigger><UML:Event xmi.idref='no'/></UML:Transition.trigger> | trigger of Transition '' (id 't') refers to the unknown id 'no'",
                "<UML:Transition.trigger>go</UML:Transition.trigger> | text 'go' in Transition.trigger of Transition '' (id 't') is not supported",
                "go                                                | text 'go' of Transition '' (id 't') is not supported; remove it",
                "<UML:ModelElement.name>go</UML:ModelElement.name> | transition 'go' (id 't') has no trigger, so that it is taken as soon as state",
                "<UML:Transition.trigger><UML:Event href='x.xmi'/></UML:Transition.trigger> | refers to another file, 'x.xmi'; put the element into this model",
                "<UML:Transition.trigger><UML:Event xmi.id='e'/></UML:Transition.trigger> | the Event '' (id 'e') that triggers Transition '' (id 't') has no name; give it one",
                "<UML:Transition.target><UML:SimpleState xmi.idref='a'/></UML:Transition.target> | transition '' (id 't') has more than one target",
                "<UML:Transition.odd/> | element Transition.odd of Transition '' (id 't') is not supported",
            })
    void shouldRefuseATransition(String content, String problem) {
        assertThat(ChartText.refusal(transition(content)))
                .contains("line " + FIRST_LINE + ": ")
                .contains(problem);
    }
}
