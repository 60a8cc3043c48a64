package org.evoloop.models.temporal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PropertyCheckTest {
    private static final ModelPair ROBOT = cleaningRobot();

    private static ModelPair cleaningRobot() {
        ModelFile file = ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml"));
        return new ModelPair(file.pick("original"), file.pick("new"));
    }

    /** With functions that send nothing. */
    private static List<Finding> check(String text) {
        return PropertyCheck.run(
                CheckInput.of(ROBOT).withOwnEvents(Set.of("endSpot")),
                PropertyFile.parse("robot.properties.txt", text, ROBOT));
    }

    /** With functions that may send whatever can be sent. */
    private static List<String> judged(String... formulas) {
        return PropertyCheck.run(
                        CheckInput.of(ROBOT)
                                .withOwnEvents(Set.of("endSpot"))
                                .withSends("Move", "Clean")
                                .withSends("Move", "Spot")
                                .withSends("SpotWait", "Clean")
                                .withSends("SpotWait", "Spot"),
                        PropertyFile.parse("robot.properties.txt", String.join("\n", formulas), ROBOT))
                .stream()
                .map(Finding::message)
                .toList();
    }

    private static List<String> example(String formula) {
        assertThat(check(formula)).as(formula).hasSize(1);
        return check(formula).get(0).example().stream()
                .map(turn -> turn + " -> " + turn.decision().after())
                .toList();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "always Spot implies can On",
                "Move only after event Spot",
                "never (Move and not device On)",
                "always (function Move implies device On)",
                "always event timeout implies On",
                "not Spot unless (Move or SpotWait)",
                "always (Move implies next Spot)",
                "always (Spot implies eventually On)",
                "always can Clean",
                "On until true",
                "not eventually Spot",
                "can (SpotWait and device Clean)",
                "eventually On",
                "Off until On",
            })
    void holdsForTheCleaningRobot(String formula) {
        assertThat(check(formula)).isEmpty();
    }

    @Test
    void whatAFunctionMaySendIsNotProvedAndNotRefuted() {
        assertThat(judged(
                        "Still: always (function Move implies device On)",
                        "Busy: can (function Move and device Clean)",
                        "Waits: never (SpotWait and not device Clean)",
                        "Both: never (state Move and device Clean or state SpotWait and device On)"))
                .containsExactly(
                        "'Still' (robot.properties.txt, line 1) is unknown, since the function of Move may send events to "
                                + "the device; if nothing is sent, it holds",
                        "'Busy' (robot.properties.txt, line 2) is unknown, since the function of Move may send events to "
                                + "the device; if nothing is sent, it does not hold",
                        "'Waits' (robot.properties.txt, line 3) is unknown, since the function of SpotWait may send events "
                                + "to the device; if nothing is sent, it holds",
                        "'Both' (robot.properties.txt, line 4) is unknown, since the functions of Move, SpotWait may send "
                                + "events to the device; if nothing is sent, it holds");
    }

    @Test
    void whatHoldsOrFailsWhateverFunctionsSendIsJudgedAsBefore() {
        assertThat(judged(
                        "always can device On",
                        "always can (On and device On)",
                        "always (On implies device On)",
                        "Move only after event Spot",
                        "always (Spot implies eventually On)",
                        "can (function Move and device On)",
                        "can (SpotWait and device Clean)"))
                .isEmpty();
        assertThat(judged("Never: never function Move", "Clean: always (Clean implies device On)"))
                .containsExactly(
                        "'Never' (robot.properties.txt, line 1) does not hold",
                        "'Clean' (robot.properties.txt, line 2) does not hold");
    }

    @Test
    void whereThereIsTooMuchToExploreItIsUnknownToo() {
        StateMachineBuilder device = StateMachine.named("original").initial("S0");
        StateMachineBuilder system = StateMachine.named("new").initial("S0");
        for (int state = 0; state < 250; state++) {
            String next = "S" + (state + 1) % 250;
            device.transition("S" + state, "on", next);
            system.transition("S" + state, "on", next)
                    .transition("S" + state, "wait", "W" + state)
                    .transition("W" + state, "on", next);
        }
        ModelPair ring = new ModelPair(device.build(), system.build());
        PropertyFile file = PropertyFile.parse("ring.properties.txt", "Back: always can S0", ring);

        CheckInput all = CheckInput.of(ring);
        for (int state = 0; state < 250; state++) {
            all = all.withSends("W" + state, "on");
        }
        assertThat(PropertyCheck.run(all, file))
                .extracting(Finding::message)
                .containsExactly(
                        "'Back' (ring.properties.txt, line 1) is unknown, since the functions of W0, W1, W2, W3, W4 "
                                + "and 245 more may send events to the device, which is too much to explore; if nothing is sent, "
                                + "it holds");
        assertThat(PropertyCheck.run(CheckInput.of(ring).withSends("W7", "on"), file))
                .isEmpty();
    }

    @Test
    void onlyTheStatesThatSayWhatTheySendMaySend() {
        PropertyFile file = PropertyFile.parse(
                "robot.properties.txt",
                "Still: always (function Move implies device On)\nWaits: never (SpotWait and not device Clean)",
                ROBOT);
        CheckInput known = CheckInput.of(ROBOT).withOwnEvents(Set.of("endSpot")).withSends("Move", "Clean");
        assertThat(PropertyCheck.run(known, file)).singleElement().satisfies(finding -> {
            assertThat(finding.rule()).isEqualTo(Rule.UNKNOWN_PROPERTY);
            assertThat(finding.element()).hasToString("Move");
            assertThat(finding.example()).hasToString("[Clean, Spot]");
        });
    }

    @Test
    void showsTheShortestWayToWhereAnAlwaysIsBroken() {
        assertThat(example("never SpotWait"))
                .containsExactly("Clean -> (On, On)", "Clean -> (Clean, Clean)", "Clean -> (Clean, SpotWait)");
        assertThat(example("always (Spot implies can Off)"))
                .containsExactly("Clean -> (On, On)", "Spot -> (On, Move)", "arriveSpot -> (Spot, Spot)");
        assertThat(example("Spot only after Move")).endsWith("Clean -> (Clean, SpotWait)", "Clean -> (Spot, Spot)");
    }

    @Test
    void goesOnceAroundWhereWhatShouldComeNeedNot() {
        assertThat(example("eventually Move"))
                .containsExactly(
                        "Clean -> (On, On)",
                        "Clean -> (Clean, Clean)",
                        "Clean -> (Clean, SpotWait)",
                        "timeout -> (On, On)",
                        "Clean -> (Clean, Clean)");
        assertThat(example("(not Move) until Spot")).hasSizeGreaterThan(1);
    }

    @Test
    void aBrokenPropertyIsAFindingWithItsNameAndLine() {
        assertThat(check("# What the owner wants\n\nNo waiting:\n    never SpotWait\n"))
                .singleElement()
                .satisfies(finding -> {
                    assertThat(finding.rule()).isEqualTo(Rule.PROPERTY);
                    assertThat(finding.message())
                            .isEqualTo("'No waiting' (robot.properties.txt, line 3) does not hold");
                    assertThat(finding.element()).hasToString("SpotWait");
                });
    }

    @Test
    void namesLineAndRemedyOfEverythingThatCannotBeParsed() {
        assertThatThrownBy(() -> check("always Dance\nnever event Dance\nSpot Move\ncan (On\nOn only Move\nnot"))
                .isInstanceOf(ModelException.class)
                .satisfies(refusal -> assertThat(
                                String.valueOf(refusal.getMessage()).lines())
                        .hasSize(6)
                        .contains(
                                "robot.properties.txt, line 1: there is no state of the new model named Dance; there are "
                                        + "Clean, Move, Off, On, Spot, SpotWait")
                        .anySatisfy(line -> assertThat(line)
                                .startsWith(
                                        "robot.properties.txt, line 3: 'Move' stands where 'and', 'or', 'implies' or "
                                                + "the end should, after 'Spot'"))
                        .anySatisfy(line -> assertThat(line)
                                .startsWith("robot.properties.txt, line 6: the end stands where a name should")));
    }
}
