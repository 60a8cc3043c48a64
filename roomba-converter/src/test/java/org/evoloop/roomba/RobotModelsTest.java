package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.evoloop.PaperPair;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;

/** Which function runs in which new state, and which transitions leave Move. */
class RobotModelsTest {
    private static final StateMachine ORIGINAL = PaperPair.cleaningRobot().original();
    private static final State HUNT = new State("Hunt");
    private static final State PAUSE = new State("Pause");

    /** The device's model, with SPOT leading to Hunt. */
    private static StateMachineBuilder hunting() {
        return StateMachine.named("hunting")
                .initial("Off")
                .transition("Off", "Clean", "On")
                .transition("On", "Clean", "Clean")
                .transition("On", "Spot", "Hunt")
                .transition("Spot", "endSpot", "On");
    }

    private static StateMachineBuilder arriving() {
        return hunting().transition("Clean", "Clean", "On").transition("Hunt", "arriveSpot", "Spot");
    }

    private static RobotModels read(StateMachineBuilder evolved, String... wanted) {
        return RobotModels.of(new ModelPair(ORIGINAL, evolved.build()), List.of(wanted));
    }

    private static void assertRefused(String problem, StateMachineBuilder evolved, String... wanted) {
        assertThatThrownBy(() -> read(evolved, wanted))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith("this program cannot carry out 'hunting':\n")
                .hasMessageContaining(problem)
                .hasMessageNotContaining("registerNewFunctions");
    }

    @Test
    void aFunctionRunsInTheNewStateThatIsLeftByTheEventItFinishesWith() {
        RobotModels read = read(hunting()
                .transition("Clean", "Clean", "Pause")
                .transition("Pause", "timeout", "On")
                .transition("Hunt", "arriveSpot", "Spot")
                .transition("Hunt", "timeout", "On"));
        assertThat(read.functions())
                .containsEntry(HUNT, RobotFunction.MOVE)
                .containsEntry(PAUSE, RobotFunction.SPOT_WAIT)
                .hasSize(2);
        assertThat(read.hasSpotWait()).isTrue();
    }

    @Test
    void aTimeTriggerNeedsNoFunction() {
        RobotModels read = read(hunting()
                .transition("Clean", "Clean", "Pause")
                .transition("Pause", "tm(2s)", "On")
                .transition("Hunt", "arriveSpot", "Spot"));
        assertThat(read.functions()).containsOnlyKeys(HUNT);
        assertThat(read.hasSpotWait()).isFalse();
    }

    @Test
    void theOptionSaysOtherwise() {
        StateMachineBuilder two =
                arriving().transition("Hunt", "Clean", "Hunt2").transition("Hunt2", "arriveSpot", "Spot");
        assertThat(read(two, "Hunt2=Move", "Hunt=none").functions())
                .containsEntry(new State("Hunt2"), RobotFunction.MOVE)
                .containsEntry(HUNT, RobotFunction.NONE);
    }

    @Test
    void whereTwoStatesFitTheOwnerIsAsked() {
        assertRefused(
                "new states Hunt, Hunt2 are all left by arriveSpot; say in which of them Move runs, for example "
                        + "--function Hunt=Move",
                arriving().transition("Hunt", "Clean", "Hunt2").transition("Hunt2", "arriveSpot", "Spot"));
    }

    @Test
    void aStateThatNothingFitsIsReportedWithARemedyForTheCommandLine() {
        assertRefused(
                "new state Pause has no function. Move runs in the state that arriveSpot leaves, SpotWait in the one "
                        + "that timeout leaves; draw such a transition, or a time trigger such as tm(2s), or give "
                        + "--function Pause=none if nothing has to run there",
                arriving().transition("Hunt", "Clean", "Pause").transition("Pause", "Clean", "On"));
    }

    @Test
    void anOptionThatCannotBeMeantIsRefused() {
        assertRefused(
                "--function Hunt: write STATE=FUNCTION; the functions are Move, SpotWait, SpotClean, Charge, "
                        + "QuietHours and none",
                arriving(),
                "Hunt");
        assertRefused("--function Hunt=Dance: write STATE=FUNCTION", arriving(), "Hunt=Dance");
        assertRefused("--function Wander=Move: 'Wander' is no new state; there are Hunt", arriving(), "Wander=Move");
        assertRefused("--function On=none: 'On' is no new state; there are Hunt", arriving(), "On=none");
        assertRefused(
                "--function Hunt=SpotWait: SpotWait finishes with timeout, which does not leave Hunt",
                arriving(),
                "Hunt=SpotWait");
        assertRefused("Hunt has been given a function before", arriving(), "Hunt=Move", "Hunt=none");
    }

    @Test
    void guardsAndEffectsAreRefusedInWordsOfTheCommandLine() {
        assertRefused(
                "guard [dark] of the new model is unknown to this program; draw the model without it",
                arriving()
                        .transition(
                                new Transition(new State("Hunt"), new Event("Spot", List.of("dark")), new State("On")),
                                ""));
        assertRefused(
                "effect sing of the new model is unknown to this program; draw the model without it",
                arriving()
                        .transition(
                                new Transition(HUNT, new Event("Spot"), new State("Spot"), List.of("sing"), false),
                                ""));
    }

    @Test
    void outOfMoveLeadsAWayBackToWhereItsPressOccurred() {
        StateMachine evolved = read(
                        hunting()
                                .transition("Clean", "Clean", "On")
                                .transition("On", "tm(60s)", "Doze")
                                .transition("Doze", "Spot", "Pause")
                                .transition("Pause", "tm(2s)", "Hunt")
                                .transition("Hunt", "arriveSpot", "Spot"),
                        "Doze=none")
                .pair()
                .evolved();
        assertThat(evolved.nextState(HUNT, new Event("backToOn"))).contains(new State("On"));
        assertThat(evolved.nextState(HUNT, new Event("backToDoze"))).contains(new State("Doze"));
        assertThat(evolved.hasTransition(HUNT, new Event("backToPause")))
                .as("in that state it would drive off by itself")
                .isFalse();
    }

    @Test
    void whereAStateIsDrawnStaysKnown() {
        StateMachine evolved = read(arriving().drawn(HUNT, HUNT, List.of("Move"), List.of("Evolved.Hunt"), false))
                .pair()
                .evolved();
        assertThat(evolved.hasTransition(HUNT, new Event("backToOn"))).isTrue();
        assertThat(evolved.paths(HUNT)).containsExactly("Evolved.Hunt");
    }

    @Test
    void whereTheDeviceCannotBeSentNoWayLeads() {
        StateMachine evolved =
                read(arriving().transition("Spot", "Spot", "Hunt")).pair().evolved();
        assertThat(evolved.hasTransition(HUNT, new Event("backToOn")))
                .as("no event that can be sent ends a spot cleaning")
                .isFalse();
        assertThat(evolved.transitions()).contains(new Transition(HUNT, new Event("backToSpot"), new State("Spot")));
    }
}
