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
import org.evoloop.xmi.XmiFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PropertyCheckTest {
    private static final ModelPair ROBOT = cleaningRobot();

    private static ModelPair cleaningRobot() {
        XmiFile file = XmiFile.read(Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml"));
        return new ModelPair(file.pick("original"), file.pick("new"));
    }

    private static List<Finding> check(String text) {
        return PropertyCheck.run(
                CheckInput.of(ROBOT).withOwnEvents(Set.of("endSpot")),
                PropertyFile.parse("robot.properties.txt", text, ROBOT));
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
