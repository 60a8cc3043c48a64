package org.evoloop.learn;

import static org.assertj.core.api.Assertions.assertThat;

import de.learnlib.acex.AcexAnalyzers;
import de.learnlib.algorithm.ttt.mealy.TTTLearnerMealy;
import de.learnlib.oracle.MembershipOracle.MealyMembershipOracle;
import de.learnlib.query.DefaultQuery;
import de.learnlib.query.Query;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import net.automatalib.alphabet.Alphabet;
import net.automatalib.alphabet.impl.Alphabets;
import net.automatalib.automaton.transducer.MealyMachine;
import net.automatalib.util.automaton.conformance.WpMethodTestsIterator;
import net.automatalib.word.Word;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** Random machines are learned exactly, with less of the device's time than by LearnLib alone. */
class RandomMachinesTest {
    private static final int SEEDS = Integer.getInteger("evoloop.learn.seeds", 30);
    private static final LearnSettings SETTINGS = new LearnSettings(Duration.ofMinutes(1), Duration.ofDays(3_650), 1);

    /** What it took. */
    private record Cost(int resets, Duration time) {}

    @Test
    void theyAreLearnedExactlyAndInLessTime() {
        List<String> wrong = new ArrayList<>();
        long[] resets = new long[2];
        long[] seconds = new long[2];
        for (long seed = 0; seed < SEEDS; seed++) {
            RandomDevice device = RandomDevice.of(seed, new ManualClock());
            long begin = device.clock.nanoTime();
            Learned learned = new Learner(
                            device,
                            device.inputs,
                            LearnRules.NONE,
                            SETTINGS,
                            device.clock,
                            null,
                            null,
                            (soFar, expected) -> {})
                    .learn();
            String difference = device.differs(learned);
            if (!difference.isEmpty() || !learned.open().isEmpty()) {
                wrong.add("seed " + seed + ": " + difference + learned.open());
            }
            Duration took = Duration.ofNanos(device.clock.nanoTime() - begin);
            Cost plain = plain(RandomDevice.of(seed, new ManualClock()));
            resets[0] += device.resets;
            resets[1] += plain.resets();
            seconds[0] += took.toSeconds();
            seconds[1] += plain.time().toSeconds();
            System.out.printf(
                    "%4d %2d states %d inputs: resets %6d of %6d, %.2f; time %.2f%n",
                    seed,
                    device.next.length,
                    device.inputs.size(),
                    device.resets,
                    plain.resets(),
                    (double) device.resets / plain.resets(),
                    (double) took.toSeconds() / plain.time().toSeconds());
        }
        System.out.printf(
                "all: resets %.2f, time %.2f%n", (double) resets[0] / resets[1], (double) seconds[0] / seconds[1]);

        assertThat(wrong).isEmpty();
        assertThat(resets[0]).isLessThanOrEqualTo(resets[1]);
        assertThat((double) seconds[0]).isLessThanOrEqualTo(0.6 * seconds[1]);
    }

    /** LearnLib alone, with waiting as any other input, and with a cache. */
    private static Cost plain(RandomDevice device) {
        long begin = device.clock.nanoTime();
        List<String> inputs = new ArrayList<>(device.inputs);
        inputs.add(LearnedDevice.WAIT);
        Alphabet<String> alphabet = Alphabets.fromList(inputs);
        Cached oracle = new Cached(device);
        TTTLearnerMealy<String, String> learner =
                new TTTLearnerMealy<>(alphabet, oracle, AcexAnalyzers.BINARY_SEARCH_BWD);
        learner.startLearning();
        boolean refined = true;
        while (refined) {
            refined = false;
            MealyMachine<?, String, ?, String> hypothesis = learner.getHypothesisModel();
            WpMethodTestsIterator<String> words = new WpMethodTestsIterator<>(hypothesis, alphabet, 1);
            while (!refined && words.hasNext()) {
                Word<String> word = words.next();
                Word<String> outputs = oracle.answerQuery(word);
                if (!outputs.equals(hypothesis.computeOutput(word))) {
                    refined = learner.refineHypothesis(new DefaultQuery<>(Word.epsilon(), word, outputs));
                }
            }
        }
        return new Cost(device.resets, Duration.ofNanos(device.clock.nanoTime() - begin));
    }

    /** Asks the device what is not a beginning of what was asked before. */
    private static final class Cached implements MealyMembershipOracle<String, String> {
        private final RandomDevice device;
        private final Map<Word<String>, String> known = new HashMap<>();

        Cached(RandomDevice device) {
            this.device = device;
        }

        @Override
        public void processQueries(Collection<? extends Query<String, Word<String>>> queries) {
            for (Query<String, Word<String>> query : queries) {
                Word<String> word = query.getInput();
                if (!word.isEmpty() && !known.containsKey(word)) {
                    device.reset();
                    for (int i = 0; i < word.length(); i++) {
                        String input = word.getSymbol(i);
                        Heard heard = input.equals(LearnedDevice.WAIT)
                                ? device.await(SETTINGS.longest())
                                : device.press(input);
                        known.put(word.prefix(i + 1), heard.output());
                    }
                }
                List<String> outputs = new ArrayList<>();
                for (int i = query.getPrefix().length(); i < word.length(); i++) {
                    outputs.add(String.valueOf(known.get(word.prefix(i + 1))));
                }
                query.answer(Word.fromList(outputs));
            }
        }
    }
}
