package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.List;
import java.util.Map;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.OnFailure;
import org.junit.jupiter.api.Test;

/** An alarm in an elevator whose express ride takes two steps, and in whose queue one press may wait. */
class UrgentEventsTest {
    private final ScriptedCore lift = new ScriptedCore(Scene.lift());

    private static List<String> endings(ScriptedCore core) {
        return core.said.stream()
                .filter(Output.Ended.class::isInstance)
                .map(Output.Ended.class::cast)
                .map(ended -> ended.occurrence().label() + " " + ended.outcome() + " " + ended.detail())
                .toList();
    }

    private static List<String> sent(ScriptedCore core) {
        return core.said.stream()
                .filter(Output.Took.class::isInstance)
                .map(output -> ((Output.Took) output).step().trigger().name())
                .toList();
    }

    /** Whatever is in progress, until the elevator stands on the ground with its alarm. */
    private static void arrives(ScriptedCore core) {
        while (core.core.hasNext() || core.core.isBusy()) {
            core.ready().planned();
            while (core.core.isBusy()) {
                core.sending().sent(true);
            }
        }
    }

    @Test
    void endsAPlanBetweenTwoStepsAndIsDecidedFromWhereTheDeviceIs() {
        lift.press("express").begins().press("fire").sent(true).sending();
        assertThat(lift.core.isBusy()).isFalse();
        assertThat(endings(lift)).containsExactly("express OVERTAKEN fire came, which is urgent");

        arrives(lift);
        assertThat(sent(lift)).containsExactly("up", "down");
        assertThat(lift.core.at()).hasToString("(F, Alarm)");
    }

    @Test
    void endsAPlanBeforeItsFirstStepWithoutAnotherVisitBetween() {
        lift.press("express").ready().planned();
        long visit = lift.core.visit();
        lift.press("fire").sending();
        assertThat(endings(lift)).hasSize(1);
        assertThat(lift.core.isVisitOver()).isTrue();
        assertThat(lift.core.visit()).isEqualTo(visit);

        arrives(lift);
        assertThat(sent(lift)).isEmpty();
        assertThat(lift.core.at()).hasToString("(F, Alarm)");
        assertThat(lift.core.visit()).isEqualTo(visit + 1);
    }

    @Test
    void aStepThatIsBeingSentIsSentAndAnArrivalIsNotTakenBack() {
        lift.press("up").begins().press("fire").sent(true);
        assertThat(endings(lift)).containsExactly("up HANDLED ");
    }

    @Test
    void hasAPlaceInAFullQueueAndGoesBeforeThePressesInIt() {
        lift.press("up").begins().press("up").press("down").press("fire").press("fire");
        assertThat(lift.core.tally().dropped()).isEqualTo(1);

        lift.sent(true).begins();
        assertThat(lift.work().pending().occurrence().label()).isEqualTo("fire");
    }

    @Test
    void aPressThatHasItsTurnButIsNotDecidedWaitsForIt() {
        lift.press("express").ready().press("fire").planned();
        assertThat(endings(lift)).isEmpty();
        arrives(lift);
        assertThat(endings(lift)).first().isEqualTo("fire HANDLED ");
    }

    @Test
    void aFactIsHeardBeforeIt() {
        lift.press("up").begins().sent(true);
        lift.press("fire").own("down").ready();
        assertThat(lift.work().pending().occurrence().label()).isEqualTo("down");
    }

    @Test
    void thereIsNoRecoveryFromAFailedStepBeforeIt() {
        ScriptedCore going = new ScriptedCore(Scene.lift().onFailure(OnFailure.GO_BACK));
        going.press("express").begins().sent(true).sending().press("fire");
        going.input(new Input.Failed(going.number(), "jammed", 9));
        assertThat(endings(going)).containsExactly("express FAILED jammed");

        ScriptedCore recovering = new ScriptedCore(Scene.lift().onFailure(OnFailure.GO_BACK));
        recovering.press("express").begins().sent(true).sending();
        recovering.input(new Input.Failed(recovering.number(), "jammed", 9)).press("fire");
        recovering.ready().planned();
        assertThat(endings(recovering)).containsExactly("express OVERTAKEN jammed; then fire came, which is urgent");
    }

    @Test
    void endsNoPlanWhereTheNewModelWouldNotTakeIt() {
        String[] floors = {"F up -> G", "G up -> H"};
        ModelPair pair = new ModelPair(
                machine("lift", floors),
                machine("express", "F up -> G", "G up -> H", "F express -> H", "H fire -> F", "urgent fire"));
        ScriptedCore plain = new ScriptedCore(Scene.of("plain lift", pair, Map.of(), "up", "", 1));
        plain.press("express").begins().press("fire").sent(true).sending();
        assertThat(plain.core.isBusy()).isTrue();
        assertThat(plain.sent(true).core.at()).hasToString("(H, H)");
    }
}
