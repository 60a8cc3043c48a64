package org.evoloop.learn;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.learn.AnswerTree.Edge;
import org.evoloop.learn.AnswerTree.Node;
import org.evoloop.learn.Heard.Reply;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * A model that somebody has declared, as a hypothesis about the device. It leaves open what a model does not say: whether an
 * event without a transition is refused, and when the device does something by itself that has no time.
 */
final class Declared {
    private final StateMachine model;
    private final List<String> inputs;
    private final Duration longest;
    private final boolean shows;
    private final List<State> states = new ArrayList<>();

    /**
     * @param inputs what is sent, waiting, and looking
     * @param shows whether the device reports its state
     */
    Declared(StateMachine model, List<String> inputs, Duration longest, boolean shows) {
        this.model = model;
        this.inputs = inputs;
        this.longest = longest;
        this.shows = shows;
        states.add(model.initial());
        for (int i = 0; i < states.size(); i++) {
            for (String input : inputs) {
                State next = next(states.get(i), input);
                if (!states.contains(next)) {
                    states.add(next);
                }
            }
        }
    }

    List<String> names() {
        return states.stream().map(State::name).toList();
    }

    private State next(State state, String input) {
        if (input.equals(LearnedDevice.WAIT)) {
            return timed(state).map(Transition::target).orElse(state);
        }
        return input.equals(Answers.LOOK)
                ? state
                : model.nextState(state, new Event(input)).orElse(state);
    }

    /** What a state does by itself within the longest observation. */
    private Optional<Transition> timed(State state) {
        return model.transitionsFrom(state).stream()
                .filter(transition -> transition
                        .event()
                        .timeTrigger()
                        .filter(time -> time.compareTo(longest) < 0)
                        .isPresent())
                .findFirst();
    }

    /** What the device would answer if it were so. */
    Mealy hypothesis() {
        int[][] next = new int[states.size()][inputs.size()];
        String[][] outputs = new String[states.size()][inputs.size()];
        for (int i = 0; i < states.size(); i++) {
            for (int k = 0; k < inputs.size(); k++) {
                State target = next(states.get(i), inputs.get(k));
                next[i][k] = states.indexOf(target);
                outputs[i][k] = output(inputs.get(k), states.get(i), target);
            }
        }
        return new Mealy(inputs, next, outputs);
    }

    private String output(String input, State state, State target) {
        String shown = shows ? target.name() : "";
        if (input.equals(Answers.LOOK)) {
            return shown;
        }
        Heard heard =
                input.equals(LearnedDevice.WAIT) && target.equals(state) ? Heard.silent(shown) : Heard.accepted(shown);
        return heard.output();
    }

    /** Where an answer leads; -1 if the model does not agree with it. */
    private int next(int at, String input, Heard heard) {
        State state = states.get(at);
        State target = next(state, input);
        if (heard.reply() == Reply.FORBIDDEN) {
            return at;
        }
        boolean waits = input.equals(LearnedDevice.WAIT);
        if (waits && heard.reply() == Reply.SILENT) {
            return target.equals(state) ? at : -1;
        }
        if (waits && !heard.acts().isEmpty()) {
            target = model.nextState(state, new Event(heard.acts().get(0))).orElse(null);
        } else if (waits && target.equals(state)) {
            return -1;
        }
        boolean obeys = heard.reply() == Reply.ACCEPTED;
        boolean moves = target != null && !target.equals(state);
        boolean elsewhere = shows && target != null && !heard.shown().equals(target.name());
        return target == null || elsewhere || (moves && !obeys) ? -1 : states.indexOf(target);
    }

    /** The hypothesis with what was really heard; null if the model does not explain all of it. */
    @Nullable
    Mealy confirmed(Node root) {
        Mealy machine = hypothesis();
        boolean[][] heard = new boolean[states.size()][inputs.size()];
        return explains(root, 0, machine, heard) ? machine : null;
    }

    private boolean explains(Node node, int state, Mealy machine, boolean[][] heard) {
        if (!put(machine, heard, state, Answers.LOOK, node.shown(), state)) {
            return false;
        }
        for (Map.Entry<String, Edge> answer : node.edges().entrySet()) {
            Edge edge = answer.getValue();
            String input = answer.getKey();
            int target = inputs.contains(input) ? next(state, input, edge.heard()) : -1;
            if (target < 0
                    || !put(machine, heard, state, input, edge.heard().output(), target)
                    || (edge.target() != node && !explains(edge.target(), target, machine, heard))) {
                return false;
            }
        }
        return true;
    }

    /** Notes an answer; false if another was heard in the same state. */
    private static boolean put(Mealy machine, boolean[][] heard, int state, String name, String output, int target) {
        int input = machine.input(name);
        if (heard[state][input]) {
            return machine.outputs()[state][input].equals(output) && machine.next()[state][input] == target;
        }
        heard[state][input] = true;
        machine.outputs()[state][input] = output;
        machine.next()[state][input] = target;
        return true;
    }
}
