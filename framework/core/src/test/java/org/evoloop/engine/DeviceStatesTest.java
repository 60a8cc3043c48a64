package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/** New states that need the device somewhere, while it acts by itself, and steps and processes come to nothing. */
class DeviceStatesTest {
    private final ScriptedCore door = new ScriptedCore(DeviceStateScenes.door());

    private static Configuration at(String original, String evolved) {
        return new Configuration(new State(original), new State(evolved));
    }

    private List<String> sent() {
        return door.said.stream()
                .filter(Output.Took.class::isInstance)
                .map(output -> ((Output.Took) output).step().trigger().name())
                .toList();
    }

    private boolean isStarted() {
        long visit = door.core.visit();
        return door.said.stream().anyMatch(output -> output instanceof Output.Start start && start.visit() == visit);
    }

    private ScriptedCore inGapMoving() {
        return door.press("gap").begins().sent(true);
    }

    private ScriptedCore inGap() {
        inGapMoving();
        door.input(new Input.TimerDue(door.core.visit(), new Event("timeout"), 10_000_000_000L));
        return door.begins().sent(true);
    }

    @Test
    void enteringTakesTheDeviceThereAndStartsTheFunction() {
        inGapMoving();
        assertThat(door.core.at()).isEqualTo(at("Opening", "GapMoving"));
        assertThat(sent()).containsExactly("press");
        assertThat(isStarted()).isTrue();
    }

    @Test
    void whatTheDeviceDidIsHeardBeforeAPressThatHasItsTurn() {
        inGap();
        door.press("press").ready().own("press").planned();
        assertThat(door.core.isBusy()).isFalse();

        door.ready().planned();
        assertThat(door.core.at()).as("drawn: Gap press -> Closing").isEqualTo(at("Closing", "Closing"));
        door.begins().sent(true);
        assertThat(sent()).containsExactly("press", "press", "press");
        assertThat(door.core.at()).isEqualTo(at("StopDown", "StopDown"));
    }

    @Test
    void theNewModelFollowsADeviceThatLeavesWhereNothingIsDrawn() {
        inGapMoving();
        door.own("limitOpen").ready().planned();
        assertThat(door.core.at()).isEqualTo(at("Open", "Open"));
        assertThat(sent()).containsExactly("press");
    }

    @Test
    void aLostAnswerEndsInTheStateThatWasAskedFor() {
        door.press("gap").begins().givenUp().ready().planned().located("Opening");
        assertThat(door.core.at()).isEqualTo(at("Opening", "GapMoving"));
        assertThat(isStarted()).isTrue();
        assertThat(sent()).isEmpty();
    }

    @Test
    void soDoesAProcessThatEndsWhileItSends() {
        door.press("gap").begins();
        door.input(new Input.Recovered(1))
                .input(new Input.Opened(2))
                .ready()
                .planned()
                .located("Opening");
        assertThat(door.core.at()).isEqualTo(at("Opening", "GapMoving"));
        assertThat(sent()).isEmpty();
    }

    @Test
    void aReportCompletesItAsAnAnswerDoes() {
        door.press("gap").begins().givenUp().found("Opening");
        assertThat(door.core.doubt()).isEmpty();
        door.ready().planned();
        assertThat(door.core.at()).isEqualTo(at("Opening", "GapMoving"));
        assertThat(isStarted()).isTrue();
        assertThat(sent()).isEmpty();
    }

    @Test
    void aReportCompletesItAlsoWhileTheDeviceIsAskedForIt() {
        door.press("gap").begins().givenUp().ready().found("Opening");
        door.planned().located("Opening").ready().planned();
        assertThat(door.core.at()).isEqualTo(at("Opening", "GapMoving"));
        assertThat(isStarted()).isTrue();
        assertThat(sent()).isEmpty();
    }

    @Test
    void aReportDoesNotCompleteWhatTheDeviceHasLeftByItself() {
        door.press("gap").begins().givenUp().found("Opening").own("limitOpen");
        door.ready().planned().ready().planned();
        assertThat(door.core.at()).isEqualTo(at("Open", "Open"));
        assertThat(sent()).isEmpty();
    }

    @Test
    void aPressThatHasMovedTheDeviceIsNotTakenForAnother() {
        inGap();
        // Before or after it took the step?
        door.press("press").begins().found("StopUp").sent(false);
        assertThat(door.record()).endsWith(", in doubt");
        door.ready().planned().located("Closing");
        while (door.core.hasNext()) {
            door.ready().planned();
            if (door.core.snapshot().work() != null) {
                door.sending().sent(true);
            }
        }
        assertThat(door.core.at()).isEqualTo(at("Closing", "Closing"));
        assertThat(sent()).containsExactly("press", "press", "press");
    }

    /** The device could have taken the press twice, by hand and from here; what is asked for meanwhile waits. */
    @Test
    void aLateEffectIsFollowedBeforeWhatHasItsTurnIsDecided() {
        door.press("gap").begins();
        long gap = door.number();
        door.givenUp().ready().planned().located("Opening");
        door.input(new Input.TimerDue(door.core.visit(), new Event("timeout"), 10_000_000_000L))
                .ready()
                .sent(gap, true);
        assertThat(door.core.at()).isEqualTo(at("StopUp", "GapMoving"));

        door.planned();
        assertThat(door.core.isBusy()).isFalse();
        door.ready().planned();
        assertThat(door.core.at()).isEqualTo(at("StopUp", "StopUp"));
        assertThat(sent()).containsExactly("press");
    }

    @Test
    void aStepThatHadNoEffectIsNotSentAgain() {
        door.press("gap").begins().givenUp().ready().planned().located("Closed");
        assertThat(door.core.at()).isEqualTo(at("Closed", "Closed"));
        assertThat(sent()).isEmpty();
        assertThat(door.core.hasNext()).isFalse();
    }

    @Test
    void aFunctionStartsOnlyOnceTheDeviceIsThere() {
        inGap();
        door.input(new Input.Recovered(1)).own("press").input(new Input.Opened(2));
        assertThat(isStarted()).as("a fact waits: Gap is left").isFalse();

        door.ready().planned();
        assertThat(door.core.at()).isEqualTo(at("Closing", "Closing"));
    }

    @Test
    void aFunctionThatIsResumedStartsWithoutSendingAnything() {
        inGap();
        door.input(new Input.Recovered(1)).input(new Input.Opened(2));
        assertThat(isStarted()).isTrue();
        assertThat(sent()).containsExactly("press", "press");
    }

    /** The device could not say where it is, and is then reported to be where the record has it: nothing has its turn. */
    @Test
    void aFunctionThatWaitsForCertaintyStartsWhenThereIsSome() {
        inGap();
        door.press("press").begins().givenUp().asksInVain();
        door.said.clear();

        door.found("StopUp");

        assertThat(door.core.hasNext()).isFalse();
        assertThat(isStarted()).isTrue();
    }

    @Test
    void noFunctionStartsBeforeTheConverterIsOpen() {
        inGap();
        door.press("press").begins().givenUp().asksInVain().input(new Input.Recovered(1));
        door.said.clear();

        door.found("StopUp");
        assertThat(isStarted()).isFalse();

        door.input(new Input.Opened(2));
        assertThat(isStarted()).isTrue();
    }

    @Test
    void aFindingElsewhereEndsTheVisit() {
        inGap();
        door.found("Closed").ready().planned();
        assertThat(door.core.at()).isEqualTo(at("Closed", "Closed"));
    }

    @Test
    void whatAFunctionSendsDoesNotTakeTheDeviceAway() {
        inGap();
        door.observe(new Occurrence.Asked(new Event("press"), Values.NONE, door.core.visit(), 5));
        door.ready().planned();
        assertThat(door.core.at()).isEqualTo(at("StopUp", "Gap"));
        assertThat(door.said)
                .anyMatch(output -> output instanceof Output.Ended ended
                        && ended.decision() instanceof Decision.Impossible impossible
                        && impossible
                                .reason()
                                .equals("the function of Gap asks for press, which Gap does not declare; draw \"sends"
                                        + " press\" in Gap (SCXML: ev:sends=\"press\"), or call sends(\"Gap\","
                                        + " \"press\") in registerNewFunctions"));
    }
}
