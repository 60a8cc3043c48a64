package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.evoloop.PaperPair;
import org.evoloop.RoombaPair;
import org.evoloop.learn.LearnRules;
import org.evoloop.learn.LearnSettings;
import org.evoloop.learn.Learned;
import org.evoloop.learn.Learner;
import org.evoloop.statechart.FlatDrawing;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.ModelWriter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The simulated robot is learned by its buttons, and compared with its drawn models. */
class LearnedRoombaTest {
    private static final List<String> BUTTONS = List.of("Clean", "Spot", "Dock");
    private static final String END_SPOT = "endSpot";
    private static final Duration SPOT = Duration.ofSeconds(45);
    private static final Path MODEL = Path.of(System.getProperty("evoloop.root"), "models", "roomba-learned.mmd");

    private static Learned learn(List<String> buttons, double lost, long seed) {
        try (ButtonedRoomba robot = new ButtonedRoomba(lost, seed)) {
            return new Learner(
                            robot,
                            buttons,
                            LearnRules.NONE,
                            new LearnSettings(Duration.ofSeconds(60), Duration.ofDays(1), 1),
                            robot.clock,
                            null,
                            null,
                            (soFar, expected) -> {})
                    .learn();
        }
    }

    /** With the names that its owner would choose in place of what the robot shows. */
    private static Learned named(Learned learned) {
        StateMachine shown = learned.model("shown");
        String off = shown.initial().name();
        String on = after(shown, off, "Clean");
        Map<String, String> names = new LinkedHashMap<>(Map.of(off, "Off", on, "On"));
        for (String work : BUTTONS) {
            names.putIfAbsent(after(shown, on, work), work);
        }
        return new Learned(
                learned.states().stream().map(names::get).toList(),
                learned.edges().stream()
                        .map(edge -> new Learned.Arrow(
                                names.getOrDefault(edge.source(), edge.source()),
                                edge.input(),
                                names.getOrDefault(edge.target(), edge.target()),
                                edge.heard(),
                                edge.seen(),
                                edge.soonest(),
                                edge.latest()))
                        .toList(),
                learned.depth(),
                learned.words(),
                learned.took(),
                learned.open(),
                learned.remarks());
    }

    private static String after(StateMachine machine, String state, String event) {
        return machine.nextState(new State(state), new Event(event))
                .map(State::name)
                .orElse(state);
    }

    /** What of a model buttons reach, and the end of a spot cleaning; without what changes nothing. */
    private static Set<String> reached(StateMachine machine, List<String> buttons) {
        Set<String> transitions = new TreeSet<>();
        Set<State> seen = new LinkedHashSet<>(Set.of(machine.initial()));
        Deque<State> waiting = new ArrayDeque<>(seen);
        while (!waiting.isEmpty()) {
            for (Transition transition : machine.transitionsFrom(waiting.remove())) {
                String event = transition.event().timeTrigger().isPresent()
                        ? END_SPOT
                        : transition.event().name();
                if (buttons.contains(event) || event.equals(END_SPOT)) {
                    transitions.add(transition.source() + " --" + event + "--> " + transition.target());
                    if (seen.add(transition.target())) {
                        waiting.add(transition.target());
                    }
                }
            }
        }
        return transitions;
    }

    private static Set<String> learnedTransitions(Learned learned, List<String> buttons) {
        return reached(named(learned).model("learned"), buttons);
    }

    @Test
    void itIsTheDrawnRobotAndThePapersModelLacksThreeTransitions() {
        List<String> buttons = List.of("Clean", "Spot");
        Learned learned = learn(buttons, 0, 1);

        assertThat(learned.isTested()).isTrue();
        Set<String> transitions = learnedTransitions(learned, buttons);
        assertThat(transitions).isEqualTo(reached(RoombaPair.of("home").original(), buttons));
        transitions.removeAll(reached(PaperPair.cleaningRobot().original(), buttons));
        assertThat(transitions)
                .containsExactlyInAnyOrder("Clean --Spot--> On", "Spot --Clean--> On", "Spot --Spot--> On");
    }

    @Test
    void theModelFileIsWhatIsLearnedWithDock() throws IOException {
        Learned learned = named(learn(BUTTONS, 0, 1));

        assertThat(learnedTransitions(learned, BUTTONS))
                .isEqualTo(reached(RoombaPair.of("home").original(), BUTTONS));
        assertThat(learned.edges())
                .filteredOn(edge -> !edge.latest().isZero())
                .singleElement()
                .satisfies(edge -> {
                    assertThat(edge.source()).isEqualTo("Spot");
                    // A frame shows what was so for 15 ms.
                    assertThat(edge.soonest().minusMillis(15)).isLessThanOrEqualTo(SPOT);
                    assertThat(edge.latest().plusMillis(15)).isGreaterThanOrEqualTo(SPOT);
                    assertThat(edge.latest().minus(edge.soonest())).isLessThan(Duration.ofMillis(100));
                });
        String written = ModelWriter.MERMAID.write(FlatDrawing.of(learned.model("learned")))
                + learned.edges().stream().map(edge -> "%% " + edge + "\n").collect(Collectors.joining());
        assertThat(Files.readString(MODEL)).isEqualTo(written);
    }

    /** The same machine, or something that is named. */
    private static void learnedOverALossyLine(double lost, long seed) {
        List<String> buttons = List.of("Clean", "Spot");
        Learned learned = learn(buttons, lost, seed);
        if (learned.open().isEmpty()) {
            assertThat(learnedTransitions(learned, buttons))
                    .as("%s lost, seed %d", lost, seed)
                    .isEqualTo(reached(RoombaPair.of("home").original(), buttons));
        } else {
            assertThat(learned.open()).as("%s lost, seed %d", lost, seed).contains("unstable");
        }
    }

    @Test
    void lostBytesAreOutvoted() {
        learnedOverALossyLine(0.003, 17);
        learnedOverALossyLine(0.01, 4);
    }

    @Test
    @Tag("slow")
    void lostBytesAreOutvotedFiftyTimes() {
        LongStream.rangeClosed(1, 50).forEach(seed -> learnedOverALossyLine(0.003, seed));
        LongStream.rangeClosed(1, 50).forEach(seed -> learnedOverALossyLine(0.01, seed));
    }
}
