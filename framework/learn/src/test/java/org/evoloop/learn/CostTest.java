package org.evoloop.learn;

import static org.assertj.core.api.Assertions.assertThat;

import de.learnlib.acex.AcexAnalyzers;
import de.learnlib.algorithm.ttt.mealy.TTTLearnerMealy;
import de.learnlib.oracle.SingleQueryOracle.SingleQueryOracleMealy;
import de.learnlib.query.DefaultQuery;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import net.automatalib.alphabet.Alphabet;
import net.automatalib.alphabet.impl.Alphabets;
import net.automatalib.automaton.transducer.MealyMachine;
import net.automatalib.util.automaton.conformance.WpMethodTestsIterator;
import net.automatalib.word.Word;
import org.junit.jupiter.api.Test;

/** What learning costs, beside LearnLib as it is: TTT, Wp with depth 1, a cache of words, and waiting as any input. */
class CostTest {
    private static final int SEEDS = 30;
    private static final int MOST_STATES = 16;

    @Test
    void learningCostsLessThanPlainLearnLib() throws InterruptedException {
        StringBuilder table = new StringBuilder("seed states inputs timers: resets, time; plain resets, time\n");
        int resets = 0;
        int plainResets = 0;
        long seconds = 0;
        long plainSeconds = 0;
        for (int seed = 1; seed <= SEEDS; seed++) {
            SteppedClock clock = new SteppedClock();
            SimulatedMachine device = SimulatedMachine.random(clock, seed, MOST_STATES);
            LearnedModel.Cost cost =
                    Learning.of("learned", device, clock, device.inputs).learn().cost();
            SteppedClock other = new SteppedClock();
            int plain = plain(SimulatedMachine.random(other, seed, MOST_STATES));
            long time = Duration.ofNanos(other.nanoTime()).toSeconds();
            table.append(String.format(
                    "%d %d %d %d: %d, %d s; %d, %d s%n",
                    seed,
                    device.shown.size(),
                    device.inputs.size(),
                    device.timers.size(),
                    cost.resets(),
                    cost.time().toSeconds(),
                    plain,
                    time));
            resets += cost.resets();
            plainResets += plain;
            seconds += cost.time().toSeconds();
            plainSeconds += time;
        }
        table.append(String.format("all: %d, %d s; %d, %d s%n", resets, seconds, plainResets, plainSeconds));

        System.out.print(table);
        assertThat(resets).as(table.toString()).isLessThanOrEqualTo(plainResets);
        assertThat(seconds).as(table.toString()).isLessThanOrEqualTo(plainSeconds * 6 / 10);
    }

    /** Returns how often the device was reset. */
    private static int plain(SimulatedMachine device) {
        List<String> inputs = new ArrayList<>(device.inputs);
        inputs.add(Run.WAIT);
        Alphabet<String> alphabet = Alphabets.fromList(inputs);
        Cached oracle = new Cached(device);
        TTTLearnerMealy<String, Answer> learner =
                new TTTLearnerMealy<>(alphabet, oracle, AcexAnalyzers.BINARY_SEARCH_BWD);
        learner.startLearning();
        boolean refined = true;
        while (refined) {
            refined = false;
            MealyMachine<?, String, ?, Answer> machine = learner.getHypothesisModel();
            Iterator<Word<String>> words = new WpMethodTestsIterator<>(machine, alphabet, 1);
            while (!refined && words.hasNext()) {
                Word<String> word = words.next();
                Word<Answer> answers = oracle.answerQuery(Word.epsilon(), word);
                refined = !answers.equals(machine.computeOutput(word));
                if (refined) {
                    learner.refineHypothesis(new DefaultQuery<>(word, answers));
                }
            }
        }
        return oracle.resets;
    }

    /** Asks the device for each word that is no beginning of an earlier one. */
    private static final class Cached implements SingleQueryOracleMealy<String, Answer> {
        private final Map<List<String>, List<Answer>> known = new HashMap<>();
        private final SimulatedMachine device;
        private int resets;

        Cached(SimulatedMachine device) {
            this.device = device;
        }

        @Override
        public Word<Answer> answerQuery(Word<String> prefix, Word<String> suffix) {
            List<String> word = prefix.concat(suffix).asList();
            List<Answer> answers = known.get(word);
            if (answers == null) {
                answers = perform(word);
                for (int length = 0; length <= word.size(); length++) {
                    known.put(List.copyOf(word.subList(0, length)), List.copyOf(answers.subList(0, length)));
                }
            }
            return Word.fromList(answers.subList(prefix.length(), answers.size()));
        }

        private List<Answer> perform(List<String> word) {
            List<Answer> answers = new ArrayList<>();
            try {
                resets++;
                device.reset();
                for (String input : word) {
                    answers.add((input.equals(Run.WAIT) ? device.await(Duration.ofMinutes(1)) : device.press(input))
                            .answer());
                }
            } catch (InterruptedException never) {
                throw new IllegalStateException(never);
            }
            return answers;
        }
    }
}
