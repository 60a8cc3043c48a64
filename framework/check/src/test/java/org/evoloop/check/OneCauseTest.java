package org.evoloop.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

/** A mistake is reported once, whatever follows from it. */
class OneCauseTest {
    private static List<Finding> check(StateMachine original, StateMachine evolved) {
        return Check.run(CheckInput.of(new ModelPair(original, evolved)));
    }

    private static String[] with(String[] lines, String... more) {
        return Stream.of(lines, more).flatMap(Stream::of).toArray(String[]::new);
    }

    @Test
    void statesThatOnlyAnUnreachableStateLeadsToAreReportedWithIt() {
        String[] lamp = {"Off press -> On", "On press -> Off"};
        String[] lost = {"C up -> D", "A up -> B", "B up -> C", "D up -> B", "E up -> A"};

        assertThat(check(machine("original", lamp), machine("new", with(lamp, lost))))
                .extracting(Finding::toString)
                .containsExactly(
                        "unreachable-state: no sequence of events leads to state E of the new model, nor to A, B,"
                                + " C, D that it leads to; draw a transition that leads there, or remove it");
    }

    @Test
    void whatTheNewModelHasTakenOverIsReportedOnce() {
        String[] device = {
            "Off press -> On",
            "On press -> Off",
            "On press [hot] -> On",
            "Lost press -> Off",
            "On dim -> Dead",
            "On tm_3s -> Off",
            "Off tm_3s -> On"
        };

        assertThat(check(machine("original", device), machine("new", device)))
                .allSatisfy(finding -> assertThat(finding.element().side()).isEqualTo(Element.ModelRole.ORIGINAL))
                .extracting(Finding::rule)
                .containsExactly(Rule.UNREACHABLE_STATE, Rule.DEAD_TRANSITION, Rule.TRAP_STATE, Rule.TIMER_CANNOT_FIRE);
    }

    @Test
    void aStateThatTheNewModelNeverEntersIsNotReportedAgainForItsTransitions() {
        StateMachine device = machine(
                "original",
                "On go -> Clean",
                "Clean stop -> On",
                "Clean go -> Deep",
                "Deep stop -> On",
                "Deep go -> Clean");
        StateMachine system = machine(
                "new",
                "On go -> Wait",
                "Wait go -> On",
                "Wait stop -> On",
                "Clean stop -> On",
                "Clean go -> Deep",
                "Deep stop -> On",
                "Deep go -> Clean");

        assertThat(check(device, system))
                .extracting(Finding::toString)
                .singleElement()
                .asString()
                .startsWith(
                        "unreachable-state: no sequence of events leads to state Clean of the new model, nor to Deep");
    }

    /** Every path begins with it. */
    @Test
    void anEventThatCannotBeSentIsOneCauseHoweverManyStatesItKeepsAway() {
        String[] device = {"Off wake -> A", "A one -> B", "B two -> C", "C three -> D", "D off -> Off"};
        String[] menu = {
            "Off menu -> Menu", "Menu a -> A", "Menu b -> B", "Menu c -> C", "Menu d -> D", "Menu wake -> Menu"
        };
        CheckInput input = CheckInput.of(new ModelPair(machine("original", device), machine("new", with(device, menu))))
                .withOwnEvents(Set.of("wake"));

        assertThat(Check.run(input))
                .filteredOn(finding -> finding.rule().severity() == Rule.Severity.ERROR)
                .singleElement()
                .satisfies(finding -> {
                    assertThat(finding.rule()).isEqualTo(Rule.NO_PATH);
                    assertThat(finding.remedy())
                            .isEqualTo("draw a new state with device state Off and a transition on wake");
                    assertThat(finding.message()).contains("the same holds for b in (Off, Menu), c in (Off, Menu)");
                });
    }

    /** S2 could not be reached before, S1 could. */
    @Test
    void aStateBehindOneThatWasUnreachableBeforeIsReported() {
        StateMachine device = machine("original", "S0 a -> S1", "S1 b -> S0", "S2 c -> S1", "S3 c -> S2");
        StateMachine system = machine("new", "S0 a -> N", "N b -> S0", "S1 b -> S0", "S2 c -> S1", "S3 c -> S2");

        assertThat(check(device, system))
                .filteredOn(finding -> finding.rule() == Rule.UNREACHABLE_STATE)
                .extracting(Finding::message)
                .containsExactly(
                        "no sequence of events leads to state S3 of the original model, nor to S2 that it leads to",
                        "no sequence of events leads to state S1 of the new model");
    }

    /** In N, a could come only where the device cannot be, and what it should lead to cannot be reached. */
    @Test
    void aTransitionThatLacksAPathIsNotCalledDeadToo() {
        StateMachine device = machine("original", "S0 y -> S1", "S1 z -> S0", "S1 a -> S1");
        StateMachine system =
                machine("new", "S0 y -> S1", "S0 z -> N", "S1 z -> S0", "S1 a -> S1", "S1 x -> M", "N a -> S1");
        CheckInput input = CheckInput.of(new ModelPair(device, system))
                .withDevice(new DeviceEvents(Set.of(new Event("z")), Set.of(new Event("a"))));

        assertThat(Check.run(input))
                .filteredOn(finding -> finding.element().part().toString().equals("N --a--> S1"))
                .singleElement()
                .satisfies(finding -> {
                    assertThat(finding.rule()).isEqualTo(Rule.NO_PATH);
                    assertThat(finding.message()).endsWith("; so the new model never reaches S1, M");
                });
    }

    @Test
    void aDeadTransitionIsReportedWithAllThatIsLostWithIt() {
        StateMachine device = machine("original", "Off go -> On", "On go -> Off", "On end -> Off");
        StateMachine system = machine(
                "new", "Off go -> On", "On go -> Off", "On end -> Off", "Off end -> A", "A go -> B", "B go -> Off");
        CheckInput input = CheckInput.of(new ModelPair(device, system)).withOwnEvents(Set.of("end"));

        assertThat(Check.run(input))
                .filteredOn(
                        finding -> finding.rule() == Rule.DEAD_TRANSITION || finding.rule() == Rule.UNREACHABLE_STATE)
                .singleElement()
                .extracting(Finding::message)
                .asString()
                .contains("Off --end--> A of the new model is never taken", "; so the new model never reaches A, B");
    }

    @Test
    void whatWasMeantAsATimeTriggerIsNotAlsoAnEventThatIsNeverRaised() {
        StateMachine device = machine("original", "Off press -> On", "On press -> Off");
        StateMachine system = machine("new", "Off press -> On", "On press -> Off", "On tm_3s -> Off");

        assertThat(Check.run(CheckInput.of(new ModelPair(device, system)).withRaised(Set.of("press"))))
                .extracting(Finding::rule)
                .containsExactly(Rule.TIMER_CANNOT_FIRE);
    }
}
