package org.evoloop.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import java.util.List;
import java.util.Set;
import org.evoloop.PaperModels;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

class DecisionTableTest {
    private static final Set<Event> BUTTONS = Set.of(new Event("Clean"), new Event("Spot"));

    private final DecisionTable robot =
            DecisionTable.compile(PaperModels.cleaningRobot(), new DeviceEvents(BUTTONS, BUTTONS));

    private static Configuration at(String original, String evolved) {
        return new Configuration(new State(original), new State(evolved));
    }

    private static Decision decide(DecisionTable table, Configuration at, String event, boolean deviceActed) {
        return table.decide(at, new Event(event), deviceActed);
    }

    private static List<String> steps(Decision decision) {
        return decision.steps().stream().map(Step::toString).toList();
    }

    @Test
    void sendsTheIncomingEventOnIfItLeadsThere() {
        Decision decision = decide(robot, at("On", "On"), "Clean", false);

        assertThat(decision).isInstanceOf(Decision.ExistingState.class);
        assertThat(steps(decision)).containsExactly("On --Clean--> Clean");
        assertThat(decision.after()).isEqualTo(at("Clean", "Clean"));
    }

    @Test
    void sendsAnotherEventIfThatLeadsThere() {
        assertThat(steps(decide(robot, at("On", "Move"), "arriveSpot", false))).containsExactly("On --Spot--> Spot");
    }

    @Test
    void takesTheShortestWayAsADetour() {
        Decision decision = decide(robot, at("Clean", "SpotWait"), "Clean", false);

        assertThat(steps(decision)).containsExactly("Clean --Clean--> On", "On --Spot--> Spot");
        assertThat(((Decision.ExistingState) decision).isDetour()).isTrue();
    }

    @Test
    void startsANewFunctionWithoutSendingAnything() {
        Decision decision = decide(robot, at("On", "On"), "Spot", false);

        assertThat(decision).isInstanceOf(Decision.NewState.class);
        assertThat(decision.steps()).isEmpty();
        assertThat(decision.after()).isEqualTo(at("On", "Move"));
    }

    @Test
    void sendsNothingIfTheDeviceIsThereAlready() {
        Decision decision = decide(robot, at("On", "SpotWait"), "timeout", false);

        assertThat(decision).isInstanceOf(Decision.ExistingState.class);
        assertThat(decision.steps()).isEmpty();
        assertThat(decision.after()).isEqualTo(at("On", "On"));
    }

    @Test
    void movesTheOriginalModelFirstIfTheDeviceHasActed() {
        Decision decision = decide(robot, at("Clean", "Clean"), "Clean", true);

        assertThat(decision).isInstanceOf(Decision.NewState.class);
        assertThat(steps(decision)).containsExactly("Clean --Clean--> On (by the device)");
        assertThat(decision.after()).isEqualTo(at("On", "SpotWait"));
    }

    @Test
    void plansFromWhereTheDeviceHasGone() {
        // The robot has resumed cleaning on its own button; it must be paused again before it can spot clean.
        Decision decision = decide(robot, at("On", "SpotWait"), "Clean", true);

        assertThat(steps(decision))
                .containsExactly("On --Clean--> Clean (by the device)", "Clean --Clean--> On", "On --Spot--> Spot");
    }

    @Test
    void whatCanNeitherBeSentNorIsDeclaredToBeTheDevicesOwnFails() {
        DecisionTable deaf = DecisionTable.compile(
                PaperModels.cleaningRobot(), new DeviceEvents(Set.of(new Event("Clean")), Set.of()));
        Decision decision = decide(deaf, at("On", "On"), "Spot", false);
        assertThat(decision).isInstanceOfSatisfying(Decision.Impossible.class, impossible -> {
            assertThat(impossible.after()).isEqualTo(at("On", "On"));
            assertThat(impossible.reason())
                    .isEqualTo(
                            "event Spot is the device's, but can neither be sent nor is it declared to be the device's "
                                    + "own");
        });
        assertThat(deaf.problems()).noneMatch(problem -> problem.reason().startsWith("event Spot is the device's"));
    }

    @Test
    void takesAnEventThatIsDeclaredToBeTheDevicesOwnForOne() {
        Decision decision = decide(robot, at("Spot", "Spot"), "endSpot", false);

        assertThat(steps(decision)).containsExactly("Spot --endSpot--> On (by the device)");
        assertThat(decision.after()).isEqualTo(at("On", "On"));
    }

    @Test
    void ignoresWhatTheNewModelHasNoTransitionForButFollowsTheDevice() {
        Decision ignored = decide(robot, at("On", "Move"), "Clean", false);
        assertThat(ignored).isInstanceOf(Decision.NotAcceptable.class);
        assertThat(ignored.after()).isEqualTo(at("On", "Move"));

        Decision followed = decide(robot, at("On", "Move"), "Clean", true);
        assertThat(followed).isInstanceOf(Decision.NotAcceptable.class);
        assertThat(followed.after()).isEqualTo(at("Clean", "Move"));
    }

    @Test
    void knowsNothingOfEventsOfNeitherModel() {
        assertThat(decide(robot, at("On", "On"), "Dock", false)).isInstanceOf(Decision.NotAcceptable.class);
    }

    @Test
    void sendsASelfTransitionThatTheEventAsksFor() {
        ModelPair pair = new ModelPair(
                StateMachine.named("o")
                        .initial("A")
                        .transition("A", "ping", "A")
                        .build(),
                StateMachine.named("n")
                        .initial("A")
                        .transition("A", "ping", "A")
                        .build());
        DecisionTable table = DecisionTable.compile(pair, new DeviceEvents(Set.of(new Event("ping")), Set.of()));

        assertThat(steps(decide(table, at("A", "A"), "ping", false))).containsExactly("A --ping--> A");
        assertThat(steps(decide(table, at("A", "A"), "ping", true))).containsExactly("A --ping--> A (by the device)");
    }

    @Test
    void exploresEveryConfigurationOfThePapersPairs() {
        assertThat(robot.problems()).isEmpty();
        // Its SPOT button is pressed in SpotWait, before the converter has taken control: no event can stop it.
        assertThat(robot.hazards()).extracting(Decision::before).containsExactly(at("Spot", "SpotWait"));
        assertThat(robot.configurations())
                .contains(at("Off", "Off"), at("On", "SpotWait"), at("Clean", "SpotWait"), at("Spot", "Move"));

        DecisionTable lamp =
                DecisionTable.compile(PaperModels.lightBulb(), new DeviceEvents(Set.of(new Event("switch")), Set.of()));
        assertThat(lamp.problems()).isEmpty();
        assertThat(lamp.configurations())
                .containsExactlyInAnyOrder(
                        at("off", "off"), at("on", "on"), at("on", "wait"), at("on", "incandescentOn"));
        assertThat(steps(decide(lamp, at("on", "wait"), "timeout", false))).containsExactly("on --switch--> off");
        assertThat(steps(decide(lamp, at("on", "incandescentOn"), "switch", false)))
                .containsExactly("on --switch--> off");
    }

    @Test
    void findsDecisionsThatNoPlanCanCarryOut() {
        DecisionTable deaf = DecisionTable.compile(
                PaperModels.cleaningRobot(), new DeviceEvents(Set.of(new Event("Clean")), Set.of(new Event("Spot"))));

        assertThat(deaf.problems())
                .extracting(Decision.Impossible::reason)
                .anySatisfy(reason -> assertThat(reason)
                        .isEqualTo(
                                "event arriveSpot leads to Spot, but with the device in On no events that can be sent "
                                        + "take it there (sendable: Clean)"));
    }

    @Test
    void decidesWhereAPlanBrokeOff() {
        // Sent Clean of the detour, then the cable broke: the device is On, the new model still in SpotWait.
        DecisionTable withoutPanel =
                DecisionTable.compile(PaperModels.cleaningRobot(), new DeviceEvents(BUTTONS, Set.of()));
        assertThat(withoutPanel.configurations()).doesNotContain(at("On", "SpotWait"));

        assertThat(steps(decide(withoutPanel, at("On", "SpotWait"), "Clean", false)))
                .containsExactly("On --Spot--> Spot");
    }

    @Test
    void keepsWhatTheNewModelRemembersIfTheDeviceIsFoundWhereItWasRecorded() {
        StateMachine lamp = machine(
                "lamp",
                "Off power -> Bright",
                "Off[Dim] power -> Dim",
                "Bright power -> Off",
                "Dim power -> Off[Dim]",
                "Bright dim -> Dim",
                "Dim dim -> Bright");
        Set<Event> buttons = lamp.triggers();
        DecisionTable table = DecisionTable.compile(new ModelPair(lamp, lamp), new DeviceEvents(buttons, buttons));
        Configuration bright = at("Bright", "Bright");
        Decision usual = decide(table, bright, "power", false);
        BrokenPlan broken = new BrokenPlan(OnFailure.OTHER_WAY, "the lamp sticks", bright.original(), usual.steps());
        Decision otherWay = table.afterFailure(usual, bright, broken);
        assertThat(steps(otherWay)).containsExactly("Bright --dim--> Dim", "Dim --power--> Off[Dim]");
        Configuration off = otherWay.after();
        assertThat(off).isEqualTo(at("Off[Dim]", "Off"));

        assertThat(table.find(off, off.original()).after())
                .as("switched on again, the new lamp is bright as before")
                .isEqualTo(off);
        assertThat(steps(decide(table, off, "power", false)))
                .containsExactly("Off[Dim] --power--> Dim", "Dim --dim--> Bright");
        assertThat(table.find(bright, off.original()).after()).isEqualTo(at("Off[Dim]", "Off[Dim]"));
    }

    @Test
    void prefersTheShorterAndAmongEqualTheFirstDrawn() {
        StateMachine original = StateMachine.named("o")
                .initial("A")
                .transition("A", "x", "B")
                .transition("A", "y", "C")
                .transition("B", "x", "D")
                .transition("C", "y", "D")
                .transition("D", "z", "A")
                .build();
        PathPlanner planner = new PathPlanner(original, new DeviceEvents(Set.copyOf(original.events()), Set.of()));

        assertThat(planner.shortestPath(new State("A"), List.of(new State("D"))).orElseThrow())
                .extracting(Step::event)
                .containsExactly(new Event("x"), new Event("x"));
        assertThat(planner.shortestPath(new State("A"), List.of(new State("A"))))
                .contains(List.of());
        assertThat(planner.shortestPath(new State("D"), List.of(new State("C"))).orElseThrow())
                .hasSize(2);
    }

    @Test
    void listsEveryViolationOfTheConditionsByName() {
        ModelPair pair = new ModelPair(
                PaperModels.cleaningRobot().original(),
                StateMachine.named("poor")
                        .initial("On")
                        .transition("On", "Clean", "Off")
                        .build());

        assertThat(pair.violations()).hasSize(4);
        assertThatThrownBy(pair::requireValid)
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("'original' and 'poor'")
                .hasMessageContaining("Condition 1: event Spot is missing")
                .hasMessageContaining("Condition 1: event endSpot is missing")
                .hasMessageContaining("Condition 2: state Clean is missing")
                .hasMessageContaining("Condition 2: state Spot is missing")
                .hasMessageContaining("starts in On, the device in Off");
        assertThat(PaperModels.cleaningRobot().violations()).isEmpty();
    }

    @Test
    void whatIsMeantIsSaidWhereModelsAreSwappedOrAnEventIsMisspelt() {
        ModelPair robot = PaperModels.cleaningRobot();
        assertThatThrownBy(
                        new ModelPair(/* original= */ robot.evolved(), /* evolved= */ robot.original())::requireValid)
                .hasMessageContaining("are the two models swapped?");
        StateMachine door = StateMachine.named("original")
                .initial("Open")
                .transition("Open", "closed", "Shut")
                .build();
        StateMachine misspelt = StateMachine.named("new")
                .initial("Open")
                .transition("Open", "closd", "Shut")
                .build();
        assertThatThrownBy(new ModelPair(door, misspelt)::requireValid)
                .hasMessageContaining("event closed is missing in the new model; did you mean closd?")
                .hasMessageNotContaining("swapped");
    }
}
