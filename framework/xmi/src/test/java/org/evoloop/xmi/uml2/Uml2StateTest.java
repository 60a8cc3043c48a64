package org.evoloop.xmi.uml2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.xmi.uml2.Uml2Text.machine;
import static org.evoloop.xmi.uml2.Uml2Text.model;
import static org.evoloop.xmi.uml2.Uml2Text.state;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** States and their contents. */
class Uml2StateTest {
    private static final String SUBMACHINE = """
            <packagedElement xmi:type='uml:StateMachine' xmi:id='sub' name='Sub'>
              <connectionPoint xmi:type='uml:Pseudostate' xmi:id='in' name='IN' kind='entryPoint'/>
              <region xmi:id='rs'>
                <subvertex xmi:type='uml:State' xmi:id='s' name='S'/>
                <subvertex xmi:type='uml:Pseudostate' xmi:id='out' name='OUT' kind='exitPoint'/>
                <transition xmi:id='ts' source='in' target='s'/>
                <transition xmi:id='tx' source='s' target='out'/>
              </region>
            </packagedElement>""";

    @Test
    void shouldReadBehaviorsAndDeferredTriggers() {
        assertThat(ChartText.of(machine("""
                        <subvertex xmi:type='uml:State' xmi:id='a' name='A'>
                          <entry xmi:type='uml:OpaqueBehavior' name='in1'/><entry xmi:type='uml:OpaqueBehavior' name='in2'/>
                          <exit xmi:type='uml:Activity' name='out'/>
                          <doActivity xmi:type='uml:Activity' name='work'><node xmi:id='n'/></doActivity>
                          <deferrableTrigger xmi:id='d' name='later'/>
                          <incoming xmi:idref='unknown'/>
                          <ownedComment xmi:id='c' body='a note'/>
                        </subvertex>""")))
                .containsExactly("state a A entry[in1, in2] exit[out] do[work] defer[later]");
    }

    @Test
    void shouldReadRegionsAndEveryKindOfPseudostate() {
        String vertex = "<subvertex xmi:type='uml:Pseudostate' xmi:id='%s' kind='%s'/>";

        assertThat(ChartText.of(machine("<subvertex xmi:type='uml:State' xmi:id='a' name='A'>"
                        + "<connectionPoint xmi:id='p' name='P' kind='entryPoint'/>"
                        + "<region name='left'>" + state("l", "L") + vertex.formatted("x", "exitPoint") + "</region>"
                        + "<region name='right'><subvertex xmi:type='uml:FinalState' xmi:id='f'/></region></subvertex>"
                        + vertex.formatted("1", "initial")
                        + vertex.formatted("2", "shallowHistory")
                        + vertex.formatted("3", "deepHistory")
                        + vertex.formatted("4", "join")
                        + vertex.formatted("5", "fork")
                        + vertex.formatted("6", "junction")
                        + vertex.formatted("7", "choice")
                        + vertex.formatted("8", "terminate"))))
                .containsExactly(
                        "state a A",
                        "  ENTRY_POINT p P",
                        "  EXIT_POINT x",
                        "  region left",
                        "  state l L",
                        "  region right",
                        "  FINAL f",
                        "INITIAL 1",
                        "SHALLOW_HISTORY 2",
                        "DEEP_HISTORY 3",
                        "JOIN 4",
                        "FORK 5",
                        "JUNCTION 6",
                        "CHOICE 7",
                        "TERMINATE 8");
    }

    @Test
    void shouldPutASubmachineInThePlaceOfEachStateThatHoldsIt() {
        String holder = "<subvertex xmi:type='uml:State' xmi:id='%s' name='%s' submachine='sub'>"
                + "<connection xmi:type='uml:ConnectionPointReference' xmi:id='in%s' entry='in'/>"
                + "<connection xmi:id='out%s'><exit xmi:idref='out'/></connection></subvertex>";

        assertThat(ChartText.of(machine(
                        holder.formatted("a", "A", "A", "A") + holder.formatted("b", "B", "B", "B")
                                + "<transition xmi:id='t' source='outA' target='inB'/>",
                        SUBMACHINE)))
                .containsExactly(
                        "state a A",
                        "  ENTRY_POINT a/in IN",
                        "  EXIT_POINT a/out OUT",
                        "  state a/s S",
                        "  a/in -> a/s",
                        "  a/s -> a/out",
                        "state b B",
                        "  ENTRY_POINT b/in IN",
                        "  EXIT_POINT b/out OUT",
                        "  state b/s S",
                        "  b/in -> b/s",
                        "  b/s -> b/out",
                        "a/out -> b/in");
    }

    @Test
    void shouldFollowATransitionToAPointOfTheSubmachineItself() {
        assertThat(ChartText.of(machine(
                        "<subvertex xmi:type='uml:State' xmi:id='a' name='A' submachine='sub'/>" + state("b", "B")
                                + "<transition xmi:id='t' source='b' target='in'/>",
                        SUBMACHINE)))
                .endsWith("state b B", "b -> a/in");
    }

    @Test
    void shouldReadASubmachineOfAnotherFile(@TempDir Path directory) throws IOException {
        Files.createDirectories(directory.resolve("my parts"));
        Files.writeString(directory.resolve("my parts/sub.uml"), model(SUBMACHINE));
        Path file = Files.writeString(
                directory.resolve("main.uml"),
                machine("<subvertex xmi:type='uml:State' xmi:id='a' name='A'>"
                        + "<submachine xmi:type='uml:StateMachine' href='my%20parts/sub.uml#sub'/></subvertex>"));

        assertThat(ChartText.of(ModelFile.read(file).machines().get(0).statechart()))
                .contains("state a A", "  state a/s S");
    }

    @Test
    void shouldFindMachinesWhereverTheyStand() {
        String machine = "xmi:type='uml:StateMachine' xmi:id='%s' name='%s'";
        String document = model(
                "<packagedElement xmi:type='uml:Package' xmi:id='p'><packagedElement "
                        + machine.formatted("1", "InPackage") + "/></packagedElement>",
                "<packagedElement xmi:type='uml:Class' xmi:id='c' classifierBehavior='2'><ownedBehavior "
                        + machine.formatted("2", "Behavior") + "><nestedClassifier " + machine.formatted("3", "Nested")
                        + "/></ownedBehavior></packagedElement>",
                "<packagedElement xmi:type='uml:ProtocolStateMachine' xmi:id='4' name='Protocol'/>",
                "<packagedElement xmi:type='uml:Activity' xmi:id='5' name='NoMachine'/>");

        assertThat(ChartText.machines(document))
                .extracting(XmiMachine::name)
                .containsExactly("InPackage", "Behavior", "Nested", "Protocol");
    }

    @Test
    void shouldReadAProtocol() {
        assertThat(ChartText.of(model("""
                        <packagedElement xmi:type='uml:ProtocolStateMachine' xmi:id='m' name='M'><region>
                        <subvertex xmi:type='uml:State' xmi:id='a' name='A'/>
                        <transition xmi:type='uml:ProtocolTransition' xmi:id='t' source='a' target='a'>
                        <trigger xmi:id='tr' name='e'/>
                        <preCondition xmi:type='uml:Constraint' xmi:id='p'>
                        <specification xmi:type='uml:LiteralString' value='ready'/></preCondition>
                        </transition></region></packagedElement>"""))).contains("a -> a : e [ready]");
    }

    @Test
    void shouldReadWhatMagicDrawPutsBetweenAndAround() {
        String document = machine("<subvertex xmi:type='uml:State' xmi:id='a' name='A'>"
                        + "<xmi:Extension extender='MagicDraw UML'><modelExtension><x xmi:id='a'/></modelExtension>"
                        + "</xmi:Extension></subvertex>")
                .replace(
                        "<uml:Model",
                        "<xmi:XMI xmlns:xmi='http://www.omg.org/spec/XMI/20131001'"
                                + " xmlns:P='http://www.magicdraw.com/schemas/P.xmi'><xmi:Documentation exporter='MagicDraw'/>"
                                + "<xmi:Extension extender='MagicDraw'><mdElement xmi:type='uml:StateMachine' xmi:id='no'/>"
                                + "</xmi:Extension><uml:Model")
                .replace("</uml:Model>", "</uml:Model><P:Fast xmi:id='st' base_State='a'/></xmi:XMI>");

        assertThat(ChartText.machines(document)).hasSize(1);
        assertThat(ChartText.of(document)).containsExactly("state a A");
    }
}
