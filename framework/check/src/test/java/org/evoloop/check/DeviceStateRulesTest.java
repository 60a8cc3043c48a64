package org.evoloop.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

/** What the rules say about new states that use the device: a kettle that gets the state Tea. */
class DeviceStateRulesTest {
    private static final List<String> KETTLE = List.of(
            "Off power -> Heating",
            "Heating power -> Off",
            "Heating hot -> Ready",
            "Ready power -> Off",
            "Ready cold -> Heating",
            "Ready brew -> Brewing",
            "Brewing power -> Off");

    private static StateMachine kettle(String name, String... more) {
        return machine(name, Stream.concat(KETTLE.stream(), Stream.of(more)).toArray(String[]::new));
    }

    private static List<Finding> check(StateMachine evolved) {
        return Check.run(
                CheckInput.of(new ModelPair(kettle("original"), evolved)).withOwnEvents(Set.of("hot", "cold")));
    }

    private static List<String> texts(StateMachine evolved) {
        return check(evolved).stream().map(Finding::toString).toList();
    }

    @Test
    void theRemedyNamesTheDeviceStateInWhichTheNewStateWouldHaveToWait() {
        assertThat(texts(kettle("new", "Off tea -> Tea", "Tea power -> Off", "Tea hot -> Brewing")))
                .singleElement()
                .asString()
                .startsWith("no-path: in (Off, Tea) event hot leads to Brewing")
                .endsWith("; give Tea the device state Heating");
        assertThat(texts(kettle("new", "Off tea -> Brewing")))
                .singleElement()
                .asString()
                .startsWith("no-path: in (Off, Off) event tea leads to Brewing")
                .endsWith("; draw a new state with device state Heating and a transition on hot");
    }

    @Test
    void oneDeviceStateThatDoesNotExistIsReportedOnce() {
        StateMachine evolved =
                kettle("new", "Off tea -> Tea", "Tea power -> Off", "Tea more -> Pot", "Pot power -> Off");
        for (State state : List.of(new State("Tea"), new State("Pot"))) {
            evolved = evolved.withDeviceState(state, "heating");
        }

        assertThat(texts(evolved))
                .containsExactly("device-state: the device state of Tea, heating, is not a state of the original model;"
                        + " did you mean Heating?");
    }

    @Test
    void whatTheDeviceDoesByItselfIsCompared() {
        StateMachine evolved = kettle(
                        "new",
                        "Ready tea -> Tea",
                        "Tea power -> Off",
                        "Tea brew -> Brewing",
                        "Tea tm(5min) -> Off",
                        "Tea tm(9min) -> Heating")
                .withDeviceState(new State("Tea"), "Ready");

        assertThat(texts(evolved))
                .anyMatch(text -> text.startsWith("device-leaves: in Tea the device can leave Ready by cold, for which"
                        + " the new model draws nothing there; it follows the device to Heating"))
                .filteredOn(text -> text.startsWith("timer-or-device"))
                .containsExactly("timer-or-device: in Tea, tm(5min) leads to Off, but cold, which the device raises in"
                        + " Ready by itself, leads to Heating; whichever comes first decides; nothing, if cold takes"
                        + " longer than that, or both are right");
    }

    @Test
    void aDeclaredSendHasToBePossible() {
        StateMachine evolved = kettle(
                        "new", "Ready tea -> Tea", "Tea power -> Off", "Tea brew -> Brewing", "Tea cold -> Off")
                .withDeviceState(new State("Tea"), "Ready")
                .withSends(new State("Tea"), new Event("brew"))
                .withSends(new State("Tea"), new Event("hot"))
                .withSends(new State("Tea"), new Event("powr"));

        assertThat(texts(evolved))
                .containsExactly(
                        "declared-send: the function of Tea sends brew, which takes the device out of its device state"
                                + " to Brewing; draw another new state with the device state Brewing",
                        "declared-send: the function of Tea sends hot, which cannot be sent; remove it, or let the"
                                + " converter send it",
                        "declared-send: the function of Tea sends powr, which cannot be sent; did you mean power?");
    }

    @Test
    void aCircleThatSendsWithoutAnEndIsShown() {
        List<Finding> findings =
                check(kettle("new", "Ready tm(0s) -> Brewing", "Brewing tm(0s) -> Off", "Off tm(0s) -> Heating"));
        assertThat(findings).noneMatch(finding -> finding.rule() == Rule.RESTLESS);

        findings = check(kettle("new", "Off tm(0s) -> Heating", "Heating tm(0s) -> Off"));
        assertThat(findings)
                .filteredOn(finding -> finding.rule() == Rule.RESTLESS)
                .singleElement()
                .satisfies(finding -> {
                    assertThat(finding.message())
                            .isEqualTo("from (Off, Off) timers of no length lead back there, and power, power is sent"
                                    + " again and again, without an end");
                    assertThat(finding.example()).hasSize(2);
                });
    }
}
