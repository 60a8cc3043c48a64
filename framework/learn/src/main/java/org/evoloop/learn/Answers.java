package org.evoloop.learn;

import de.learnlib.oracle.MembershipOracle.MealyMembershipOracle;
import de.learnlib.query.Query;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import net.automatalib.word.Word;
import net.automatalib.word.WordBuilder;
import org.evoloop.learn.AnswerTree.Contradiction;
import org.evoloop.learn.AnswerTree.Edge;
import org.evoloop.learn.AnswerTree.Node;
import org.jspecify.annotations.Nullable;

/** Answers the learner's questions, from the tree where it can. */
final class Answers implements MealyMembershipOracle<String, String> {
    /** An input that asks what the device shows. It costs nothing: each answer says that already. */
    static final String LOOK = " ";

    /** How often a question is put again to settle a contradiction. */
    private static final int MOST_VOTES = 9;

    /** By how much one answer must lead. */
    private static final int LEAD = 3;

    /** An answer that was heard so often was true once: if it no longer is, the device has changed. */
    private static final int WELL_KNOWN = 3;

    private static final int MOST_CUTS = 30;

    /** What a reset does not undo, such as a mode that the device does not tell, looks like a change. */
    private static final String REMEDY =
            "; see that learn.reset undoes all that can be pressed, also what the device does not"
                    + " tell, that learn.settle is long enough, and learn it again, with a new journal";

    private final AnswerTree tree = new AnswerTree();
    private final Session session;
    private final @Nullable AnswerLog log;
    /** How often an answer has to be heard: twice as soon as the device has contradicted itself. */
    private int needed = 1;

    private int cuts;
    private boolean rootIsKnown;

    Answers(Session session, @Nullable AnswerLog log) {
        this.session = session;
        this.log = log;
    }

    /** The tree was wrong, and has been cut; whatever was concluded from it is void. */
    static final class AgainException extends RuntimeException {
        private static final long serialVersionUID = 1;

        AgainException() {
            super("an answer was wrong", null, false, false);
        }
    }

    AnswerTree tree() {
        return tree;
    }

    @Override
    public void processQueries(Collection<? extends Query<String, Word<String>>> queries) {
        // A long word answers all that it begins with.
        queries.stream()
                .sorted(Comparator.comparingInt(
                        (Query<String, Word<String>> query) -> -query.getInput().length()))
                .forEach(query -> {
                    Word<String> outputs = outputs(query.getInput().asList());
                    query.answer(outputs.suffix(query.getSuffix().length()));
                });
    }

    /** What the device answers to each of {@code inputs}. */
    Word<String> outputs(List<String> inputs) {
        int attempts = 0;
        while (true) {
            WordBuilder<String> outputs = new WordBuilder<>();
            Node node = tree.root();
            int known = 0;
            for (String input : inputs) {
                if (input.equals(LOOK) && rootIsKnown) {
                    outputs.append(node.shown());
                    known++;
                    continue;
                }
                Edge edge = node.edge(input);
                if (edge == null || (edge.seen() < needed && edge.heard().reply() != Heard.Reply.FORBIDDEN)) {
                    break;
                }
                outputs.append(edge.heard().output());
                node = edge.target();
                known++;
            }
            if (known == inputs.size()) {
                return outputs.toWord();
            }
            attempts++;
            if (attempts > MOST_VOTES * inputs.size()) {
                throw new OpenEndException("no two answers are the same after " + names(inputs));
            }
            List<String> word = new ArrayList<>(node.path());
            word.addAll(withoutLooks(inputs.subList(known, inputs.size())));
            ask(word);
        }
    }

    /** Makes sure that the answer to the last of {@code example} was heard more than once. */
    void confirm(List<String> example) {
        List<String> inputs = withoutLooks(example);
        if (inputs.isEmpty()) {
            return;
        }
        Node node = tree.at(inputs.subList(0, inputs.size() - 1));
        String last = inputs.get(inputs.size() - 1);
        Edge edge = node == null ? null : node.edge(last);
        if (node != null && edge != null && edge.seen() < 2) {
            List<String> word = node.path();
            word.add(last);
            ask(word);
        }
    }

    private static List<String> withoutLooks(List<String> inputs) {
        return inputs.stream().filter(input -> !input.equals(LOOK)).toList();
    }

    private void ask(List<String> word) {
        Contradiction contradiction = keep(put(word));
        if (contradiction != null) {
            settle(contradiction);
        }
    }

    private Session.Answer put(List<String> word) {
        Session.Answer before = log == null ? null : log.recorded(word);
        if (before != null) {
            return before;
        }
        if (log != null) {
            log.rest().forEach(this::keep);
        }
        try {
            Session.Answer answer = session.ask(word);
            if (log != null) {
                log.heard(answer);
            }
            return answer;
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new OpenEndException("it was stopped");
        }
    }

    private @Nullable Contradiction keep(Session.Answer answer) {
        if (!rootIsKnown) {
            tree.rootShows(answer.atReset());
            rootIsKnown = true;
        } else if (!tree.root().shown().equals(answer.atReset())) {
            throw new OpenEndException(
                    "after a reset the device shows '" + answer.atReset() + "', and before it showed '"
                            + tree.root().shown() + "'; home or reset of the file does not bring it to one place");
        }
        return tree.add(answer.steps());
    }

    /** Votes on an answer. If the tree was wrong, it is cut there, and learning begins again. */
    private void settle(Contradiction contradiction) {
        needed = 2;
        Node node = contradiction.at();
        String input = contradiction.step().input();
        List<String> word = node.path();
        word.add(input);
        Edge edge = node.edge(input);
        if (edge == null) {
            return;
        }
        String before = edge.heard().output();
        Map<String, Integer> votes = new LinkedHashMap<>();
        // No more, so that a device that has changed can still outvote what it once said.
        votes.put(before, Math.min(edge.seen(), LEAD));
        votes.put(contradiction.step().heard().output(), 1);
        for (int i = 0; i < MOST_VOTES; i++) {
            Session.Answer answer = put(word);
            Contradiction again = keep(answer);
            if (again != null && again.at() != node) {
                // Something on the way: its node is nearer to the reset, so this ends.
                settle(again);
                continue;
            }
            String output = again == null ? before : again.step().heard().output();
            int count = votes.merge(output, 1, Integer::sum);
            if (votes.entrySet().stream()
                    .allMatch(other -> other.getKey().equals(output) || other.getValue() + LEAD <= count)) {
                decide(node, input, edge, output);
                return;
            }
        }
        throw new OpenEndException("unstable: after " + names(node.path()) + ", " + name(input) + " is answered by "
                + String.join(
                        ", ",
                        votes.entrySet().stream()
                                .map(vote -> "'" + readable(vote.getKey()) + "' (" + vote.getValue() + " times)")
                                .toList())
                + REMEDY);
    }

    private void decide(Node node, String input, Edge edge, String output) {
        if (output.equals(edge.heard().output())) {
            return;
        }
        cuts++;
        AnswerTree.cut(node, input);
        if (edge.seen() >= WELL_KNOWN || cuts > MOST_CUTS) {
            throw new OpenEndException("the device has changed while it was learned, or is unstable: after "
                    + names(node.path()) + ", "
                    + name(input) + " was answered by '" + readable(edge.heard().output()) + "' (" + edge.seen()
                    + " times), and now by '" + readable(output) + "'" + REMEDY);
        }
        throw new AgainException();
    }

    private static String readable(String output) {
        return output.replaceFirst("^>", "");
    }

    static String name(String input) {
        return input.equals(LearnedDevice.WAIT) ? "waiting" : input;
    }

    static String names(List<String> inputs) {
        return inputs.isEmpty()
                ? "the reset"
                : String.join(", ", inputs.stream().map(Answers::name).toList());
    }
}
