package org.evoloop.check.temporal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.evoloop.check.CheckInput;
import org.evoloop.check.FunctionSends;
import org.evoloop.check.PairGraph;
import org.evoloop.evolution.DecisionTable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What is sure of the cleaning robot; {@code ModelCheckerTest} of {@code framework/models} compares it with a model
 * checker.
 */
class AssuranceTest {
    private static final CheckInput INPUT = CheckInput.of(OutlookTest.ROBOT)
            .withOwnEvents(Set.of("endSpot"))
            .withSends("Move", "Clean")
            .withSends("Move", "Spot")
            .withSends("SpotWait", "Clean")
            .withSends("SpotWait", "Spot");
    private static final DecisionTable TABLE = DecisionTable.compile(INPUT.pair(), INPUT.device());

    private static final Assurance SILENT =
            new Assurance(new MomentGraph(new PairGraph(OutlookTest.ROBOT.initial(), TABLE)), OutlookTest.ROBOT);
    private static final Assurance SENDING = new Assurance(
            MomentGraph.withSends(TABLE, FunctionSends.possible(INPUT), 1_000).orElseThrow(), OutlookTest.ROBOT);

    @ParameterizedTest
    @FieldSource("org.evoloop.check.temporal.OutlookTest#TRUE")
    void whatHoldsIsSureIfNothingIsSent(String text) {
        assertThat(SILENT.verdict(OutlookTest.formula(text))).contains(true);
    }

    @ParameterizedTest
    @FieldSource("org.evoloop.check.temporal.OutlookTest#FALSE")
    void whatDoesNotHoldIsSureIfNothingIsSent(String text) {
        assertThat(SILENT.verdict(OutlookTest.formula(text))).contains(false);
    }

    @ParameterizedTest
    @ValueSource(strings = {"always (function Move implies device On)", "never (Move and not device On)"})
    void whereTheDeviceIsWhileAFunctionRunsIsUnknown(String text) {
        assertThat(SENDING.verdict(OutlookTest.formula(text))).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"Move only after event Spot", "not Spot unless (Move or SpotWait)", "can Move"})
    void whatAllFunctionsLeaveAsItIsStaysSure(String text) {
        assertThat(SENDING.verdict(OutlookTest.formula(text))).contains(true);
    }
}
