package org.evoloop.learn;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import net.automatalib.automaton.transducer.MealyMachine;

/** A hypothesis as tables: where each input leads from each state, and what is answered. State 0 is after the reset. */
final class Mealy {
    private final List<String> inputs;
    private final int[][] next;
    private final String[][] outputs;

    Mealy(List<String> inputs, int[][] next, String[][] outputs) {
        this.inputs = inputs;
        this.next = next;
        this.outputs = outputs;
    }

    static <S, T> Mealy of(MealyMachine<S, String, T, String> machine, List<String> inputs) {
        Map<S, Integer> numbers = new HashMap<>();
        List<S> states = new ArrayList<>();
        S initial = machine.getInitialState();
        if (initial == null) {
            throw new IllegalStateException("the hypothesis has no initial state");
        }
        numbers.put(initial, 0);
        states.add(initial);
        List<int[]> next = new ArrayList<>();
        List<String[]> outputs = new ArrayList<>();
        for (int i = 0; i < states.size(); i++) {
            int[] targets = new int[inputs.size()];
            String[] answers = new String[inputs.size()];
            for (int k = 0; k < inputs.size(); k++) {
                String input = inputs.get(k);
                S target = machine.getSuccessor(states.get(i), input);
                String output = machine.getOutput(states.get(i), input);
                if (target == null || output == null) {
                    throw new IllegalStateException("the hypothesis has no answer to " + input);
                }
                if (numbers.putIfAbsent(target, states.size()) == null) {
                    states.add(target);
                }
                targets[k] = numbers.get(target);
                answers[k] = output;
            }
            next.add(targets);
            outputs.add(answers);
        }
        return new Mealy(inputs, next.toArray(int[][]::new), outputs.toArray(String[][]::new));
    }

    List<String> inputs() {
        return inputs;
    }

    /** By state and input. */
    int[][] next() {
        return next;
    }

    /** By state and input. */
    String[][] outputs() {
        return outputs;
    }

    int size() {
        return next.length;
    }

    int input(String name) {
        return inputs.indexOf(name);
    }

    /** The state behind {@code word}, from {@code state}. */
    int after(int state, List<String> word) {
        int at = state;
        for (String name : word) {
            at = next[at][input(name)];
        }
        return at;
    }

    /** Whether {@code word} is answered in the same way from both states. */
    boolean isAlike(int left, int right, List<String> word) {
        int a = left;
        int b = right;
        for (String name : word) {
            int input = input(name);
            if (!outputs[a][input].equals(outputs[b][input])) {
                return false;
            }
            a = next[a][input];
            b = next[b][input];
        }
        return true;
    }
}
