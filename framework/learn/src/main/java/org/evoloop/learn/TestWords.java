package org.evoloop.learn;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import net.automatalib.automaton.transducer.impl.CompactMealy;
import net.automatalib.util.automaton.Automata;
import net.automatalib.word.Word;

/**
 * The words by which a machine is tested: to each state, up to {@code depth + 1} inputs from there, and then what tells
 * the state in which that ends from all others (the Wp method); and some random ones. They wait only as their last step,
 * and where waiting is the input that is tested or the only way to a state.
 */
final class TestWords {
    /** The seed is fixed, so that a learning that goes on asks what it asked before. */
    private static final long SEED = 54;

    private static final int LONGEST_RANDOM = 12;

    private final CompactMealy<String, Answer> machine;
    private final List<String> inputs;
    private final Map<Integer, List<String>> access;
    private final Map<Integer, List<List<String>>> signatures = new HashMap<>();

    TestWords(CompactMealy<String, Answer> machine) {
        this.machine = machine;
        this.inputs = machine.getInputAlphabet().stream()
                .filter(input -> !input.equals(Run.LOOK))
                .toList();
        this.access = access(machine);
    }

    /** For each state a way to it, with as few waits as possible; the states are in order of their distance. */
    static Map<Integer, List<String>> access(CompactMealy<String, Answer> machine) {
        Map<Integer, List<String>> found = new LinkedHashMap<>();
        found.put(machine.getIntInitialState(), List.of());
        ArrayDeque<Integer> byPressing = new ArrayDeque<>(found.keySet());
        ArrayDeque<Integer> byWaiting = new ArrayDeque<>();
        while (!byPressing.isEmpty() || !byWaiting.isEmpty()) {
            boolean pressing = !byPressing.isEmpty();
            int state = pressing ? byPressing.remove() : byWaiting.remove();
            for (String input : machine.getInputAlphabet()) {
                Integer next = machine.getSuccessor((Integer) state, input);
                if (next != null && input.equals(Run.WAIT) != pressing && !found.containsKey(next)) {
                    List<String> way = new ArrayList<>(found.get(state));
                    way.add(input);
                    found.put(next, way);
                    byPressing.add(next);
                }
            }
            if (pressing) {
                byWaiting.add(state);
            }
        }
        return found;
    }

    /** The words, the shortest first. */
    List<List<String>> all(int depth, int random) {
        Set<List<String>> words = new LinkedHashSet<>();
        for (List<String> way : access.values()) {
            extend(way, depth + 1, false, words);
        }
        List<List<String>> sorted = new ArrayList<>(words);
        sorted.sort(Comparator.comparingInt(List::size));
        sorted.addAll(randomWords(random));
        return sorted;
    }

    private void extend(List<String> way, int more, boolean tested, Set<List<String>> words) {
        int state = machine.getState(way);
        for (List<String> suffix : signatures.computeIfAbsent(state, this::signature)) {
            List<String> word = new ArrayList<>(way);
            word.addAll(suffix);
            words.add(word);
        }
        if (more == 0) {
            return;
        }
        for (String input : inputs) {
            boolean waits = input.equals(Run.WAIT);
            List<String> word = new ArrayList<>(way);
            word.add(input);
            if (waits && tested) {
                words.add(word);
            } else {
                extend(word, more - 1, true, words);
            }
        }
    }

    private List<List<String>> signature(int state) {
        Set<List<String>> suffixes = new LinkedHashSet<>();
        for (Word<String> suffix :
                Automata.stateCharacterizingSet(machine, machine.getInputAlphabet(), (Integer) state)) {
            int wait = suffix.asList().indexOf(Run.WAIT);
            suffixes.add(
                    List.copyOf(wait < 0 ? suffix.asList() : suffix.asList().subList(0, wait + 1)));
        }
        // A machine of one state has none.
        return suffixes.isEmpty() ? List.of(List.of()) : List.copyOf(suffixes);
    }

    private List<List<String>> randomWords(int number) {
        List<String> pressed =
                inputs.stream().filter(input -> !input.equals(Run.WAIT)).toList();
        List<List<String>> ways = List.copyOf(access.values());
        Random random = new Random(SEED);
        List<List<String>> words = new ArrayList<>();
        for (int i = 0; i < number && !pressed.isEmpty(); i++) {
            List<String> word = new ArrayList<>(ways.get(random.nextInt(ways.size())));
            int length = 2 + random.nextInt(LONGEST_RANDOM);
            for (int step = 0; step < length; step++) {
                word.add(pressed.get(random.nextInt(pressed.size())));
            }
            words.add(word);
        }
        return words;
    }
}
