package org.evoloop.learn;

import static java.util.Objects.requireNonNull;

import de.learnlib.acex.AcexAnalyzers;
import de.learnlib.algorithm.ttt.mealy.TTTLearnerMealy;
import de.learnlib.query.DefaultQuery;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import net.automatalib.alphabet.Alphabet;
import net.automatalib.alphabet.impl.Alphabets;
import net.automatalib.automaton.transducer.MealyMachine;
import net.automatalib.automaton.transducer.impl.CompactMealy;
import net.automatalib.word.Word;
import org.evoloop.learn.Asking.Again;
import org.evoloop.learn.Asking.Stopped;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Learns the state machine of a device: {@code Learning.of("lamp", device, clock, inputs).longest(...).learn()}.
 *
 * <p>Threading: not thread-safe; {@link #learn} works on the thread that calls it.
 *
 * @since 0.1
 */
public final class Learning {
    private static final Duration USUAL_LONGEST = Duration.ofMinutes(1);
    private static final int USUAL_RANDOM_WORDS = 20;
    /** A test takes each state's transitions and one step more. */
    private static final int DEPTH = 1;

    private static final int MOST_STATES = 500;
    private static final int MOST_STARTS = 200;

    private final String name;
    private final LearnableDevice device;
    private final Clock clock;
    private final List<String> inputs;
    private SafetyRules rules = SafetyRules.NONE;
    private Duration longest = USUAL_LONGEST;
    private Duration budget = Clock.LONGEST;
    private int randomWords = USUAL_RANDOM_WORDS;
    private @Nullable Path log;
    private @Nullable CompactMealy<String, Answer> best;
    private String firstShown = "";

    private Learning(String name, LearnableDevice device, Clock clock, List<String> inputs) {
        this.name = name;
        this.device = device;
        this.clock = clock;
        this.inputs = List.copyOf(new LinkedHashSet<>(inputs));
    }

    /**
     * Begins to say what is to be learned.
     *
     * @param name of the machine
     * @param device the device
     * @param clock by which time is measured
     * @param inputs the events that can be sent
     * @throws LearnException if there are none, or one has a name in parentheses
     */
    public static Learning of(String name, LearnableDevice device, Clock clock, List<String> inputs) {
        if (inputs.isEmpty()) {
            throw new LearnException("there are no events that can be sent to the device, so nothing can be learned");
        }
        for (String input : inputs) {
            if (input.isBlank() || input.startsWith("(")) {
                throw new LearnException(
                        "the event '" + input + "' has no name that can be learned; give it one without parentheses");
            }
        }
        return new Learning(name, device, clock, inputs);
    }

    /**
     * What must not be pressed, see {@link SafetyRules}.
     *
     * @throws LearnException if a line is no rule
     */
    public Learning rules(List<String> lines) {
        rules = SafetyRules.parse(lines, new LinkedHashSet<>(inputs));
        return this;
    }

    /** How long a state is observed at most, before it counts as one that the device does not leave by itself; 1 min by default. */
    public Learning longest(Duration duration) {
        longest = Clock.requireDelay(duration);
        return this;
    }

    /** How long learning may take; any time by default. What is then asked is heard to its end. */
    public Learning budget(Duration duration) {
        budget = Clock.requireDelay(duration);
        return this;
    }

    /** How many random words are tried after the systematic test; 20 by default. */
    public Learning randomWords(int number) {
        randomWords = number;
        return this;
    }

    /** Where all answers are kept. If the file exists, learning goes on where it was. */
    public Learning log(Path file) {
        log = requireNonNull(file, "the file of learning is null");
        return this;
    }

    /**
     * Learns. The result says whether it passed its test; if learning ended before, it is the last machine that agreed
     * with all that was asked until then.
     *
     * @throws LearnException if not even a first machine was found, or the log cannot be used
     * @throws InterruptedException if the thread is interrupted
     */
    public LearnedModel learn() throws InterruptedException {
        Asking asking = new Asking(device, clock, rules, longest, budget);
        String head = "evoloop-learn 1, inputs "
                + inputs.stream()
                        .map(input -> URLEncoder.encode(input, StandardCharsets.UTF_8))
                        .toList()
                + ", longest " + longest;
        try (AnswerLog opened = AnswerLog.open(log, head, asking)) {
            asking.logTo(opened);
            return learn(asking);
        }
    }

    private LearnedModel learn(Asking asking) throws InterruptedException {
        String open;
        best = null;
        try {
            untilTested(asking);
            open = "";
        } catch (Stopped stopped) {
            if (Thread.interrupted()) {
                throw new InterruptedException(stopped.reason());
            }
            if (best == null) {
                throw new LearnException(
                        "nothing was learned after " + asking.cost() + ": " + stopped.reason(), stopped);
            }
            open = stopped.reason();
        }
        return new ModelOfAnswers(name, firstShown, requireNonNull(best), inputs, rules, asking.tree())
                .model(open, asking.cost());
    }

    private void untilTested(Asking asking) {
        for (int start = 0; start < MOST_STARTS; start++) {
            try {
                asking.tree().restart();
                learnOnce(asking);
                return;
            } catch (Again again) {
                // From the tree, with what is believed now.
            }
        }
        throw new Stopped("the device's answers changed " + MOST_STARTS + " times; it is not deterministic", null);
    }

    private void learnOnce(Asking asking) {
        firstShown = asking.firstShown();
        List<String> symbols = new ArrayList<>();
        // What is never pressed at all is no input.
        inputs.stream().filter(input -> rules.forbids(input, "").isEmpty()).forEach(symbols::add);
        symbols.add(0, Run.LOOK);
        symbols.add(Run.WAIT);
        Alphabet<String> alphabet = Alphabets.fromList(symbols);
        TTTLearnerMealy<String, Answer> learner =
                new TTTLearnerMealy<>(alphabet, asking, AcexAnalyzers.BINARY_SEARCH_BWD);
        learner.startLearning();
        while (true) {
            CompactMealy<String, Answer> machine = copy(learner.getHypothesisModel(), alphabet);
            if (machine.size() > MOST_STATES) {
                throw new Stopped(
                        "there are more than " + MOST_STATES + " states; the device has too many, or does not repeat"
                                + " its answers",
                        null);
            }
            best = machine;
            DefaultQuery<String, Word<Answer>> counterexample = counterexample(machine, asking);
            if (counterexample == null) {
                return;
            }
            learner.refineHypothesis(counterexample);
        }
    }

    private @Nullable DefaultQuery<String, Word<Answer>> counterexample(
            CompactMealy<String, Answer> machine, Asking asking) {
        for (List<String> word : new TestWords(machine).all(DEPTH, randomWords)) {
            Word<Answer> answers = Word.fromList(asking.ask(word));
            Word<String> input = Word.fromList(word);
            if (!answers.equals(machine.computeOutput(input))) {
                return new DefaultQuery<>(input, answers);
            }
        }
        return null;
    }

    private static <S> CompactMealy<String, Answer> copy(
            MealyMachine<S, String, ?, Answer> from, Alphabet<String> alphabet) {
        CompactMealy<String, Answer> copy = new CompactMealy<>(alphabet, from.size());
        Map<S, Integer> states = new HashMap<>();
        for (S state : from.getStates()) {
            states.put(state, copy.addState());
        }
        copy.setInitialState(states.get(from.getInitialState()));
        states.forEach((state, number) -> {
            for (String input : alphabet) {
                copy.addTransition(
                        number, input, states.get(from.getSuccessor(state, input)), from.getOutput(state, input));
            }
        });
        return copy;
    }
}
