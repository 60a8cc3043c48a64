package org.evoloop.learn;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.LongStream;
import org.evoloop.learn.Answer.Reply;
import org.evoloop.learn.LearnedModel.Delay;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelWriter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

class LearningTest {
    private final SteppedClock clock = new SteppedClock();

    @TempDir
    Path directory;

    /** Off, On and Spot, which ends by itself after 45 s. */
    private SimulatedMachine robot() {
        SimulatedMachine robot =
                new SimulatedMachine(clock, List.of("power", "spot", "lift"), List.of("off", "on", "spot"), 1);
        robot.edge(0, "power", 1, true).edge(0, "spot", 0, false).edge(0, "lift", 0, false);
        robot.edge(1, "power", 0, true).edge(1, "spot", 2, true).edge(1, "lift", 0, true);
        robot.edge(2, "power", 1, true).edge(2, "spot", 2, false).edge(2, "lift", 0, true);
        robot.timer(2, Duration.ofSeconds(45), 1);
        return robot;
    }

    private Learning learning(SimulatedMachine device) {
        return Learning.of("learned", device, clock, device.inputs);
    }

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 60);
    }

    static LongStream noisySeeds() {
        return LongStream.rangeClosed(1, 30);
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void aRandomMachineIsLearned(long seed) throws InterruptedException {
        SimulatedMachine device = SimulatedMachine.random(clock, seed, 30);

        LearnedModel model = learning(device).learn();

        assertThat(model.passed()).isTrue();
        assertThat(device.difference(model)).as("seed %d", seed).isEmpty();
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("noisySeeds")
    void lostPressesAreOutvoted(long seed) throws InterruptedException {
        SimulatedMachine device = SimulatedMachine.random(clock, seed, 8);
        device.lost = 0.01;

        LearnedModel model = learning(device).learn();

        assertThat(model.passed()).isTrue();
        assertThat(device.difference(model)).as("seed %d", seed).isEmpty();
    }

    @Test
    void aTimerIsASpontaneousEventWithAnInterval() throws InterruptedException {
        SimulatedMachine robot = robot();

        LearnedModel model = learning(robot).learn();

        Transition end = transition(model, "spot", "turns");
        assertThat(end.target().name()).isEqualTo("on");
        assertThat(model.machine().spontaneous()).contains(end.event());
        Delay delay = model.delays().get(end);
        assertThat(delay).isNotNull();
        assertThat(delay.least()).isLessThanOrEqualTo(Duration.ofSeconds(45));
        assertThat(delay.most()).isBetween(Duration.ofSeconds(45), Duration.ofSeconds(46));
    }

    @Test
    void whatTheDeviceDoesByItselfIsNoInput() throws InterruptedException {
        SimulatedMachine robot = robot();
        robot.act = "power";

        LearnedModel model = learning(robot).learn();

        assertThat(transition(model, "spot", "power-by-itself").target().name()).isEqualTo("on");
        assertThat(model.machine().spontaneous()).hasSize(1);
    }

    private static Transition transition(LearnedModel model, String source, String event) {
        return model.machine().transitions().stream()
                .filter(each -> each.source().name().equals(source)
                        && each.event().name().equals(event))
                .findFirst()
                .orElseThrow();
    }

    @ParameterizedTest
    @EnumSource(ModelWriter.class)
    void theModelFileSaysWhatIsKnown(ModelWriter language) throws Exception {
        LearnedModel model =
                learning(robot()).rules(List.of("never lift in spot")).learn();

        String text = model.write(language);

        StateMachine read = ModelFile.read(
                        language == ModelWriter.MERMAID ? "learned.mmd" : "learned.scxml",
                        new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)))
                .only();
        assertThat(read.transitions())
                .containsExactlyInAnyOrderElementsOf(model.machine().transitions());
        assertThat(read.spontaneous()).isEqualTo(model.machine().spontaneous());
        assertThat(text).contains("Untried: lift in spot: the rule 'never lift in spot' forbids it");
        assertThat(text).containsPattern("off, power, on: seen [1-9][0-9]* times");
        assertThat(text).contains("It passed its test to depth 1");
    }

    @Test
    void whatIsForbiddenIsNotPressed() throws InterruptedException {
        SimulatedMachine robot = robot();

        LearnedModel model = learning(robot)
                .rules(List.of("never lift", "never power in spot"))
                .learn();

        assertThat(robot.log).noneMatch(press -> press.startsWith("lift")).doesNotContain("power in spot");
        assertThat(robot.log).contains("power in on", "spot in spot");
        assertThat(model.untried()).hasSize(4);
        assertThat(model.passed()).isTrue();
    }

    @Test
    void noHourHasMorePressesThanAllowed() throws InterruptedException {
        SimulatedMachine robot = robot();

        LearnedModel model =
                learning(robot).rules(List.of("at most 40 presses an hour")).learn();

        assertThat(model.passed()).isTrue();
        for (int i = 40; i < robot.pressed.size(); i++) {
            assertThat(Duration.between(robot.pressed.get(i - 40), robot.pressed.get(i)))
                    .isGreaterThanOrEqualTo(Duration.ofHours(1));
        }
    }

    @Test
    void aRuleThatIsNoneIsRefused() {
        assertThatThrownBy(() -> learning(robot()).rules(List.of("never lift", "never fly")))
                .isInstanceOf(LearnException.class)
                .hasMessageContaining("safety rule 2, 'never fly', names no input; the inputs are lift, power, spot");
        assertThatThrownBy(() -> learning(robot()).rules(List.of("be careful")))
                .isInstanceOf(LearnException.class)
                .hasMessageContaining("is no rule");
    }

    @Test
    void theBudgetEndsWithTheBestMachineSoFar() throws InterruptedException {
        SimulatedMachine robot = robot();

        LearnedModel model = learning(robot).budget(Duration.ofMinutes(8)).learn();

        assertThat(model.passed()).isFalse();
        assertThat(model.open()).containsExactly("the time that learning may take is over");
        assertThat(model.machine().states()).isNotEmpty();
        assertThat(model.write(ModelWriter.MERMAID)).contains("It did not pass its test.");
    }

    @Test
    void whatIsInTheLogIsNotAskedAgain() throws Exception {
        Path log = directory.resolve("learn.log");
        LearnedModel first = learning(robot()).log(log).learn();
        SimulatedMachine again = robot();

        LearnedModel second = learning(again).log(log).learn();

        assertThat(again.pressed).isEmpty();
        assertThat(second.machine().transitions()).isEqualTo(first.machine().transitions());
        assertThat(second.seen()).isEqualTo(first.seen());
        assertThat(second.delays()).isEqualTo(first.delays());
    }

    @Test
    void aKillAtAnyPlaceCostsOneRunAtMost() throws Exception {
        Path log = directory.resolve("learn.log");
        LearnedModel whole = learning(robot()).log(log).learn();
        byte[] bytes = Files.readAllBytes(log);
        Random random = new Random(54);
        for (int i = 0; i < 40; i++) {
            int length = random.nextInt(bytes.length);
            Files.write(log, Arrays.copyOf(bytes, length));
            long settled = new String(bytes, 0, length, StandardCharsets.US_ASCII)
                    .lines()
                    .filter(line -> line.startsWith("run ") && line.endsWith(" ."))
                    .count();

            LearnedModel resumed = learning(robot()).log(log).learn();

            assertThat(resumed.machine().transitions())
                    .isEqualTo(whole.machine().transitions());
            assertThat(settled + resumed.cost().resets())
                    .as("cut at %d", length)
                    .isLessThanOrEqualTo(whole.cost().resets() + 1L);
        }
    }

    @Test
    void aDamagedLogIsNamed() throws Exception {
        Path log = directory.resolve("learn.log");
        learning(robot()).log(log).learn();
        List<String> lines = new ArrayList<>(Files.readAllLines(log));
        lines.set(4, "run nonsense");
        Files.write(log, lines);

        assertThatThrownBy(() -> learning(robot()).log(log).learn())
                .isInstanceOf(LearnException.class)
                .hasMessageContaining("learn.log, line 5 is damaged");
        assertThatThrownBy(() ->
                        learning(robot()).longest(Duration.ofHours(1)).log(log).learn())
                .isInstanceOf(LearnException.class)
                .hasMessageContaining("learn.log, line 1: it is about");
    }

    @Test
    void aDeviceThatAnswersAtRandomIsNamed() {
        Random random = new Random(1);
        LearnableDevice device = device(() -> random.nextInt(3) == 0 ? "on" : "off");

        assertThatThrownBy(() ->
                        Learning.of("random", device, clock, List.of("a", "b")).learn())
                .isInstanceOf(LearnException.class)
                .hasMessageContaining("at random");
    }

    @Test
    void anUnstableEdgeIsNamedWithBothAnswers() throws InterruptedException {
        // Only the third press of a shows something else, every second time.
        int[] pressed = {0};
        int[] third = {0};
        LearnableDevice device = new LearnableDevice() {
            private Heard heard(Reply reply, String shows) {
                clock.advance(SimulatedMachine.PRESS);
                return new Heard(new Answer(reply, shows), clock.nanoTime());
            }

            @Override
            public Heard reset() throws InterruptedException {
                pressed[0] = 0;
                return heard(Reply.ACCEPTED, "on");
            }

            @Override
            public Heard press(String input) throws InterruptedException {
                boolean odd = input.equals("a") && ++pressed[0] == 3 && third[0]++ % 2 == 0;
                return heard(Reply.ACCEPTED, odd ? "off" : "on");
            }

            @Override
            public Heard await(Duration longest) throws InterruptedException {
                return heard(Reply.WAITED, "on");
            }
        };

        LearnedModel model =
                Learning.of("unstable", device, clock, List.of("a", "b")).learn();

        assertThat(model.passed()).isFalse();
        assertThat(model.open().get(0)).contains("a: 'accepted, shows o").contains("times) and 'accepted, shows o");
    }

    @Test
    void aDeviceThatHangsEndsWithTheBestMachineOrAMessage() throws InterruptedException {
        assertThatThrownBy(() -> hanging(5).learn())
                .isInstanceOf(LearnException.class)
                .hasMessageContaining("nothing was learned after")
                .hasMessageContaining("does not answer");

        LearnedModel model = hanging(20).learn();

        assertThat(model.open()).containsExactly("the lamp does not answer; is it switched on?");
    }

    private Learning hanging(int after) {
        int[] asked = {0};
        LearnableDevice device = device(() -> {
            if (asked[0]++ > after) {
                throw new LearnException("the lamp does not answer; is it switched on?");
            }
            return "on";
        });
        return Learning.of("hanging", device, clock, List.of("a", "b"));
    }

    private LearnableDevice device(Supplier<String> shows) {
        return new LearnableDevice() {
            private Heard heard(Reply reply) {
                clock.advance(SimulatedMachine.PRESS);
                return new Heard(new Answer(reply, shows.get()), clock.nanoTime());
            }

            @Override
            public Heard reset() throws InterruptedException {
                return heard(Reply.ACCEPTED);
            }

            @Override
            public Heard press(String input) throws InterruptedException {
                return heard(Reply.ACCEPTED);
            }

            @Override
            public Heard await(Duration longest) throws InterruptedException {
                return heard(Reply.WAITED);
            }
        };
    }
}
