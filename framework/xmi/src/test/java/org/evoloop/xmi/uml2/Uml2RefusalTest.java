package org.evoloop.xmi.uml2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.xmi.uml2.Uml2Text.machine;
import static org.evoloop.xmi.uml2.Uml2Text.transition;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.evoloop.xmi.ChartText;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Elements that do not belong in a chart are named, with the line and a remedy. */
class Uml2RefusalTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<subvertex xmi:type='uml:State' name='A'/> | State 'A' (id '') has no id; export the model again with ids",
                "<subvertex xmi:type='uml:State' xmi:id='a' name='A'/><subvertex xmi:type='uml:State' xmi:id='a' name='B'/>"
                        + " | State 'B' (id 'a') has the id of another vertex; give each an id of its own",
                "<subvertex xmi:type='uml:Pseudostate' xmi:id='a' kind='odd'/> | pseudostate '' (id 'a') is of the unknown kind 'odd'",
                "<subvertex xmi:type='uml:Odd' xmi:id='a' name='A'/> | vertex 'A' (id 'a') is of type 'Odd', which is not supported",
                "<subvertex xmi:type='uml:State' xmi:id='a' name='A'><extension xmi:id='i'/></subvertex>"
                        + " | element extension (id 'i') of State 'A' (id 'a') is not supported; remove it",
                "<subvertex xmi:type='uml:State' xmi:id='a' name='A'>warm</subvertex>"
                        + " | text 'warm' of State 'A' (id 'a') is not supported; remove it",
                "<subvertex xmi:type='uml:State' xmi:id='a' name='A' redefinedState='b'/>"
                        + " | attribute redefinedState of State 'A' (id 'a') is not supported; remove it",
                "<subvertex xmi:type='uml:State' xmi:id='a' name='A' submachine='m'/>"
                        + " | submachine state 'A' (id 'a') holds state machine 'M' (id 'm'), which contains this state; break the cycle",
                "<subvertex xmi:type='uml:State' xmi:id='a' name='A' submachine='no'/>"
                        + " | submachine of State 'A' (id 'a') refers to the unknown id 'no'",
                "<subvertex xmi:type='uml:State' xmi:id='a' name='A'><submachine href='other.uml#s'/></subvertex>"
                        + " | refers to another file, 'other.uml#s': other.uml: is not found from F.xml; put that file",
                "<subvertex xmi:type='uml:State' xmi:id='a' name='A'><submachine href='http://x.y/z.uml#s'/></subvertex>"
                        + " | refers to another file, 'http://x.y/z.uml#s': http:/x.y/z.uml: is not found",
                "<subvertex xmi:type='uml:State' xmi:id='a' name='A'><connection xmi:id='c' entry='a'/></subvertex>"
                        + " | connection point reference '' (id 'c') of state 'A' (id 'a') does not refer to one entry or exit point",
            })
    void shouldRefuseAVertex(String vertex, String problem) {
        assertThat(ChartText.refusal(machine(vertex)))
                .contains("line " + Uml2Text.FIRST_LINE + ": ")
                .contains(problem);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''             | <trigger xmi:id='x'/>           | trigger '' (id 'x') of Transition '' (id 't') names no event; give it an event or a name",
                "''             | <trigger xmi:id='x' event='no'/>| event of Trigger '' (id 'x') refers to the unknown id 'no'",
                "''             | <trigger xmi:id='x' event='any'/>| trigger '' (id 'x') receives any event, which is not supported; name the events",
                "''             | <guard xmi:id='g1' name='x'/><guard xmi:id='g2' name='y'/> | transition '' (id 't') has 2 guards; join them into one",
                "''             | <guard xmi:id='g'><specification xmi:type='uml:InstanceValue' xmi:id='v'/></guard> | value of type InstanceValue",
                "''             | <trigger xmi:id='x'>clean</trigger> | text 'clean' of Trigger '' (id 'x') is not supported; remove it",
                "''             | <trigger>clean</trigger>        | trigger of Transition '' (id 't') refers to the unknown id 'clean'",
                "name='clean'   | ''                              | transition 'clean' (id 't') has no trigger, so that it is taken as soon as state 'A' (id 'a')"
                        + " is done, and its name is not an event; give it a trigger with the event 'clean', or remove the name",
                "''             | <effect xmi:type='uml:Activity' xmi:id='f'><node xmi:id='n'/></effect> | effect of Transition '' (id 't') is a Activity (id 'f') without a name; give it one",
                "''             | <postCondition xmi:id='p'/>     | element postCondition (id 'p') of Transition",
                "''             | <target xmi:idref='a'/>         | transition '' (id 't') has more than one target; draw it",
                "kind='odd'     | ''                              | transition '' (id 't') is of the unknown kind 'odd'; use internal",
                "kind='internal'| ''                              | internal transition '' (id 't') leads to another state",
                "redefinedTransition='t0' | ''                    | attribute redefinedTransition of Transition '' (id 't') is not supported",
            })
    void shouldRefuseATransition(String attributes, String content, String problem) {
        assertThat(ChartText.refusal(transition(
                        attributes,
                        content,
                        "<packagedElement xmi:type='uml:AnyReceiveEvent' xmi:id='any' name='AnyReceiveEvent1'/>")))
                .contains("line " + (Uml2Text.FIRST_LINE + 4) + ": ")
                .contains(problem);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "target='no'  | target of Transition '' (id 't') refers to the unknown id 'no'; export the model again",
                "target='m'   | the target of transition '' (id 't') is not a vertex of this state machine but the StateMachine 'M' (id 'm')",
                "''           | transition '' (id 't') has no target; draw it from one state to one state",
            })
    void shouldRefuseATransitionToNowhere(String target, String problem) {
        assertThat(ChartText.refusal(machine("<subvertex xmi:type='uml:State' xmi:id='a' name='A'/>"
                        + "<transition xmi:id='t' source='a' " + target + "/>")))
                .contains(problem);
    }

    @Test
    void shouldRefuseAReferenceToAnIdThatTwoElementsHave() {
        assertThat(ChartText.refusal(transition(
                        "",
                        "<trigger xmi:id='x' event='e'/>",
                        "<packagedElement xmi:type='uml:SignalEvent' xmi:id='e' name='one'/>",
                        "<packagedElement xmi:type='uml:SignalEvent' xmi:id='e' name='two'/>")))
                .contains("refers to the id 'e', which several elements have; give each an id of its own");
    }

    @Test
    void shouldRefuseMachinesThatGrowBeyondAnyMeasure() {
        // Each of 40 machines contains the next one twice: 2 to the power of 40 states.
        String machines = IntStream.range(0, 40)
                .mapToObj(i -> "<packagedElement xmi:type='uml:StateMachine' xmi:id='m" + i + "' name='M" + i
                        + "'><region><subvertex xmi:type='uml:State' xmi:id='a" + i + "' name='A' submachine='m"
                        + (i + 1) + "'/><subvertex xmi:type='uml:State' xmi:id='b" + i + "' name='B' submachine='m"
                        + (i + 1) + "'/></region></packagedElement>")
                .collect(Collectors.joining("\n"));

        assertThat(ChartText.refusal(
                        Uml2Text.model(machines, "<packagedElement xmi:type='uml:StateMachine' xmi:id='m40'/>")))
                .contains("is too large: use fewer of them");
    }
}
