package org.evoloop.learn;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import net.automatalib.automaton.transducer.impl.CompactMealy;
import org.evoloop.learn.Answer.Reply;
import org.evoloop.learn.LearnedModel.Cost;
import org.evoloop.learn.LearnedModel.Delay;
import org.evoloop.learn.Run.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;

/** Makes the model of what was learned: names, transitions, and what the runs say about each. */
final class ModelOfAnswers {
    private final String name;
    private final String firstShown;
    private final CompactMealy<String, Answer> answers;
    private final List<String> inputs;
    private final SafetyRules rules;
    private final AnswerTree tree;
    /** What the device shows in each state; the order is that in which they are reached. */
    private final Map<Integer, String> shown = new LinkedHashMap<>();

    private final Map<Integer, State> states = new LinkedHashMap<>();

    private final Map<Edge, Integer> taken = new HashMap<>();
    private final Map<Edge, Spell> spells = new HashMap<>();

    private record Edge(int state, String input) {}

    /** Of a state that the device leaves by itself: the bounds of each stay, put together. */
    private static final class Spell {
        long leastMillis = Long.MAX_VALUE;
        long mostMillis;
        long latestStart;
        long earliestEnd = Long.MAX_VALUE;

        void add(long least, long most) {
            leastMillis = Math.min(leastMillis, least);
            mostMillis = Math.max(mostMillis, most);
            latestStart = Math.max(latestStart, least);
            earliestEnd = Math.min(earliestEnd, most);
        }

        /** Whether no one time, with a tenth for the device's own tolerance, explains all stays. */
        boolean isTorn() {
            return latestStart > earliestEnd + earliestEnd / 10;
        }

        Delay delay() {
            return new Delay(Duration.ofMillis(leastMillis), Duration.ofMillis(mostMillis));
        }
    }

    ModelOfAnswers(
            String name,
            String firstShown,
            CompactMealy<String, Answer> answers,
            List<String> inputs,
            SafetyRules rules,
            AnswerTree tree) {
        this.name = name;
        this.firstShown = firstShown;
        this.answers = answers;
        this.inputs = inputs;
        this.rules = rules;
        this.tree = tree;
    }

    LearnedModel model(String stopped, Cost cost) {
        nameStates();
        tree.runs().forEach(this::replay);
        StateMachineBuilder builder = StateMachine.named(name).initial(name(answers.getIntInitialState()));
        Map<Transition, Integer> seen = new LinkedHashMap<>();
        Map<Transition, Delay> delays = new LinkedHashMap<>();
        List<String> untried = new ArrayList<>();
        List<String> open = new ArrayList<>();
        if (!stopped.isEmpty()) {
            open.add(stopped);
        }
        inputs.forEach(builder::event);
        for (int state : states.keySet()) {
            builder.state(name(state));
            for (String input : inputs) {
                Optional<String> rule = rules.forbids(input, shown.getOrDefault(state, ""));
                if (rule.isPresent()) {
                    untried.add(input + " in " + name(state) + ": the rule '" + rule.get() + "' forbids it");
                } else {
                    pressed(new Edge(state, input)).ifPresent(transition -> {
                        builder.transition(transition, "");
                        seen.put(transition, taken.getOrDefault(new Edge(state, input), 0));
                    });
                }
            }
            Edge wait = new Edge(state, Run.WAIT);
            waited(wait).ifPresent(transition -> {
                builder.spontaneous(transition.event()).transition(transition, "");
                seen.put(transition, taken.getOrDefault(wait, 0));
                Spell spell = spells.get(wait);
                if (spell != null) {
                    delays.put(transition, spell.delay());
                    if (spell.isTorn()) {
                        open.add("the device leaves " + name(state) + " after different times, " + spell.delay()
                                + "; its timer may belong to a state around it, or it counts");
                    }
                }
            });
        }
        return new LearnedModel(builder.build(), seen, delays, untried, open, cost);
    }

    private String name(int state) {
        return states.getOrDefault(state, new State("?")).name();
    }

    private void nameStates() {
        Map<String, Integer> numbers = new HashMap<>();
        Set<String> used = new HashSet<>();
        TestWords.access(answers).forEach((state, way) -> {
            String shows = way.isEmpty()
                    ? firstShown
                    : answers.computeOutput(way).lastSymbol().shows();
            shown.put(state, shows);
            String candidate = shows;
            for (int number = numbers.merge(shows, 1, Integer::sum); !used.add(candidate); number++) {
                candidate = shows + "-" + Math.max(2, number);
            }
            states.put(state, new State(candidate));
        });
    }

    private Optional<Transition> pressed(Edge edge) {
        Answer answer = answers.getOutput((Integer) edge.state, edge.input);
        int target = target(edge);
        // What is not taken and changes nothing is no transition.
        boolean drawn = target != edge.state || answer.reply() == Reply.ACCEPTED;
        return drawn ? Optional.of(transition(edge, edge.input, target)) : Optional.empty();
    }

    private Optional<Transition> waited(Edge edge) {
        Answer answer = answers.getOutput((Integer) edge.state, edge.input);
        int target = target(edge);
        if (answer.isQuiet(shown.getOrDefault(edge.state, "")) && target == edge.state) {
            return Optional.empty();
        }
        String event = answer.acts().isEmpty() ? "becomes" + name(target) : String.join("-then-", answer.acts());
        // An event that can be pressed is another one.
        return Optional.of(transition(edge, inputs.contains(event) ? event + "-by-itself" : event, target));
    }

    private int target(Edge edge) {
        return answers.getSuccessor((Integer) edge.state, edge.input);
    }

    private Transition transition(Edge edge, String event, int target) {
        return new Transition(new State(name(edge.state)), new Event(event), new State(name(target)));
    }

    /** Follows a run through the machine, up to the first answer that is not the machine's. */
    private void replay(Run run) {
        int state = answers.getIntInitialState();
        Step entered = run.steps().get(0);
        for (Step step : run.steps().subList(1, run.steps().size())) {
            Edge edge = new Edge(state, step.input());
            if (!step.answer().equals(answers.getOutput((Integer) state, step.input()))) {
                return;
            }
            taken.merge(edge, 1, Integer::sum);
            boolean waited = step.input().equals(Run.WAIT);
            if (waited && !step.answer().acts().isEmpty()) {
                spells.computeIfAbsent(edge, key -> new Spell())
                        .add(step.firstMillis() - entered.firstMillis(), step.firstMillis() - entered.startMillis());
            }
            int next = target(edge);
            if (next != state || (waited && !step.answer().acts().isEmpty())) {
                // What the device does by itself begins with its first sign.
                entered = waited ? new Step(step.input(), step.answer(), step.firstMillis(), step.firstMillis()) : step;
            }
            state = next;
        }
    }
}
