package org.evoloop.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.PaperModels;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.OnFailure;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

class CheckTest {
    private static final StateMachine LAMP = machine("original", "Off press -> On", "On press -> Off");

    private static CheckInput input(StateMachine original, String... evolved) {
        return CheckInput.of(new ModelPair(original, machine("new", evolved)));
    }

    /** The lamp with these lines added to its model. */
    private static CheckInput lampWith(String... lines) {
        return input(
                LAMP,
                Stream.concat(Stream.of("Off press -> On", "On press -> Off"), Arrays.stream(lines))
                        .toArray(String[]::new));
    }

    /** The same pair, in which a new state has a device state, and its function sends events. */
    private static CheckInput using(CheckInput input, String state, String device, String... sends) {
        StateMachine evolved = input.pair().evolved();
        if (!device.isEmpty()) {
            evolved = evolved.withDeviceState(new State(state), device);
        }
        for (String event : sends) {
            evolved = evolved.withSends(new State(state), new Event(event));
        }
        return CheckInput.of(new ModelPair(input.pair().original(), evolved)).withDevice(input.device());
    }

    /** A lamp that turns itself off, and a new state in which it is on. */
    private static CheckInput warm(String... lines) {
        String[] lamp = {"Off press -> On", "On press -> Off", "On own -> Off"};
        String[] warm = Stream.of(lamp, new String[] {"On dim -> Warm", "Warm press -> Off"}, lines)
                .flatMap(Stream::of)
                .toArray(String[]::new);
        return using(input(machine("original", lamp), warm).withOwnEvents(Set.of("own")), "Warm", "On");
    }

    private static CheckInput robot() {
        return CheckInput.of(PaperModels.cleaningRobot())
                .withOwnEvents(Set.of("endSpot"))
                .withFunctions(Set.of("Move", "SpotWait"))
                .withRaised(Set.of("Clean", "Spot", "endSpot", "arriveSpot", "timeout"))
                .withGuards(Set.of())
                .withEffects(Set.of());
    }

    static List<Arguments> pairsThatBreakOneRule() {
        StateMachine detour = machine("original", "On go -> Clean", "Clean stop -> Spot", "Spot stop -> On");
        DeviceEvents deaf =
                new DeviceEvents(Set.of(new Event("go"), new Event("stop")), Set.of(new Event("go"), new Event("own")));
        return List.of(
                arguments(
                        Rule.CONDITION_1,
                        input(
                                machine("original", "Off press -> On", "On press -> Off", "!dim"),
                                "Off press -> On",
                                "On press -> Off")),
                arguments(Rule.CONDITION_2, input(detour, "On go -> Spot", "Spot stop -> On")),
                arguments(Rule.INITIAL_DIFFERS, input(LAMP, "On press -> Off", "Off press -> On")),
                arguments(Rule.DEVICE_STATE, using(lampWith("On dim -> Warm", "Warm press -> Off"), "Warm", "Onn")),
                arguments(Rule.DEVICE_STATE, using(lampWith(), "Off", "On")),
                arguments(
                        Rule.DECLARED_SEND,
                        using(lampWith("On dim -> Warm", "Warm press -> Off"), "Warm", "", "blink")),
                arguments(
                        Rule.DECLARED_SEND,
                        using(lampWith("On dim -> Warm", "Warm press -> Off"), "Warm", "On", "press")),
                arguments(
                        Rule.DECLARED_SEND,
                        using(
                                input(
                                        machine("original", "Off press -> On", "On press -> Off", "Off hold -> Off"),
                                        "Off press -> On",
                                        "On press -> Off",
                                        "Off hold -> Off",
                                        "On dim -> Warm",
                                        "Warm press -> Off"),
                                "Warm",
                                "On",
                                "hold")),
                arguments(Rule.RESTLESS, lampWith("On tm(0s) -> Off", "Off tm(0s) -> On")),
                arguments(Rule.DEVICE_LEAVES, warm()),
                arguments(Rule.TIMER_OR_DEVICE, warm("Warm own -> Off", "Warm tm(2s) -> On")),
                arguments(Rule.NONDETERMINISM, lampWith("On dim [hot] [full] -> Off", "On dim [full] [hot] -> On")),
                arguments(Rule.NONDETERMINISM, lampWith("On tm(2s) -> Off", "On after 2 s -> On")),
                arguments(Rule.UNREACHABLE_STATE, lampWith("Warm press -> Off")),
                arguments(Rule.DEAD_TRANSITION, lampWith("On press [hot] -> On")),
                arguments(
                        Rule.DEAD_TRANSITION,
                        input(
                                        machine("original", "Off press -> On", "On press -> Off", "On own -> Off"),
                                        "Off press -> On",
                                        "On press -> Off",
                                        "On own -> Off",
                                        "Off dim -> Warm",
                                        "Warm press -> On",
                                        "Warm own -> Off")
                                .withOwnEvents(Set.of("own"))),
                arguments(Rule.TRAP_STATE, lampWith("On dim -> Warm")),
                arguments(
                        Rule.UNSENDABLE_EVENT,
                        input(
                                        machine(
                                                "original",
                                                "Off press -> On",
                                                "On press -> Off",
                                                "On up -> Hot",
                                                "Hot up -> On"),
                                        "Off press -> On",
                                        "On press -> Off",
                                        "On up -> Hot",
                                        "Hot up -> On",
                                        "Hot press -> Off")
                                .withDevice(new DeviceEvents(Set.of(new Event("press")), Set.of()))),
                arguments(
                        Rule.NO_FUNCTION,
                        lampWith("On dim -> Warm", "Warm press -> Off").withFunctions(Set.of("Cold"))),
                arguments(
                        Rule.NO_PATH,
                        input(
                                        machine("original", "Off press -> On", "On own -> Off", "On press -> On"),
                                        "Off press -> On",
                                        "On own -> Off",
                                        "On press -> On",
                                        "On dim -> Warm",
                                        "Warm up -> Off",
                                        "Warm press -> On")
                                .withOwnEvents(Set.of("own"))),
                arguments(
                        Rule.HAZARD,
                        input(
                                        machine(
                                                "original",
                                                "On go -> Clean",
                                                "Clean own -> On",
                                                "On stop -> On",
                                                "Clean stop -> Clean"),
                                        "On go -> Clean",
                                        "Clean own -> On",
                                        "On stop -> On",
                                        "Clean stop -> Clean",
                                        "On wait -> Wait",
                                        "Wait go -> Wait",
                                        "Wait stop -> Wait",
                                        "Wait up -> On")
                                .withDevice(deaf)),
                arguments(
                        Rule.DEGRADATION,
                        input(
                                detour,
                                "On go -> Clean",
                                "Clean stop -> Spot",
                                "Spot wait -> Wait",
                                "Wait stop -> Wait",
                                "Wait go -> Spot",
                                "Spot stop -> Spot")),
                arguments(Rule.TIMER_CANNOT_FIRE, lampWith("On tm(2s) -> Off", "On tm(3s) -> On")),
                arguments(Rule.TIMER_CANNOT_FIRE, lampWith("On tm_2s -> Off")),
                arguments(Rule.UNRAISED_EVENT, lampWith("On dim -> Off").withRaised(Set.of("press"))),
                arguments(Rule.UNBOUND_GUARD, lampWith("On dim [hot] -> Off").withGuards(Set.of("full"))),
                arguments(Rule.UNBOUND_EFFECT, lampWith("On dim -> Off / beep").withEffects(Set.of("blink"))),
                arguments(Rule.SWALLOWED_EVENT, lampWith("On dim -> Warm", "Warm up -> Off")),
                arguments(
                        Rule.PASSED_EFFECT,
                        input(
                                machine("original", "Off go -> On / beep", "On go -> Hot", "Hot stop -> Off"),
                                "Off go -> On / beep",
                                "On go -> Hot",
                                "Hot stop -> Off",
                                "Off boost -> Hot")),
                arguments(Rule.NO_FALLBACK, oneWay()),
                arguments(Rule.GUARD_OVERLAP, lampWith("On dim [hot] -> Off", "On dim [full] -> On")));
    }

    /** Once it is up, only the step that has failed leads on to the top or back down. */
    private static CheckInput oneWay() {
        CheckInput input = input(
                machine("original", "Low go -> Mid", "Mid go -> Top", "Top drop -> Low"),
                "Low go -> Mid",
                "Mid go -> Top",
                "Top drop -> Low",
                "Low top -> Top");
        return input.withDevice(
                input.device().withOnFailure(Map.of(new State("Low"), Map.of("top", OnFailure.GO_BACK))));
    }

    @Test
    void aWayBackThatIsMissingIsNamed() {
        assertThat(Check.run(oneWay()))
                .extracting(Finding::message)
                .containsExactly(
                        "if go fails in Mid on the way for Low --top--> Top, no events that can be sent lead back"
                                + " to Low");
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("pairsThatBreakOneRule")
    void aPairThatBreaksOneRuleHasNoOtherFinding(Rule rule, CheckInput input) {
        assertThat(Check.run(input)).extracting(Finding::rule).containsExactly(rule);
    }

    /** Rules about property files and about time, which have their own tests. */
    private static final Set<Rule> JUDGED_ELSEWHERE =
            Set.of(Rule.PROPERTY, Rule.UNKNOWN_PROPERTY, Rule.TIME_DEADLOCK, Rule.TIMER_RACE, Rule.STEP_OUTLIVES_VISIT);

    @ParameterizedTest
    @EnumSource(Rule.class)
    void everyRuleHasAPairThatBreaksItAndIsInTheTable(Rule rule) throws IOException {
        if (!JUDGED_ELSEWHERE.contains(rule)) {
            assertThat(pairsThatBreakOneRule()).anyMatch(arguments -> arguments.get()[0] == rule);
        }
        assertThat(Files.readString(Path.of(System.getProperty("evoloop.root"), "docs", "models.md")))
                .contains(
                        "| `" + rule.id() + "` | " + rule.severity().name().toLowerCase(java.util.Locale.ROOT) + " | ");
    }

    @Test
    void thePapersPairsAreClean() {
        for (CheckInput robot : List.of(robot(), CheckInput.of(PaperModels.cleaningRobot()))) {
            assertThat(Check.run(robot))
                    .extracting(Finding::toString)
                    .containsExactly(
                            "swallowed-event: new state Move swallows Clean, Spot, which the device knows in On;"
                                    + " nothing, if such an event is to do nothing there; otherwise draw a transition"
                                    + " for it");
        }
        assertThat(Check.run(CheckInput.of(PaperModels.lightBulb())
                        .withFunctions(Set.of("wait", "incandescentOn"))
                        .withRaised(Set.of("switch", "timeout"))))
                .isEmpty();
    }

    @Test
    void aMissingPathIsShownByTheEventsThatLeadThere() {
        CheckInput cleanOnly =
                robot().withDevice(new DeviceEvents(Set.of(new Event("Clean")), Set.of(new Event("Spot"))));
        Finding finding = Check.run(cleanOnly).stream()
                .filter(found -> found.rule() == Rule.NO_PATH)
                .findFirst()
                .orElseThrow();
        assertThat(finding.message())
                .isEqualTo(
                        "in (On, Move) event arriveSpot leads to Spot, but with the device in On no events that can be "
                                + "sent take it there (sendable: Clean); the same holds for Clean in (Clean, SpotWait)");
        assertThat(finding.remedy()).isEqualTo("draw a new state with device state On and a transition on Spot");
        assertThat(finding.element()).hasToString("Move --arriveSpot--> Spot");
        assertThat(finding.example())
                .map(turn -> turn + " -> " + turn.decision().after())
                .containsExactly(
                        "Clean -> (On, On)",
                        "Spot -> (Spot, Move)",
                        "endSpot -> (On, Move)",
                        "arriveSpot -> (On, Move)");
    }

    @Test
    void anythingThatTheDeviceDoesByItselfIsAHazardOnlyIfItInterferes() {
        CheckInput withButtons = robot().withDevice(new DeviceEvents(
                Set.of(new Event("Clean"), new Event("Spot")), Set.of(new Event("Clean"), new Event("Spot"))));
        assertThat(Check.run(withButtons)).extracting(Finding::rule).containsOnlyOnce(Rule.HAZARD);
        assertThat(Check.run(withButtons)).first().satisfies(finding -> {
            assertThat(finding.rule()).isEqualTo(Rule.HAZARD);
            assertThat(finding.example())
                    .map(turn -> turn + " -> " + turn.decision().after())
                    .endsWith("Spot (the device acted) -> (Spot, SpotWait)", "timeout -> (Spot, SpotWait)");
        });
    }

    @Test
    void aGuardOfTheDeviceThatCannotBeAskedClosesItsWay() {
        CheckInput input = input(
                machine("original", "Off press [dark] -> On", "On off -> Off"),
                "Off press [dark] -> On",
                "On off -> Off",
                "Off glow -> Warm",
                "Warm up -> On");
        assertThat(Check.run(input)).extracting(Finding::rule).containsExactly(Rule.SWALLOWED_EVENT);
        assertThat(Check.run(input.withGuards(Set.of())))
                .anySatisfy(finding -> assertThat(finding.message())
                        .contains("take it there (sendable: off, press; guards that cannot be asked: dark)"));
    }

    @Test
    void anEventThatWaitsIsNotSwallowed() {
        StateMachine waiting = StateMachine.named("new")
                .initial("Off")
                .transition("Off", "press", "On")
                .transition("On", "press", "Off")
                .transition("On", "dim", "Warm")
                .transition("Warm", "up", "Off")
                .defers("Warm", new Event("press"))
                .build();
        assertThat(Check.run(CheckInput.of(new ModelPair(LAMP, waiting)))).isEmpty();
    }

    @Test
    void aFindingNamesMachineElementAndRemedy() {
        assertThat(Check.run(lampWith("On dim -> Warm"))).singleElement().satisfies(finding -> {
            assertThat(finding)
                    .hasToString(
                            "trap-state: state Warm of the new model cannot be left; draw a transition to another state");
            assertThat(finding.element().side()).isEqualTo(Element.ModelRole.NEW);
        });
    }
}
