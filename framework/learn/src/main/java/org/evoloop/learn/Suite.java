package org.evoloop.learn;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;

/**
 * The test of a hypothesis: the words of the partial W method. A word waits in its middle only where nothing else leads to a
 * state, and where a timer's target is tested.
 */
final class Suite {
    /** A wait costs as much as so many presses. */
    private static final int WAIT_COST = 20;

    private final Mealy machine;
    private final List<List<String>> access;
    private final List<Set<List<String>>> local = new ArrayList<>();
    private final Set<List<String>> global = new LinkedHashSet<>();
    private boolean tellsAllApart = true;

    Suite(Mealy machine) {
        this.machine = machine;
        this.access = accessWords(machine);
        for (int state = 0; state < machine.size(); state++) {
            local.add(new LinkedHashSet<>());
        }
        for (int state = 0; state < machine.size(); state++) {
            for (int other = 0; other < machine.size(); other++) {
                if (other != state) {
                    separate(state, other);
                }
            }
        }
        local.forEach(global::addAll);
    }

    /** Whether there is a word for any two states that tells them apart, as for every hypothesis of a learner. */
    boolean tellsAllApart() {
        return tellsAllApart;
    }

    /** The shortest words to each state. */
    List<List<String>> access() {
        return access;
    }

    private static int cost(Collection<String> word) {
        return word.stream()
                .mapToInt(input -> switch (input) {
                    case LearnedDevice.WAIT -> WAIT_COST;
                    case Answers.LOOK -> 0;
                    default -> 1;
                })
                .sum();
    }

    private static List<String> then(List<String> word, Collection<String> more) {
        List<String> longer = new ArrayList<>(word);
        longer.addAll(more);
        return longer;
    }

    private static List<List<String>> accessWords(Mealy machine) {
        record Way(int state, List<String> word) {}
        List<List<String>> found = new ArrayList<>(Arrays.asList(new List<?>[machine.size()]).stream()
                .map(none -> List.<String>of())
                .toList());
        boolean[] done = new boolean[machine.size()];
        PriorityQueue<Way> ways = new PriorityQueue<>(Comparator.comparingInt(way -> cost(way.word())));
        ways.add(new Way(0, List.of()));
        for (Way way = ways.poll(); way != null; way = ways.poll()) {
            if (done[way.state()]) {
                continue;
            }
            done[way.state()] = true;
            found.set(way.state(), way.word());
            for (int input = 0; input < machine.inputs().size(); input++) {
                ways.add(new Way(
                        machine.next()[way.state()][input],
                        then(way.word(), List.of(machine.inputs().get(input)))));
            }
        }
        return found;
    }

    /** Makes sure that a word of {@code state} tells it from {@code other}. */
    private void separate(int state, int other) {
        Set<List<String>> words = local.get(state);
        if (words.stream().anyMatch(word -> !machine.isAlike(state, other, word))) {
            return;
        }
        List<String> known = local.stream()
                .flatMap(Collection::stream)
                .filter(word -> !machine.isAlike(state, other, word))
                .min(Comparator.comparingInt(Suite::cost))
                .orElse(null);
        words.add(known == null || known.contains(LearnedDevice.WAIT) ? separating(state, other) : known);
    }

    /** The cheapest word that tells two states apart. */
    private List<String> separating(int left, int right) {
        record Way(int left, int right, List<String> word) {}
        Set<Long> done = new LinkedHashSet<>();
        PriorityQueue<Way> ways = new PriorityQueue<>(Comparator.comparingInt(way -> cost(way.word())));
        ways.add(new Way(left, right, List.of()));
        for (Way way = ways.poll(); way != null; way = ways.poll()) {
            if (!machine.isAlike(left, right, way.word())) {
                return way.word();
            }
            if (!done.add((long) way.left() * machine.size() + way.right())) {
                continue;
            }
            for (int input = 0; input < machine.inputs().size(); input++) {
                ways.add(new Way(
                        machine.next()[way.left()][input],
                        machine.next()[way.right()][input],
                        then(way.word(), List.of(machine.inputs().get(input)))));
            }
        }
        tellsAllApart = false;
        return List.of();
    }

    /** The words, first those that look for few states more. */
    List<List<String>> words(int depth) {
        List<String> presses = machine.inputs().stream()
                .filter(input -> !input.equals(LearnedDevice.WAIT) && !input.equals(Answers.LOOK))
                .toList();
        Map<Integer, Set<List<String>>> levels = new HashMap<>();
        List<List<String>> middles = List.of(List.of());
        for (int length = 0; length <= depth + 1; length++) {
            Set<List<String>> level = levels.computeIfAbsent(length, none -> new LinkedHashSet<>());
            for (List<String> way : access) {
                for (List<String> middle : middles) {
                    List<String> begin = then(way, middle);
                    Set<List<String>> ends = length <= depth ? global : local.get(machine.after(0, begin));
                    ends.forEach(end -> level.add(then(begin, end)));
                    if (ends.isEmpty()) {
                        level.add(begin);
                    }
                }
            }
            middles = middles.stream()
                    .flatMap(middle -> presses.stream().map(press -> then(middle, List.of(press))))
                    .toList();
        }
        levels.getOrDefault(0, new LinkedHashSet<>()).addAll(waits());
        return levels.entrySet().stream()
                .sorted(Map.Entry.comparingByKey())
                .flatMap(level -> level.getValue().stream().sorted(Comparator.comparingInt(word -> -word.size())))
                .toList();
    }

    /**
     * Each transition's target is observed, as it may differ from the state that it is taken for by what it does by itself;
     * and where a timer leads is tested.
     */
    private Set<List<String>> waits() {
        Set<List<String>> words = new LinkedHashSet<>();
        int wait = machine.input(LearnedDevice.WAIT);
        if (wait < 0) {
            return words;
        }
        for (List<String> way : access) {
            int state = machine.after(0, way);
            for (String input : machine.inputs()) {
                words.add(then(way, List.of(input, LearnedDevice.WAIT)));
            }
            int target = machine.next()[state][wait];
            if (target != state) {
                List<String> observed = then(way, List.of(LearnedDevice.WAIT));
                local.get(target).forEach(end -> words.add(then(observed, end)));
                for (String input : machine.inputs()) {
                    List<String> more = then(observed, List.of(input));
                    local.get(machine.after(0, more)).forEach(end -> words.add(then(more, end)));
                }
            }
        }
        return words;
    }
}
