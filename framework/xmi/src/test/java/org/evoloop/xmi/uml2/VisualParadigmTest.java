package org.evoloop.xmi.uml2;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.XmiMachine;
import org.junit.jupiter.api.Test;

/** Files in which states and transitions are directly in the package. */
class VisualParadigmTest {
    private static String document(String... members) {
        return """
                <xmi:XMI xmi:version="2.1" xmlns:uml="http://schema.omg.org/spec/UML/2.0"
                    xmlns:xmi="http://schema.omg.org/spec/XMI/2.1">
                  <xmi:Documentation exporter="Visual Paradigm" exporterVersion="7.0.2"/>
                  <uml:Model name="lamp" xmi:id="model">%s</uml:Model>
                  <uml:Diagram diagramType="StateDiagram" name="d" xmi:id="d"/>
                </xmi:XMI>
                """.formatted(String.join("\n", members));
    }

    private static String member(String type, String attributes, String content) {
        return "<ownedMember xmi:type='uml:" + type + "' " + attributes + ">" + content + "</ownedMember>";
    }

    private static final String[] LAMP = {
        member("Pseudostate", "xmi:id='i' kind='initial' name=''", ""),
        member(
                "State",
                "xmi:id='a' name='Lit'",
                member("Pseudostate", "xmi:id='j' kind='initial'", "")
                        + member("State", "xmi:id='b' name='Bright'", "")
                        + member("Transition", "xmi:id='t0' source='j' target='b'", "")),
        member("Pseudostate", "xmi:id='f' kind='final' name='End'", ""),
        member("Transition", "xmi:id='t1' source='i' target='a'", ""),
        member(
                "Transition",
                "xmi:id='t2' source='b' target='f' guard='g' kind='external'",
                "<trigger xmi:type='uml:Trigger' xmi:id='x' name='press'/>"
                        + "<guard xmi:type='uml:Constraint' xmi:id='g'><specification xmi:type='uml:LiteralString'"
                        + " xmi:id='s' value='hot'/></guard>")
    };

    @Test
    void theVerticesOfAPackageAreAMachine() {
        List<XmiMachine> machines = ChartText.machines(document(LAMP));

        assertThat(machines).extracting(XmiMachine::name).containsExactly("lamp");
        assertThat(ChartText.of(machines.get(0).statechart()))
                .containsExactly(
                        "INITIAL i",
                        "state a Lit",
                        "  INITIAL j",
                        "  state b Bright",
                        "  j -> b",
                        "FINAL f End",
                        "i -> a",
                        "b -> f : press [hot]");
        assertThat(machines.get(0).toStateMachine().initial()).hasToString("Bright");
    }

    @Test
    void eachPackageIsAMachineOfItsOwnAndAnEmptyMachineGivesItsName() {
        String shell = member("StateMachine", "xmi:id='m' name='new'", "<region xmi:id='r'/>");
        String document = document(
                member("Package", "xmi:id='p' name='original'", String.join("", LAMP)),
                member(
                        "Package",
                        "xmi:id='q' name='Package2'",
                        shell + String.join("", LAMP).replaceAll("(xmi:id|source|target|guard)='", "$1='2")));

        List<XmiMachine> machines = ChartText.machines(document);

        assertThat(machines).extracting(XmiMachine::name).containsExactlyInAnyOrder("original", "new");
        machines.forEach(
                machine -> assertThat(machine.toStateMachine().states()).hasSize(2));
    }

    @Test
    void aGuardMayBeWrittenTwice() {
        String text = String.join("", LAMP).replace("guard='g'", "guard='hot'");

        assertThat(ChartText.of(document(text))).contains("b -> f : press [hot]");
    }
}
