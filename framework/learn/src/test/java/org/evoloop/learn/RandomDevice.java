package org.evoloop.learn;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.evoloop.time.ManualClock;

/** A random machine that is played under a manual clock; a third of them have timers. It shows one of three classes. */
final class RandomDevice implements LearnedDevice {
    static final Duration PRESS = Duration.ofSeconds(3);
    static final Duration RESET = Duration.ofSeconds(5);

    final List<String> inputs;
    final int[][] next;
    /** How long each state lasts, in seconds; 0 for ever. */
    final int[] lasts;

    final int[] then;
    final ManualClock clock;
    final List<String> sent = new ArrayList<>();
    private UnaryOperator<Heard> noise = heard -> heard;
    private int state;
    int resets;

    private RandomDevice(Random random, int size, int events, boolean timed, ManualClock clock) {
        this.clock = clock;
        inputs = new ArrayList<>();
        for (int i = 0; i < events; i++) {
            inputs.add("e" + i);
        }
        next = new int[size][events];
        lasts = new int[size];
        then = new int[size];
        for (int i = 0; i < size; i++) {
            for (int k = 0; k < events; k++) {
                next[i][k] = random.nextInt(size);
            }
            if (timed && random.nextInt(3) == 0) {
                lasts[i] = 10 + random.nextInt(40);
                then[i] = random.nextInt(size);
            }
        }
    }

    /** A machine of which every state can be reached, and differs from the others. */
    static RandomDevice of(long seed, ManualClock clock) {
        Random random = new Random(seed * 0x9E3779B97F4A7C15L);
        int size = 4 + random.nextInt(27);
        int events = 3 + random.nextInt(4);
        while (true) {
            RandomDevice device = new RandomDevice(random, size, events, seed % 3 == 0, clock);
            if (device.isMinimal()) {
                return device;
            }
        }
    }

    RandomDevice withNoise(UnaryOperator<Heard> change) {
        noise = change;
        return this;
    }

    String shown(int of) {
        return "class" + of % 3;
    }

    private boolean isMinimal() {
        Set<Integer> reached = new HashSet<>(Set.of(0));
        List<Integer> open = new ArrayList<>(reached);
        for (int i = 0; i < open.size(); i++) {
            for (int target : next[open.get(i)]) {
                if (reached.add(target)) {
                    open.add(target);
                }
            }
            if (lasts[open.get(i)] > 0 && reached.add(then[open.get(i)])) {
                open.add(then[open.get(i)]);
            }
        }
        int[] block = new int[next.length];
        for (int round = 0; round < next.length; round++) {
            Map<List<Object>, Integer> blocks = new HashMap<>();
            int[] refined = new int[next.length];
            for (int i = 0; i < next.length; i++) {
                List<Object> signature = new ArrayList<>(List.of(block[i], lasts[i] > 0));
                for (int target : next[i]) {
                    signature.add(block[target]);
                    signature.add(shown(target));
                }
                signature.add(lasts[i] > 0 ? block[then[i]] + shown(then[i]) : "");
                refined[i] = blocks.computeIfAbsent(signature, none -> blocks.size());
            }
            block = refined;
        }
        return reached.size() == next.length
                && java.util.Arrays.stream(block).distinct().count() == next.length;
    }

    @Override
    public Heard reset() {
        resets++;
        clock.advance(RESET);
        state = 0;
        return Heard.accepted(shown(state));
    }

    @Override
    public Heard press(String event) {
        sent.add(event);
        clock.advance(PRESS);
        state = next[state][inputs.indexOf(event)];
        return noise.apply(Heard.accepted(shown(state)));
    }

    @Override
    public Heard await(Duration longest) {
        if (lasts[state] == 0 || lasts[state] > longest.toSeconds()) {
            clock.advance(longest);
            return noise.apply(Heard.silent(shown(state)));
        }
        Duration lasted = Duration.ofSeconds(lasts[state]);
        clock.advance(lasted);
        state = then[state];
        return noise.apply(new Heard(Heard.Reply.ACCEPTED, List.of(), shown(state), lasted));
    }

    @Override
    public int sent() {
        return sent.size();
    }

    /** What differs between this machine and a learned one, by walking both together; empty if they are equal. */
    String differs(Learned learned) {
        Map<String, Learned.Arrow> edges = new HashMap<>();
        learned.edges().forEach(edge -> edges.put(edge.source() + " " + edge.input(), edge));
        Map<Integer, String> pairs = new HashMap<>();
        pairs.put(0, learned.states().get(0));
        List<Integer> open = new ArrayList<>(List.of(0));
        for (int i = 0; i < open.size(); i++) {
            int at = open.get(i);
            for (int k = 0; k <= inputs.size(); k++) {
                boolean waits = k == inputs.size();
                Learned.Arrow edge = edges.get(pairs.get(at) + " " + (waits ? WAIT : inputs.get(k)));
                if (edge == null) {
                    return "nothing for input " + k + " in " + pairs.get(at);
                }
                if (waits && lasts[at] == 0) {
                    if (edge.heard().reply() != Heard.Reply.SILENT) {
                        return at + " does nothing, and learned is " + edge;
                    }
                    continue;
                }
                int target = waits ? then[at] : next[at][k];
                if (!edge.heard().shown().equals(shown(target))) {
                    return "state " + at + " shows " + shown(target) + " next, and learned is " + edge;
                }
                if (waits && !edge.soonest().equals(Duration.ofSeconds(lasts[at]))) {
                    return "state " + at + " lasts " + lasts[at] + " s, and learned is " + edge;
                }
                String known = pairs.putIfAbsent(target, edge.target());
                if (known == null) {
                    open.add(target);
                } else if (!known.equals(edge.target())) {
                    return "state " + target + " is both " + known + " and " + edge.target();
                }
            }
        }
        return learned.states().size() == next.length ? "" : "there are " + next.length + " states";
    }
}
