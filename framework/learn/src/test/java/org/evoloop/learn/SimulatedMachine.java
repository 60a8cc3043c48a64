package org.evoloop.learn;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import org.evoloop.learn.Answer.Reply;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/** A device with a machine, whose states look like one of a few classes; it may lose presses. */
final class SimulatedMachine implements LearnableDevice {
    static final Duration PRESS = Duration.ofMillis(500);
    private static final Duration RESET = Duration.ofSeconds(2);

    /** @param target state, and whether the press is taken */
    record Edge(int target, boolean taken) {}

    /** @param target state after the time */
    record Timer(Duration after, int target) {}

    final List<String> inputs;
    final List<String> shown;
    final List<Map<String, Edge>> edges = new ArrayList<>();
    final Map<Integer, Timer> timers = new TreeMap<>();
    final List<String> log = new ArrayList<>();
    final List<Instant> pressed = new ArrayList<>();
    private final SteppedClock clock;
    private final Random noise;
    double lost;
    /** What it is said to do when a timer ends. */
    String act = "turns";

    private int state;
    private long enteredNanos;

    SimulatedMachine(SteppedClock clock, List<String> inputs, List<String> shown, long seed) {
        this.clock = clock;
        this.inputs = inputs;
        this.shown = shown;
        this.noise = new Random(seed);
        shown.forEach(each -> edges.add(new TreeMap<>()));
    }

    /** A random one; a third of them have timers. */
    static SimulatedMachine random(SteppedClock clock, long seed, int mostStates) {
        Random random = new Random(seed);
        int states = 4 + random.nextInt(mostStates - 3);
        List<String> inputs = List.of("a", "b", "c", "d", "e", "f").subList(0, 3 + random.nextInt(4));
        List<String> shown = new ArrayList<>();
        for (int i = 0; i < states; i++) {
            shown.add(List.of("rests", "drives", "brushes").get(random.nextInt(3)));
        }
        SimulatedMachine machine = new SimulatedMachine(clock, inputs, shown, seed);
        for (int from = 0; from < states; from++) {
            for (String input : inputs) {
                boolean taken = random.nextInt(4) > 0;
                machine.edge(from, input, taken ? random.nextInt(states) : from, taken);
            }
            if (seed % 3 == 0 && random.nextInt(3) == 0) {
                machine.timer(from, Duration.ofSeconds(30 + random.nextInt(20)), random.nextInt(states));
            }
        }
        return machine;
    }

    SimulatedMachine edge(int from, String input, int to, boolean taken) {
        edges.get(from).put(input, new Edge(to, taken));
        return this;
    }

    void timer(int from, Duration after, int to) {
        timers.put(from, new Timer(after, to));
    }

    private void enter(int next) {
        state = next;
        enteredNanos = clock.nanoTime();
    }

    private Heard heard(Reply reply, List<String> acts, long first) {
        return new Heard(new Answer(reply, acts, shown.get(state)), first);
    }

    @Override
    public Heard reset() throws InterruptedException {
        pressed.add(clock.wallTime());
        clock.advance(RESET);
        enter(0);
        return heard(Reply.ACCEPTED, List.of(), clock.nanoTime());
    }

    @Override
    public Heard press(String input) throws InterruptedException {
        pressed.add(clock.wallTime());
        log.add(input + " in " + shown.get(state));
        Edge edge = edges.get(state).get(input);
        boolean heeded = noise.nextDouble() >= lost;
        if (edge.taken() && heeded) {
            enter(edge.target());
        }
        long first = clock.nanoTime();
        clock.advance(PRESS);
        return heard(edge.taken() && heeded ? Reply.ACCEPTED : Reply.UNANSWERED, List.of(), first);
    }

    @Override
    public Heard await(Duration longest) throws InterruptedException {
        Timer timer = timers.get(state);
        long due = timer == null ? Long.MAX_VALUE : enteredNanos + timer.after().toNanos() - clock.nanoTime();
        if (timer == null || due > longest.toNanos()) {
            clock.advance(longest);
            return heard(Reply.WAITED, List.of(), clock.nanoTime());
        }
        clock.advance(Duration.ofNanos(Math.max(0, due)));
        long first = clock.nanoTime();
        enter(timer.target());
        clock.advance(PRESS);
        return heard(Reply.WAITED, List.of(act), first);
    }

    /** What tells this machine from a learned one: inputs after which they differ; empty if they are the same. */
    Optional<String> difference(LearnedModel model) {
        StateMachine learned = model.machine();
        record Pair(int mine, State theirs, String way) {}
        Deque<Pair> next = new ArrayDeque<>(List.of(new Pair(0, learned.initial(), "")));
        Set<List<Object>> visited = new HashSet<>();
        while (!next.isEmpty()) {
            Pair pair = next.remove();
            if (!visited.add(List.of(pair.mine, pair.theirs))) {
                continue;
            }
            if (!pair.theirs.name().replaceAll("-[0-9]+$", "").equals(shown.get(pair.mine))) {
                return Optional.of("after" + pair.way + " it is " + shown.get(pair.mine) + ", not " + pair.theirs);
            }
            Map<String, Edge> all = new HashMap<>(edges.get(pair.mine));
            Timer timer = timers.get(pair.mine);
            all.put("turns", timer == null ? new Edge(pair.mine, false) : new Edge(timer.target(), true));
            for (Map.Entry<String, Edge> edge : all.entrySet()) {
                Optional<State> target = learned.nextState(pair.theirs, new Event(edge.getKey()));
                if (target.isPresent() != edge.getValue().taken()) {
                    return Optional.of("after" + pair.way + ", " + edge.getKey());
                }
                target.ifPresent(
                        state -> next.add(new Pair(edge.getValue().target(), state, pair.way + " " + edge.getKey())));
            }
        }
        return Optional.empty();
    }
}
