package org.evoloop.learn;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Map.Entry;
import java.util.Optional;
import org.evoloop.learn.Answer.Reply;
import org.evoloop.learn.Run.Step;
import org.jspecify.annotations.Nullable;

/**
 * Everything that a device was ever asked, with each answer and how often it came. What follows an answer is kept apart
 * from what follows another answer to the same input, since one of them was noise.
 */
final class AnswerTree {
    private static final int MOST_LEAD = 6;
    /** How likely it may be that noise wins a vote. */
    private static final double WRONG = 0.001;

    private final SafetyRules rules;
    private final List<Run> runs = new ArrayList<>();
    private final Node root = new Node();
    private int contradicted;
    private int lead = 1;
    /** The answers that were given since the algorithm started, which it relies on. */
    private Map<Node, Map<String, Answer>> given = new HashMap<>();

    private static final class Node {
        final Map<String, Map<Answer, Branch>> answers = new HashMap<>();

        /** The answers to an input, the most frequent first. */
        List<Entry<Answer, Branch>> ranked(String input) {
            // The order of equal ones is that in which they came.
            return answers.getOrDefault(input, Map.of()).entrySet().stream()
                    .sorted(Comparator.comparingInt((Entry<Answer, Branch> one) -> -one.getValue().count))
                    .toList();
        }
    }

    private static final class Branch {
        final Node next = new Node();
        int count;
    }

    AnswerTree(SafetyRules rules) {
        this.rules = rules;
    }

    List<Run> runs() {
        return runs;
    }

    /** How many runs had an answer that differs from the usual one. */
    int contradicted() {
        return contradicted;
    }

    /** Adds a run. Returns whether what the algorithm relies on no longer holds, so that it must start again. */
    boolean add(Run run) {
        runs.add(run);
        boolean flipped = false;
        boolean contradicts = false;
        Node node = root;
        String shows = "";
        for (Step step : run.steps()) {
            List<Entry<Answer, Branch>> before = node.ranked(step.input());
            contradicts |= !before.isEmpty() && !before.get(0).getKey().equals(step.answer());
            Branch branch = node.answers
                    .computeIfAbsent(step.input(), input -> new LinkedHashMap<>())
                    .computeIfAbsent(step.answer(), answer -> new Branch());
            branch.count++;
            Answer relied = given.getOrDefault(node, Map.of()).get(step.input());
            flipped |= relied != null
                    && !relied.equals(node.ranked(step.input()).get(0).getKey());
            if (!step.answer().isQuiet(shows)) {
                node = branch.next;
            }
            shows = step.answer().shows();
        }
        contradicted += contradicts ? 1 : 0;
        int needed = contradicted == 0 ? 1 : leadFor((double) contradicted / runs.size());
        boolean stricter = needed > lead;
        lead = Math.max(lead, needed);
        return flipped || stricter;
    }

    private static int leadFor(double noise) {
        int enough = noise >= 1 ? MOST_LEAD : (int) Math.ceil(Math.log(WRONG) / Math.log(noise));
        return Math.min(MOST_LEAD, Math.max(2, enough));
    }

    /** The algorithm starts again. */
    void restart() {
        given = new HashMap<>();
    }

    /**
     * The answers to a word that begins with a reset. They are relied on from now on.
     *
     * @return null if the device must be asked
     */
    @Nullable
    List<Answer> answers(List<String> word) {
        List<Answer> found = new ArrayList<>();
        Node node = root;
        String shows = "";
        for (String input : word) {
            boolean looks = input.equals(Run.LOOK);
            if (looks || rules.forbids(input, shows).isPresent()) {
                found.add(new Answer(looks ? Reply.WAITED : Reply.FORBIDDEN, shows));
                continue;
            }
            List<Entry<Answer, Branch>> ranked = node.ranked(input);
            int second = ranked.size() < 2 ? 0 : ranked.get(1).getValue().count;
            if (ranked.isEmpty() || ranked.get(0).getValue().count - second < lead) {
                return null;
            }
            Answer answer = ranked.get(0).getKey();
            found.add(answer);
            given.computeIfAbsent(node, key -> new HashMap<>()).put(input, answer);
            if (!answer.isQuiet(shows)) {
                node = ranked.get(0).getValue().next;
            }
            shows = answer.shows();
        }
        return found;
    }

    /**
     * The word without looks, and without waits that are known to be quiet, which change nothing. A wait at the end
     * stays.
     */
    List<String> withoutIdle(List<String> word) {
        List<String> needed = new ArrayList<>();
        for (int i = 0; i < word.size(); i++) {
            boolean idle = word.get(i).equals(Run.LOOK);
            if (word.get(i).equals(Run.WAIT) && i < word.size() - 1) {
                List<Answer> known = answers(word.subList(0, i + 1));
                idle = known != null && known.get(i).isQuiet(known.get(i - 1).shows());
            }
            if (!idle) {
                needed.add(word.get(i));
            }
        }
        return needed;
    }

    /** The place on the way of a word whose answers are least agreed on, with their counts; empty if all agree. */
    Optional<String> dispute(List<String> word) {
        Optional<String> worst = Optional.empty();
        double mostShare = 0;
        Node node = root;
        String shows = "";
        for (int i = 0; i < word.size(); i++) {
            String input = word.get(i);
            if (input.equals(Run.LOOK) || rules.forbids(input, shows).isPresent()) {
                continue;
            }
            List<Entry<Answer, Branch>> ranked = node.ranked(input);
            if (ranked.isEmpty()) {
                break;
            }
            Entry<Answer, Branch> first = ranked.get(0);
            Entry<Answer, Branch> second = ranked.get(Math.min(1, ranked.size() - 1));
            double share = (double) second.getValue().count / first.getValue().count;
            if (ranked.size() > 1 && share > mostShare) {
                mostShare = share;
                worst = Optional.of(
                        "after " + String.join(", ", word.subList(0, i + 1)) + ": '" + first.getKey() + "' ("
                                + first.getValue().count + " times) and '" + second.getKey() + "' ("
                                + second.getValue().count + " times)");
            }
            if (!first.getKey().isQuiet(shows)) {
                node = first.getValue().next;
            }
            shows = first.getKey().shows();
        }
        return worst;
    }
}
