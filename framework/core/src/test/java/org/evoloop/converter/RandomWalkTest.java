package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.LongStream;
import org.evoloop.PaperModels;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.Visit;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever happens, however many events wait, and whatever cannot be sent: after every step the knowledge's original
 * state equals the device's. The device follows the original model exactly, and its own buttons are pressed at random.
 */
class RandomWalkTest {
    private static final int STEPS = 2_000;
    private static final List<String> EVENTS = List.of("Clean", "Spot", "arriveSpot", "timeout");
    private static final double FAILURE_RATE = 0.2;

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 9), LongStream.of(new Random().nextLong()));
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void theKnowledgeIsAlwaysWhereTheDeviceIs(long seed) throws InterruptedException {
        try (Walk walk = new Walk(seed)) {
            for (int step = 0; step < STEPS; step++) {
                String what = walk.step();
                assertThat(walk.converter.knowledge().getOriginalState())
                        .as("the original state after step %d (%s) with seed %d", step, what, seed)
                        .isEqualTo(walk.device.state);
            }
            assertThat(walk.converter.status().queue().highest())
                    .as("most events waiting at once, with seed %d", seed)
                    .isGreaterThanOrEqualTo(3);
            ConverterStatus.EventCounts counts = walk.converter.status().events();
            assertThat(List.of(counts.handled(), counts.ignored(), counts.failed()))
                    .as("handled, ignored and failed with seed %d", seed)
                    .allMatch(count -> count > 0);
        }
    }

    private static final class Walk implements AutoCloseable {
        private final ModelPair models = PaperModels.cleaningRobot();
        private final Random random;
        private final ManualClock clock = new ManualClock();
        private final Robot.Panel panel = new Robot.Panel();
        private final Device device = new Device("Device");
        private final SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("robot", clock).withoutThreads());
        private @Nullable Visit moving;
        private int devices;

        Walk(long seed) {
            random = new Random(seed);
            StateKnowledge knowledge = new StateKnowledge(models);
            knowledge.function("Move", visit -> moving = visit);
            knowledge.function("SpotWait", visit -> visit.finishAfter(Duration.ofSeconds(5), "timeout"));
            converter.addMonitor(panel);
            converter.addExecute(device.component());
            converter.addKnowledge(knowledge);
            converter.build();
            converter.start();
        }

        /**
         * Does something at random and lets the converter process some of the waiting events; returns what was done.
         */
        String step() throws InterruptedException {
            String what = act();
            converter.observe(panel);
            for (int turns = random.nextInt(3); turns > 0 && converter.step(); turns--) {
                converter.observe(panel);
            }
            return what;
        }

        private String act() {
            return switch (random.nextInt(10)) {
                case 0, 1, 2 -> {
                    String event = EVENTS.get(random.nextInt(EVENTS.size()));
                    panel.press(event);
                    yield "controller " + event;
                }
                case 3 -> {
                    String event = random.nextBoolean() ? "Clean" : "Spot";
                    panel.pressed(event, false);
                    yield "panel reports " + event;
                }
                case 4, 5 -> deviceActs(random.nextBoolean() ? "Clean" : "Spot");
                case 6 -> deviceActs("endSpot");
                case 7 -> arrive();
                case 8 -> {
                    Duration passing = Duration.ofMillis(random.nextInt(6_000));
                    clock.advance(passing);
                    yield passing + " pass";
                }
                default -> change();
            };
        }

        private String deviceActs(String name) {
            Event event = new Event(name);
            if (!models.original().hasTransition(device.state, event)) {
                return "the device cannot " + name;
            }
            device.take(event);
            if (name.equals("endSpot")) {
                panel.ended(name);
            } else {
                panel.pressed(name, true);
            }
            return "the device does " + name;
        }

        private String arrive() {
            Visit visit = moving;
            if (visit != null) {
                visit.finish("arriveSpot");
            }
            return "Move arrives";
        }

        private String change() {
            if (random.nextBoolean()) {
                converter.stop();
                converter.start();
                return "stop and start";
            }
            String present = "Device" + (devices == 0 ? "" : devices);
            devices++;
            converter.exchange(present, device.component());
            return "exchange";
        }

        @Override
        public void close() {
            converter.close();
        }

        /** The device's true state, whichever component sends to it. */
        private final class Device {
            private final String name;
            private State state = models.original().initial();

            Device(String name) {
                this.name = name;
            }

            void take(Event event) {
                state = models.original().nextState(state, event).orElseThrow();
            }

            EventExecute component() {
                return new EventExecute(name + (devices == 0 ? "" : devices)) {
                    @Override
                    protected Set<String> sendableEvents() {
                        return Set.of("Clean", "Spot");
                    }

                    @Override
                    protected void send(Step step) throws IOException {
                        if (random.nextDouble() < FAILURE_RATE) {
                            throw new IOException("lost");
                        }
                        take(step.event());
                    }
                };
            }
        }
    }
}
