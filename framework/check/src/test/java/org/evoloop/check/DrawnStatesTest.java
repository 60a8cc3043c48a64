package org.evoloop.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ChartText;
import org.junit.jupiter.api.Test;

/** Which states belong to the device if they are drawn inside others, beside others, or as final states. */
class DrawnStatesTest {
    private static final String POWER = """
            <state id="Power"><initial><transition target="Off"/></initial>
              <state id="Off"><transition event="press" target="On"/></state>
              <state id="On"><transition event="press" target="Off"/></state>
            </state>
            """;
    private static final StateMachine DEVICE = scxml("Power", POWER);

    private static StateMachine scxml(String initial, String states) {
        return ChartText.machines("<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0' initial='" + initial
                        + "'>" + states + "</scxml>")
                .get(0)
                .toStateMachine();
    }

    private static List<Finding> check(StateMachine evolved) {
        return Check.run(CheckInput.of(new ModelPair(DEVICE, evolved)));
    }

    /** UML allows equal names for states in different places; SCXML does not, so one is renamed here. */
    private static StateMachine withASecondOn() {
        StateMachine drawn = scxml(
                "Power",
                POWER.replace("<state id=\"Off\">", "<state id=\"Off\"><transition event=\"test\" target=\"Test\"/>")
                        + """
                        <state id="Test"><initial><transition target="In"/></initial>
                          <state id="In"><transition event="press" target="Off"/></state></state>
                        """);
        StateMachine renamed =
                drawn.withStateNames(java.util.Map.of(new State("In"), "Test.On", new State("On"), "Power.On"));
        assertThat(renamed.paths(new State("Power.On"))).containsExactly("Power.On");
        return renamed;
    }

    @Test
    void aStateIsTheDevicesByItsPlaceWhereItsNameIsUsedAgain() {
        ModelPair pair = new ModelPair(DEVICE, withASecondOn());

        assertThat(pair.violations()).isEmpty();
        assertThat(pair.evolved().states()).extracting(State::name).containsExactly("Off", "On", "Test.On");
        assertThat(pair.isNew(new State("On"))).isFalse();
        assertThat(pair.isNew(new State("Test.On"))).isTrue();
        assertThat(Check.run(CheckInput.of(pair))).isEmpty();
    }

    /** The new model's {@code On} is a different state; the device's is found by its path. */
    @Test
    void aNameThatTheNewModelNeedsForAnotherStateIsLeftToIt() {
        StateMachine evolved = scxml(
                "Power",
                POWER.replace("<state id=\"Off\">", "<state id=\"Off\"><transition event=\"test\" target=\"Other\"/>")
                        + "<state id=\"Other\"><transition event=\"press\" target=\"Off\"/></state>");
        ModelPair pair = new ModelPair(
                DEVICE,
                evolved.withStateNames(java.util.Map.of(new State("On"), "Power.On", new State("Other"), "On")));

        assertThat(pair.violations()).isEmpty();
        assertThat(pair.original().states()).extracting(State::name).containsExactly("Off", "Power.On");
        assertThat(pair.isNew(new State("On"))).isTrue();
    }

    @Test
    void aRegionBesideTheDevicesStatesIsReportedAsSuchOnce() {
        StateMachine evolved = scxml("P", "<parallel id=\"P\">" + POWER + """
                        <state id="Lamp"><initial><transition target="Dark"/></initial>
                          <state id="Dark"><transition event="light" target="Lit"/></state>
                          <state id="Lit"><transition event="light" target="Dark"/></state>
                        </state></parallel>
                        """);

        assertThat(check(evolved))
                .extracting(Finding::toString)
                .singleElement()
                .asString()
                .startsWith(
                        "condition-2: states Off, On of the original model stand beside another region in the new model:"
                                + " (Off, Dark), (Off, Lit), (On, Dark), (On, Lit); draw what is new as states of its own");
        assertThatThrownBy(() -> new ModelPair(DEVICE, evolved).requireValid())
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("state On of the original model stands beside another region in the new model");
    }

    @Test
    void aStateThatIsDividedOrSpeltDifferentlyIsReportedAsSuch() {
        String divided = POWER.replace(
                "<state id=\"On\">",
                "<state id=\"On\"><initial><transition target=\"Dim\"/></initial>"
                        + "<state id=\"Dim\"><transition event=\"more\" target=\"Full\"/></state><state id=\"Full\"/>");
        assertThat(check(scxml("Power", divided)))
                .extracting(Finding::toString)
                .anySatisfy(found -> assertThat(found)
                        .startsWith(
                                "condition-2: state On of the original model has states inside in the new model: Dim,"
                                        + " Full; leave it without states inside"));
        assertThat(check(scxml("Power", POWER.replace("\"Off\"", "\"OFF\""))))
                .extracting(Finding::toString)
                .containsExactly(
                        "condition-2: state Off of the original model is missing in the new model, which has OFF;"
                                + " write it as in the original model, capital letters and spaces included");
    }

    @Test
    void anEndIsNoTrap() {
        StateMachine evolved = scxml(
                "Power",
                POWER.replace("<state id=\"Off\">", "<state id=\"Off\"><transition event=\"unplug\" target=\"End\"/>")
                        + "<final id=\"End\"/>");

        assertThat(evolved.isEnd(new State("End"))).isTrue();
        assertThat(check(evolved)).isEmpty();
    }
}
