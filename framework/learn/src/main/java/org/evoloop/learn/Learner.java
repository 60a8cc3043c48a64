package org.evoloop.learn;

import de.learnlib.acex.AcexAnalyzers;
import de.learnlib.algorithm.ttt.mealy.TTTLearnerMealy;
import de.learnlib.query.DefaultQuery;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.automatalib.alphabet.impl.Alphabets;
import net.automatalib.word.Word;
import org.evoloop.learn.Answers.AgainException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Learns a device.
 *
 * <p>Threading: for one thread; to stop it, interrupt the thread.
 *
 * @since 0.1
 */
public final class Learner {
    private final List<String> inputs;
    private final Set<String> never;
    private final LearnSettings settings;
    private final Session session;
    private final Answers answers;
    private final LearnProgress progress;
    private final @Nullable StateMachine first;
    private List<String> names = List.of();
    private int depth;
    private @Nullable Mealy best;

    /**
     * @param device what is learned
     * @param events what can be sent to it
     * @param rules what must not be done
     * @param settings how
     * @param clock the device's time
     * @param first a model that is tested before anything else; what it explains is learned with few presses. Null for none
     * @param log where answers are kept, and what was answered before; null to keep none
     * @param progress is told how far it is
     */
    public Learner(
            LearnedDevice device,
            List<String> events,
            LearnRules rules,
            LearnSettings settings,
            Clock clock,
            @Nullable StateMachine first,
            @Nullable AnswerLog log,
            LearnProgress progress) {
        this.never = new HashSet<>(events);
        never.retainAll(rules.never());
        this.inputs = new ArrayList<>(
                events.stream().filter(event -> !never.contains(event)).toList());
        if (inputs.isEmpty()) {
            throw new IllegalArgumentException("there is nothing that may be sent to the device");
        }
        inputs.add(LearnedDevice.WAIT);
        inputs.add(Answers.LOOK);
        this.first = first;
        this.depth = settings.depth();
        this.settings = settings;
        this.session = new Session(device, rules, settings, clock);
        this.answers = new Answers(session, log);
        this.progress = progress;
    }

    /**
     * Learns until the test is passed, or something ends it. Then the device is reset, also if the thread was interrupted.
     */
    public Learned learn() {
        String open = "";
        try {
            boolean done = false;
            while (!done) {
                try {
                    done = isConfirmed() || isLearned();
                } catch (AgainException wrong) {
                    // The learner begins again with what is left of the tree.
                    done = false;
                }
            }
        } catch (OpenEndException end) {
            open = String.valueOf(end.getMessage());
        }
        String left = session.leave();
        return soFar(open + (open.isEmpty() || left.isEmpty() ? "" : "; ") + left);
    }

    private Learned soFar(String open) {
        return Learned.of(best, answers.tree(), names, never, depth, session.words(), session.elapsed(), open);
    }

    private void tell(int expected) {
        progress.at(soFar("it is still being learned"), expected);
    }

    /** Whether the first model explains every answer to the words that test its transitions. */
    private boolean isConfirmed() {
        if (first == null) {
            return false;
        }
        answers.outputs(List.of(Answers.LOOK));
        boolean shows = !answers.tree().root().shown().isEmpty();
        Declared declared = new Declared(first, inputs, settings.longest(), shows);
        Suite suite = new Suite(declared.hypothesis());
        if (!suite.tellsAllApart()) {
            return false;
        }
        List<List<String>> words = suite.words(0);
        for (int i = 0; i < words.size(); i++) {
            answers.outputs(words.get(i));
            Mealy confirmed = declared.confirmed(answers.tree().root());
            if (confirmed == null) {
                return false;
            }
            best = confirmed;
            names = declared.names();
            tell(words.size() - i - 1);
        }
        depth = 0;
        return true;
    }

    /** Learns without a model; true when its hypothesis has passed its test. */
    private boolean isLearned() {
        best = null;
        names = List.of();
        TTTLearnerMealy<String, String> learner =
                new TTTLearnerMealy<>(Alphabets.fromList(inputs), answers, AcexAnalyzers.BINARY_SEARCH_BWD);
        learner.startLearning();
        while (true) {
            Mealy hypothesis = Mealy.of(learner.getHypothesisModel(), inputs);
            best = hypothesis;
            List<String> example = counterexample(hypothesis);
            if (example == null) {
                return true;
            }
            DefaultQuery<String, Word<String>> query = new DefaultQuery<>(Word.fromList(example));
            query.answer(answers.outputs(example));
            if (!learner.refineHypothesis(query)) {
                throw new IllegalStateException("the learner does not take " + example);
            }
        }
    }

    private @Nullable List<String> counterexample(Mealy hypothesis) {
        List<String> known = inTree(hypothesis, answers.tree().root(), 0);
        if (known != null) {
            return known;
        }
        List<List<String>> words = new Suite(hypothesis).words(settings.depth());
        tell(words.size());
        for (int i = 0; i < words.size(); i++) {
            List<String> word = words.get(i);
            int before = session.words();
            int length = differs(hypothesis, word, answers.outputs(word));
            if (length > 0) {
                List<String> example = word.subList(0, length);
                answers.confirm(example);
                return example;
            }
            if (session.words() > before) {
                tell(words.size() - i - 1);
            }
        }
        return null;
    }

    /** The number of inputs up to the first answer that the hypothesis does not give; 0 if it gives all. */
    private static int differs(Mealy hypothesis, List<String> word, Word<String> outputs) {
        int state = 0;
        for (int i = 0; i < word.size(); i++) {
            int input = hypothesis.input(word.get(i));
            if (!hypothesis.outputs()[state][input].equals(outputs.getSymbol(i))) {
                return i + 1;
            }
            state = hypothesis.next()[state][input];
        }
        return 0;
    }

    /** Something that was heard before, and that the hypothesis does not answer; null if there is nothing. */
    private @Nullable List<String> inTree(Mealy hypothesis, AnswerTree.Node node, int state) {
        if (!hypothesis.outputs()[state][hypothesis.input(Answers.LOOK)].equals(node.shown())) {
            List<String> example = node.path();
            example.add(Answers.LOOK);
            answers.confirm(example);
            return example;
        }
        for (Map.Entry<String, AnswerTree.Edge> next : node.edges().entrySet()) {
            int input = hypothesis.input(next.getKey());
            AnswerTree.Edge edge = next.getValue();
            if (input < 0) {
                continue;
            }
            if (!hypothesis.outputs()[state][input].equals(edge.heard().output())) {
                List<String> example = node.path();
                example.add(next.getKey());
                answers.confirm(example);
                return example;
            }
            if (edge.target() != node) {
                List<String> below =
                        inTree(hypothesis, edge.target(), hypothesis.next()[state][input]);
                if (below != null) {
                    return below;
                }
            }
        }
        return null;
    }
}
