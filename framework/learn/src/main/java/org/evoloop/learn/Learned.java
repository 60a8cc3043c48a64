package org.evoloop.learn;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.learn.AnswerTree.Edge;
import org.evoloop.learn.AnswerTree.Node;
import org.evoloop.learn.Heard.Reply;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.jspecify.annotations.Nullable;

/**
 * What was learned of a device. It says what was seen, and claims no more.
 *
 * <p>Threading: immutable.
 *
 * @param states their names; the first is where the device is after a reset
 * @param edges what was answered in each state
 * @param depth how many states more than these the test looked for
 * @param words how many words the device was given
 * @param took the device's time
 * @param open why it did not come to its end; empty if it passed its test
 * @param remarks what a person should look at
 * @since 0.1
 */
public record Learned(
        List<String> states,
        List<Arrow> edges,
        int depth,
        int words,
        Duration took,
        String open,
        List<String> remarks) {
    /** Two observations of a timer are the same if they differ by no more than this part. */
    private static final int TIMERS_DIFFER = 10;

    private static final Duration SECOND = Duration.ofSeconds(1);

    /**
     * An answer in a state.
     *
     * @param source the state
     * @param input the event; {@link LearnedDevice#WAIT} for what the device does by itself
     * @param target the state to which it leads
     * @param heard the answer
     * @param seen how often
     * @param soonest after what time, at least, for what the device does by itself
     * @param latest after what time, at most
     */
    public record Arrow(
            String source, String input, String target, Heard heard, int seen, Duration soonest, Duration latest) {
        /** As a line of text. */
        @Override
        public String toString() {
            return switch (heard.reply()) {
                case FORBIDDEN -> source + " --" + input + "-->: not tried, a rule forbids it";
                case SILENT -> source + ": does nothing by itself, seen " + times(seen);
                default ->
                    source + " --" + trigger(this) + "--> " + target + ": "
                            + (heard.reply() == Reply.ACCEPTED
                                    ? ""
                                    : heard.reply().name().toLowerCase(java.util.Locale.ROOT) + ", ")
                            + "seen " + times(seen)
                            + (input.equals(LearnedDevice.WAIT)
                                    ? ", after " + seconds(soonest) + " to " + seconds(latest) + " s"
                                    : "");
            };
        }

        private static String times(int seen) {
            return seen == 1 ? "once" : seen + " times";
        }

        private static String seconds(Duration time) {
            return String.format(java.util.Locale.ROOT, "%.1f", time.toMillis() / 1000.0);
        }
    }

    public Learned {
        states = List.copyOf(states);
        edges = List.copyOf(edges);
        remarks = List.copyOf(remarks);
    }

    /** Whether it passed its test, and nothing stays open. */
    public boolean isTested() {
        return open.isEmpty() && remarks.isEmpty();
    }

    /**
     * @param declared the names of the states, if a model has them; else empty
     * @param never events that were left out, since a rule forbids them everywhere
     */
    static Learned of(
            @Nullable Mealy machine,
            AnswerTree tree,
            List<String> declared,
            Set<String> never,
            int depth,
            int words,
            Duration took,
            String open) {
        List<String> remarks = new ArrayList<>(never.stream()
                .sorted()
                .map(event -> event + " was not tried: a rule forbids it")
                .toList());
        if (machine == null) {
            return new Learned(List.of(), List.of(), depth, words, took, open, remarks);
        }
        Map<Long, List<Edge>> seen = new HashMap<>();
        Map<Integer, String> shown = new HashMap<>();
        collect(machine, tree.root(), 0, seen, shown);
        List<String> names = declared.isEmpty() ? names(machine.size(), shown) : declared;
        List<Arrow> edges = new ArrayList<>();
        for (int state = 0; state < machine.size(); state++) {
            for (int input = 0; input < machine.inputs().size(); input++) {
                if (machine.inputs().get(input).equals(Answers.LOOK)) {
                    continue;
                }
                List<Edge> all = seen.getOrDefault(key(machine, state, input), List.of());
                if (all.isEmpty()) {
                    remarks.add(names.get(state) + ": "
                            + Answers.name(machine.inputs().get(input)) + " was not tried");
                    continue;
                }
                Duration soonest =
                        all.stream().map(Edge::soonest).min(Duration::compareTo).orElseThrow();
                Duration latest =
                        all.stream().map(Edge::latest).max(Duration::compareTo).orElseThrow();
                String found = all.get(0).heard().shown();
                if (!found.equals(shown.getOrDefault(machine.next()[state][input], found))) {
                    // It ended before the learner has told the two states apart.
                    remarks.add(names.get(state) + " --"
                            + Answers.name(machine.inputs().get(input)) + "--> " + found
                            + ": seen, but not looked into");
                    continue;
                }
                Arrow edge = new Arrow(
                        names.get(state),
                        machine.inputs().get(input),
                        names.get(machine.next()[state][input]),
                        all.get(0).heard(),
                        all.stream().mapToInt(Edge::seen).sum(),
                        soonest,
                        latest);
                edges.add(edge);
                if (edge.heard().reply() == Reply.FORBIDDEN) {
                    remarks.add(edge.toString());
                }
                if (latest.minus(soonest).compareTo(SECOND.plus(latest.dividedBy(TIMERS_DIFFER))) > 0) {
                    remarks.add(edge + "; these are two timers, one that began before the state,"
                            + " or a way whose time depends on where it began");
                }
            }
        }
        return new Learned(names, edges, depth, words, took, open, remarks);
    }

    private static long key(Mealy machine, int state, int input) {
        return (long) state * machine.inputs().size() + input;
    }

    private static void collect(
            Mealy machine, Node node, int state, Map<Long, List<Edge>> seen, Map<Integer, String> shown) {
        shown.putIfAbsent(state, node.shown());
        node.edges().forEach((name, edge) -> {
            int input = machine.input(name);
            if (input >= 0
                    && machine.outputs()[state][input].equals(edge.heard().output())) {
                seen.computeIfAbsent(key(machine, state, input), none -> new ArrayList<>())
                        .add(edge);
                int next = machine.next()[state][input];
                String there = edge.target().shown();
                if (edge.target() != node && shown.getOrDefault(next, there).equals(there)) {
                    collect(machine, edge.target(), next, seen, shown);
                }
            }
        });
    }

    /** What the device shows, with a number where several states show the same. */
    private static List<String> names(int size, Map<Integer, String> shown) {
        Set<String> names = new LinkedHashSet<>();
        for (int state = 0; state < size; state++) {
            String name = shown.getOrDefault(state, "");
            String base = name.isEmpty() ? "State" : name;
            String free = name.isEmpty() ? "State-1" : name;
            for (int number = 2; names.contains(free); number++) {
                free = base + "-" + number;
            }
            names.add(free);
        }
        return List.copyOf(names);
    }

    /**
     * In what a declared model differs from what was seen, one line for each difference. States are the same if they have the
     * same name, or else if the same events lead there. What was not tried is no difference.
     *
     * @param longest how long each state was observed
     */
    public List<String> differences(StateMachine declared, Duration longest) {
        return states.isEmpty() ? List.of() : new Differences(this, declared, longest).lines();
    }

    /**
     * A model of it. An event that is refused has no transition; nor has one that changes nothing, if the device has no way to
     * refuse.
     *
     * @param name of the model
     * @throws IllegalStateException if nothing was learned
     */
    public StateMachine model(String name) {
        if (states.isEmpty()) {
            throw new IllegalStateException("nothing was learned: " + open);
        }
        boolean canRefuse = edges.stream().anyMatch(edge -> edge.heard().reply() == Reply.REFUSED);
        StateMachineBuilder model = StateMachine.named(name).initial(states.get(0));
        states.forEach(model::state);
        Set<String> own = new HashSet<>();
        for (Arrow edge : edges) {
            boolean loops = edge.source().equals(edge.target());
            Heard heard = edge.heard();
            boolean acts = edge.input().equals(LearnedDevice.WAIT) && !heard.leavesItAlone();
            boolean obeyed = heard.reply() == Reply.ACCEPTED && !acts;
            if (acts && !heard.acts().isEmpty() && own.add(heard.acts().get(0))) {
                model.spontaneous(heard.acts().get(0));
            }
            if (acts || (obeyed && (!loops || canRefuse))) {
                model.transition(edge.source(), trigger(edge), edge.target());
            }
        }
        return model.build();
    }

    static String trigger(Arrow edge) {
        if (!edge.input().equals(LearnedDevice.WAIT)) {
            return edge.input();
        }
        Heard heard = edge.heard();
        long middle = edge.soonest().plus(edge.latest()).dividedBy(2).toMillis();
        return heard.acts().isEmpty()
                ? "after " + Math.max(1, Math.round(middle / 1000.0)) + " s"
                : heard.acts().get(0);
    }
}
