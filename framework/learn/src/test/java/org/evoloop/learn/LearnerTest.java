package org.evoloop.learn;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LearnerTest {
    private static final Duration MINUTE = Duration.ofMinutes(1);
    private static final LearnSettings SETTINGS = new LearnSettings(MINUTE, Duration.ofDays(3_650), 1);
    private static final LearnProgress QUIET = (soFar, expected) -> {};
    /** A small machine without timers. */
    private static final long SMALL = 8;

    @TempDir
    private Path folder;

    private final ManualClock clock = new ManualClock();

    /** Off and On; a third of an hour in On ends it; {@code jam} is refused. */
    private class Lamp implements LearnedDevice {
        String state = "Off";
        int presses;

        @Override
        public Heard reset() throws InterruptedException {
            clock.advance(Duration.ofSeconds(5));
            state = "Off";
            return Heard.accepted(state);
        }

        @Override
        public int sent() {
            return presses;
        }

        @Override
        public Heard press(String event) throws InterruptedException {
            presses++;
            clock.advance(Duration.ofSeconds(1));
            if (event.equals("jam")) {
                return new Heard(Heard.Reply.REFUSED, List.of(), state, Duration.ZERO);
            }
            state = state.equals("Off") ? "On" : "Off";
            return Heard.accepted(state);
        }

        @Override
        public Heard await(Duration longest) throws InterruptedException {
            clock.advance(Duration.ofSeconds(20));
            if (state.equals("Off")) {
                return Heard.silent(state);
            }
            state = "Off";
            return new Heard(Heard.Reply.ACCEPTED, List.of(), state, Duration.ofSeconds(20));
        }
    }

    private Learned learn(LearnedDevice device, LearnRules rules, LearnSettings settings, String... events) {
        return new Learner(device, List.of(events), rules, settings, clock, null, null, QUIET).learn();
    }

    /** The lamp as somebody has drawn it. */
    private static StateMachineBuilder drawn() {
        return StateMachine.named("lamp")
                .initial("Off")
                .transition("Off", "power", "On")
                .transition("On", "after 20 s", "Off");
    }

    private Learned test(LearnedDevice device, StateMachine first, String... events) {
        return new Learner(device, List.of(events), LearnRules.NONE, SETTINGS, clock, first, null, QUIET).learn();
    }

    @Test
    void aDeclaredModelIsTestedWithFewPresses() {
        StateMachine declared = drawn().transition("On", "power", "Off").build();
        Lamp tested = new Lamp();

        Learned learned = test(tested, declared, "power", "jam");

        assertThat(learned.isTested()).isTrue();
        assertThat(learned.depth()).isZero();
        assertThat(learned.model("lamp").transitions()).hasSameElementsAs(declared.transitions());
        assertThat(learned.differences(declared, SETTINGS.longest())).isEmpty();
        Lamp alone = new Lamp();
        learn(alone, LearnRules.NONE, SETTINGS, "power", "jam");
        assertThat(tested.presses).isLessThan(alone.presses);
    }

    @Test
    void whereADeclaredModelIsWrongTheDeviceIsLearnedAndTheDifferenceIsNamed() {
        StateMachine declared = drawn().transition("On", "power", "On")
                .transition("Off", "jam", "On")
                .build();

        Learned learned = test(new Lamp(), declared, "power", "jam");

        assertThat(learned.isTested()).isTrue();
        assertThat(learned.depth()).isEqualTo(1);
        assertThat(learned.model("lamp").nextState(new State("On"), new Event("power")))
                .contains(new State("Off"));
        assertThat(learned.differences(declared, SETTINGS.longest()))
                .containsExactlyInAnyOrder(
                        "Off --jam--> On is declared, and was refused",
                        "On --power--> On is declared, and On --power--> Off was seen");
        assertThat(learned.differences(drawn().build(), SETTINGS.longest()))
                .containsExactly("On --power--> Off is not declared");
    }

    private static Learned learn(RandomDevice device, AnswerLog log) {
        return new Learner(device, device.inputs, LearnRules.NONE, SETTINGS, device.clock, null, log, QUIET).learn();
    }

    @Test
    void theModelHasTheDevicesNamesItsTimerAndNothingThatIsRefused() {
        Learned learned = learn(new Lamp(), LearnRules.NONE, SETTINGS, "power", "jam");

        StateMachine model = learned.model("lamp");
        assertThat(learned.isTested()).isTrue();
        assertThat(learned.states()).containsExactly("Off", "On");
        assertThat(model.transitions())
                .extracting(Object::toString)
                .containsExactlyInAnyOrder("Off --power--> On", "On --power--> Off", "On --after 20 s--> Off");
        assertThat(learned.edges())
                .extracting(Learned.Arrow::toString)
                .anyMatch(line -> line.matches("On --after 20 s--> Off: seen .*, after 20.0 to 20.0 s"))
                .anyMatch(line -> line.startsWith("Off --jam--> Off: refused, seen "))
                .anyMatch(line -> line.startsWith("Off: does nothing by itself, seen "));
    }

    @Test
    void whatARuleForbidsIsNeverSentAndIsNamed() {
        Lamp lamp = new Lamp() {
            @Override
            public Heard press(String event) throws InterruptedException {
                assertThat(event).isNotEqualTo("jam");
                assertThat(event + state).isNotEqualTo("resetOn");
                return super.press(event);
            }
        };
        LearnRules rules =
                new LearnRules(Set.of("jam"), Map.of("On", Set.of("reset")), Integer.MAX_VALUE, List.of(), null);

        Learned learned = learn(lamp, rules, SETTINGS, "power", "jam", "reset");

        assertThat(learned.open()).isEmpty();
        assertThat(learned.edges())
                .extracting(Learned.Arrow::toString)
                .contains("On --reset-->: not tried, a rule forbids it");
        assertThat(learned.remarks())
                .containsExactly("jam was not tried: a rule forbids it", "On --reset-->: not tried, a rule forbids it");
        assertThat(learned.isTested()).isFalse();
    }

    @Test
    void howeverItEndsTheDeviceIsLeftWhereEveryWordBegins() {
        Lamp stopped = new Lamp() {
            @Override
            public Heard press(String event) throws InterruptedException {
                if (sent() == 3) {
                    Thread.currentThread().interrupt();
                }
                return super.press(event);
            }
        };
        assertThat(learn(stopped, LearnRules.NONE, SETTINGS, "power").open()).isEqualTo("it was stopped");
        assertThat(Thread.interrupted()).isTrue();
        assertThat(stopped.state).isEqualTo("Off");

        Lamp done = new Lamp();
        assertThat(learn(done, LearnRules.NONE, SETTINGS, "power").isTested()).isTrue();
        assertThat(done.state).isEqualTo("Off");
    }

    @Test
    void itSendsNoMoreInAnHourAndOnlyInTheHoursThatTheRulesAllow() {
        Lamp lamp = new Lamp() {
            @Override
            public Heard press(String event) throws InterruptedException {
                LocalTime now = LocalTime.ofInstant(clock.wallTime(), ZoneOffset.UTC);
                assertThat(now).isBetween(LocalTime.of(8, 0), LocalTime.of(18, 1));
                return super.press(event);
            }
        };
        Instant begin = clock.wallTime();
        LearnRules rules = new LearnRules(
                Set.of(),
                Map.of(),
                6,
                List.of(),
                new LearnRules.Hours(LocalTime.of(8, 0), LocalTime.of(18, 0), ZoneOffset.UTC));

        Thread time = new Thread(() -> {
            while (!Thread.currentThread().isInterrupted()) {
                clock.untilNext().ifPresentOrElse(clock::advance, Thread::onSpinWait);
            }
        });
        time.start();
        Learned learned = learn(lamp, rules, SETTINGS, "power");
        time.interrupt();

        assertThat(learned.open()).isEmpty();
        long hours = Duration.between(begin, clock.wallTime()).toHours();
        assertThat(lamp.presses).isLessThanOrEqualTo((int) (6 * (hours + 1)));
    }

    @Test
    void aReadingAboveItsLimitEndsIt() {
        Lamp hot = new Lamp() {
            @Override
            public Map<String, Double> readings() {
                return Map.of("temperature", 20.0 + 5 * presses);
            }
        };
        LearnRules rules = new LearnRules(
                Set.of(), Map.of(), Integer.MAX_VALUE, List.of(new LearnRules.Stop("temperature", 40)), null);

        Learned learned = learn(hot, rules, SETTINGS, "power");

        assertThat(learned.open()).isEqualTo("a rule of the file ended it: temperature is 45.0, above 40.0");
        assertThat(hot.state).isEqualTo("Off");
        assertThat(learned.isTested()).isFalse();
    }

    @Test
    void theBudgetEndsItWithTheBestMachineSoFar() {
        RandomDevice device = RandomDevice.of(SMALL, clock);
        LearnSettings short1 = new LearnSettings(MINUTE, Duration.ofHours(1), 1);

        Learned learned = new Learner(device, device.inputs, LearnRules.NONE, short1, clock, null, null, QUIET).learn();

        assertThat(learned.open()).isEqualTo("the budget is spent");
        assertThat(learned.took()).isLessThan(Duration.ofMinutes(70));
    }

    @Test
    void aWordIsRepeatedIfAPersonActsInBetweenButNotForEver() {
        Random random = new Random(1);
        Lamp touched = new Lamp() {
            @Override
            public Heard press(String event) throws InterruptedException {
                if (random.nextInt(5) == 0) {
                    throw new DisturbedException("somebody pressed power");
                }
                return super.press(event);
            }
        };
        assertThat(learn(touched, LearnRules.NONE, SETTINGS, "power").states()).containsExactly("Off", "On");

        Lamp never = new Lamp() {
            @Override
            public Heard press(String event) {
                throw new DisturbedException("somebody pressed power");
            }
        };
        assertThat(learn(never, LearnRules.NONE, SETTINGS, "power").open())
                .isEqualTo("the device is never left alone: somebody pressed power");
    }

    @Test
    void aDeviceThatHangsEndsItWithAMessage() {
        Lamp hangs = new Lamp() {
            @Override
            public Heard press(String event) throws InterruptedException {
                if (presses == 5) {
                    throw new LostException("the device does not answer; switch it off and on");
                }
                return super.press(event);
            }
        };

        Learned learned = learn(hangs, LearnRules.NONE, SETTINGS, "power", "jam");

        assertThat(learned.open()).isEqualTo("the device does not answer; switch it off and on");
    }

    @Test
    void randomAnswersEndItWithTheEdgeThatIsUnstable() {
        Random random = new Random(1);
        RandomDevice device =
                RandomDevice.of(SMALL, clock).withNoise(heard -> Heard.accepted("class" + random.nextInt(3)));

        Learned learned = learn(device, null);

        assertThat(learned.open()).contains("unstable: after ", "answered by");
        assertThat(device.resets).isLessThan(1000);
    }

    @Test
    void aDeviceThatChangesEndsItWithWhatChanged() {
        Lamp changes = new Lamp() {
            @Override
            public Heard press(String event) throws InterruptedException {
                Heard heard = super.press(event);
                return presses > 12 && state.equals("On") ? Heard.accepted("Dim") : heard;
            }
        };

        Learned learned = learn(changes, LearnRules.NONE, SETTINGS, "power", "jam");

        assertThat(learned.open())
                .startsWith("the device has changed while it was learned, or is unstable: after ")
                .contains("power was answered by 'On'", "and now by 'Dim'");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void rareNoiseIsVotedDown(long seed) {
        Random random = new Random(seed);
        RandomDevice device = RandomDevice.of(SMALL, clock)
                .withNoise(heard -> random.nextInt(300) == 0
                        ? new Heard(heard.reply(), heard.acts(), "class" + random.nextInt(3), heard.after())
                        : heard);

        Learned learned = learn(device, null);

        assertThat(learned.open()).isEmpty();
        assertThat(device.differs(learned)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 10, 25, 60, 100, 150})
    void killedAtAnyTimeItGoesOnWhereItWas(int kill) throws IOException {
        RandomDevice whole = RandomDevice.of(SMALL, new ManualClock());
        Learned once = learn(whole, null);
        Path file = folder.resolve("answers.log");
        int asked = 0;
        Learned learned = null;
        for (int run = 0; learned == null; run++) {
            RandomDevice device = RandomDevice.of(SMALL, new ManualClock());
            int limit = run == 0 ? kill : Integer.MAX_VALUE;
            try (AnswerLog log = AnswerLog.open(file, "lamp")) {
                learned = learn(
                        device.withNoise(heard -> {
                            if (device.sent.size() > limit) {
                                throw new IllegalStateException("killed");
                            }
                            return heard;
                        }),
                        log);
            } catch (IllegalStateException killed) {
                // A process that is killed while it writes leaves half a line.
                Files.writeString(file, "class0\te0\tACC", StandardCharsets.UTF_8, StandardOpenOption.APPEND);
            }
            asked += device.resets;
        }

        assertThat(learned.states()).isEqualTo(once.states());
        assertThat(whole.differs(learned)).isEmpty();
        assertThat(asked).isLessThanOrEqualTo(whole.resets + 1);
    }

    @Test
    void aLogIsForOneDeviceAndOneProcess() throws IOException {
        Path file = folder.resolve("answers.log");
        try (AnswerLog open = AnswerLog.open(file, "lamp")) {
            assertThat(open).isNotNull();
            assertThatThrownBy(() -> AnswerLog.open(file, "lamp")).hasMessageContaining("in use");
        }
        assertThatThrownBy(() -> AnswerLog.open(file, "fan"))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("answers.log:1")
                .hasMessageContaining("fan");
        Files.writeString(file, "some\tthing\n", StandardOpenOption.APPEND);
        assertThatThrownBy(() -> AnswerLog.open(file, "lamp")).hasMessageContaining("answers.log:2");
    }
}
