package org.evoloop.check.temporal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.evoloop.check.CheckInput;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/**
 * What can happen to the cleaning robot; {@code ModelCheckerTest} of {@code framework/models} compares it with a model
 * checker.
 */
class OutlookTest {
    static final List<String> TRUE = List.of(
            "always Spot implies can On",
            "Move only after event Spot",
            "never (Move and not device On)",
            "always (function Move implies device On)",
            "always event timeout implies On",
            "not Spot unless (Move or SpotWait)",
            "always (Spot implies eventually On)",
            "not eventually Spot",
            "can (SpotWait and device Clean)",
            "always can Clean and eventually On",
            "always (true implies can Clean) or next false",
            "Off until On",
            "next \"On\"");

    static final List<String> FALSE = List.of(
            "can false",
            "never SpotWait",
            "eventually Move",
            "(not Move) until Spot",
            "Off unless Spot",
            "always next On",
            "always (can Off and can On)",
            "eventually Spot or (never Move)");

    static final ModelPair ROBOT = robot();
    private static final Outlook OUTLOOK = new Outlook(DecisionTable.compile(
            ROBOT, CheckInput.of(ROBOT).withOwnEvents(Set.of("endSpot")).device()));
    private static final Moment START = new Moment(ROBOT.initial(), null);

    private static ModelPair robot() {
        ModelFile file = ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml"));
        return new ModelPair(file.pick("original"), file.pick("new"));
    }

    static Formula formula(String text) {
        return PropertyFile.parse("test", text, ROBOT).properties().get(0).formula();
    }

    @ParameterizedTest
    @FieldSource("TRUE")
    void holds(String text) {
        assertThat(OUTLOOK.holds(formula(text), START)).isTrue();
    }

    @ParameterizedTest
    @FieldSource("FALSE")
    void doesNotHold(String text) {
        assertThat(OUTLOOK.holds(formula(text), START)).isFalse();
    }

    @Test
    void aFormulaOfTheFutureIsNotSeenInAMoment() {
        assertThatThrownBy(() -> formula("next On").isSeenIn(START, ROBOT)).isInstanceOf(IllegalStateException.class);
    }
}
