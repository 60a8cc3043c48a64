package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.LongStream;
import org.evoloop.PaperModels;
import org.evoloop.check.Check;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.Visit;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Random single changes to the new model of the cleaning robot: every mutant that passes the checks can be built, and
 * then no event fails, whatever the controller, the functions and the device do.
 */
class MutationTest {
    private static final int MUTANTS = 200;
    private static final int EVENTS = 300;
    private static final Set<String> SENDABLE = Set.of("Clean", "Spot");

    static LongStream seeds() {
        return LongStream.of(1, new Random().nextLong());
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void whatPassesTheChecksDoesNotFail(long seed) throws InterruptedException {
        Random random = new Random(seed);
        Map<Rule, Integer> counts = new EnumMap<>(Rule.class);
        Map<String, Integer> verdicts = new TreeMap<>();
        for (int number = 0; number < MUTANTS; number++) {
            Mutant mutant = Mutant.of(PaperModels.cleaningRobot().evolved(), random);
            String what = "mutant " + number + " with seed " + seed + ": " + mutant.change();
            ModelPair pair = new ModelPair(PaperModels.cleaningRobot().original(), mutant.machine());
            List<Finding> findings = Check.run(input(pair));
            findings.forEach(finding -> counts.merge(finding.rule(), 1, Integer::sum));
            boolean passes =
                    findings.stream().noneMatch(finding -> finding.rule().severity() == Rule.Severity.ERROR);
            boolean clean = findings.stream().allMatch(finding -> finding.rule().severity() == Rule.Severity.NOTE);
            verdicts.merge(clean ? "clean" : passes ? "warned of" : "refused", 1, Integer::sum);
            assertThat(builds(pair))
                    .as("%s builds if and only if it passes", what)
                    .isEqualTo(passes);
            if (passes) {
                try (Walk walk = new Walk(pair, random)) {
                    walk.events(EVENTS, what);
                }
            }
        }
        System.out.println("seed " + seed + ": " + verdicts + " " + counts);
        assertThat(verdicts).containsKeys("clean", "refused", "warned of");
    }

    private static CheckInput input(ModelPair pair) {
        return CheckInput.of(pair).withOwnEvents(Set.of("endSpot")).withFunctions(newStates(pair));
    }

    private static Set<String> newStates(ModelPair pair) {
        Set<String> names = new HashSet<>();
        pair.evolved().states().stream().filter(pair::isNew).forEach(state -> names.add(state.name()));
        return names;
    }

    private static boolean builds(ModelPair pair) {
        try (Walk built = new Walk(pair, new Random(0))) {
            return built.converter.knowledge().models().equals(pair);
        } catch (ModelException refused) {
            return false;
        }
    }

    /** One change to a machine. */
    private record Mutant(String change, StateMachine machine) {
        static Mutant of(StateMachine machine, Random random) {
            Mutant mutant = null;
            while (mutant == null) {
                try {
                    mutant = attempt(machine, random);
                } catch (ModelException refused) {
                    // Two transitions of a state on the same event: such a model cannot be loaded. Tries another
                    // change.
                    mutant = null;
                }
            }
            return mutant;
        }

        private static Mutant attempt(StateMachine machine, Random random) {
            List<Transition> transitions = new ArrayList<>(machine.transitions());
            List<State> states = List.copyOf(machine.states());
            List<Event> events = List.copyOf(machine.events());
            State initial = machine.initial();
            int index = random.nextInt(transitions.size());
            Transition chosen = transitions.get(index);
            State state = states.get(random.nextInt(states.size()));
            Event event = events.get(random.nextInt(events.size()));
            String change;
            switch (random.nextInt(7)) {
                case 0 -> {
                    transitions.set(index, new Transition(chosen.source(), chosen.event(), state));
                    change = "retarget " + chosen + " to " + state;
                }
                case 1 -> {
                    transitions.remove(index);
                    change = "remove " + chosen;
                }
                case 2 -> {
                    Transition added = new Transition(
                            state,
                            random.nextBoolean() ? event : new Event("extra"),
                            states.get(random.nextInt(states.size())));
                    transitions.add(added);
                    change = "add " + added;
                }
                case 3 -> {
                    transitions.replaceAll(transition -> rename(transition, state, new State("Renamed")));
                    initial = initial.equals(state) ? new State("Renamed") : initial;
                    change = "rename state " + state;
                }
                case 4 -> {
                    transitions.set(index, new Transition(chosen.source(), new Event("renamed"), chosen.target()));
                    change = "rename the event of " + chosen;
                }
                case 5 -> {
                    initial = state;
                    change = "start in " + state;
                }
                default -> {
                    transitions.set(index, new Transition(state, chosen.event(), chosen.target()));
                    change = "let " + chosen + " leave " + state;
                }
            }
            var builder = StateMachine.named("mutant").initial(initial.name());
            transitions.forEach(transition -> builder.transition(transition, ""));
            return new Mutant(change, builder.build());
        }

        private static Transition rename(Transition transition, State from, State to) {
            return new Transition(
                    transition.source().equals(from) ? to : transition.source(),
                    transition.event(),
                    transition.target().equals(from) ? to : transition.target());
        }
    }

    private static final class Panel extends PushMonitor {
        Panel() {
            super("Panel");
        }

        @Override
        protected Set<String> spontaneousEvents() {
            return Set.of("endSpot");
        }

        void ended() {
            push(fromDevice("endSpot"));
        }
    }

    /** A converter without threads, whose device follows the original model exactly. */
    private static final class Walk implements AutoCloseable {
        private final ModelPair pair;
        private final Random random;
        private final Panel panel = new Panel();
        private final SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults("robot", new ManualClock()).withoutThreads());
        private final List<String> raised;
        private State device;
        private @Nullable Visit running;

        Walk(ModelPair pair, Random random) {
            this.pair = pair;
            this.random = random;
            this.device = pair.original().initial();
            Set<String> names = new LinkedHashSet<>();
            pair.evolved().events().forEach(event -> names.add(event.name()));
            names.remove("endSpot");
            this.raised = List.copyOf(names);
            converter.addMonitor(panel);
            converter.addKnowledge(new StateKnowledge(pair) {
                @Override
                protected void registerNewFunctions() {
                    newStates(pair).forEach(name -> function(name, visit -> running = visit));
                }
            });
            converter.addExecute(new EventExecute("Device") {
                @Override
                protected Set<String> sendableEvents() {
                    return SENDABLE;
                }

                @Override
                protected void send(Step step) {
                    device = pair.original().nextState(device, step.trigger()).orElseThrow();
                }
            });
            converter.build();
            converter.start();
        }

        void events(int count, String what) throws InterruptedException {
            for (int event = 0; event < count; event++) {
                String happened = happen();
                converter.observe(panel);
                while (converter.step()) {
                    converter.observe(panel);
                }
                String where = what + ", event " + event + ": " + happened;
                assertThat(converter.status().events().failed()).as(where).isZero();
                assertThat(converter.knowledge().getOriginalState()).as(where).isEqualTo(device);
            }
        }

        private String happen() {
            State ended =
                    pair.original().nextState(device, new Event("endSpot")).orElse(null);
            if (ended != null && random.nextInt(3) == 0) {
                device = ended;
                panel.ended();
                return "endSpot";
            }
            String event = raised.get(random.nextInt(raised.size()));
            Visit visit = running;
            if (visit != null && visit.isActive() && random.nextBoolean()) {
                visit.finish(event);
                return event + " by a function";
            }
            panel.press(event);
            return event;
        }

        @Override
        public void close() {
            converter.close();
        }
    }
}
