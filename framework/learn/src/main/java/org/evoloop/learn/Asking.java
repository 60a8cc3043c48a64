package org.evoloop.learn;

import de.learnlib.oracle.SingleQueryOracle.SingleQueryOracleMealy;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import net.automatalib.word.Word;
import org.evoloop.learn.Answer.Reply;
import org.evoloop.learn.LearnableDevice.Heard;
import org.evoloop.learn.Run.Step;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/** Answers words from the tree, and asks the device for what is not in it. */
final class Asking implements SingleQueryOracleMealy<String, Answer>, AnswerLog.Content {
    /** How often a word is tried before its answers are called random. */
    private static final int MOST_TRIES = 100;
    /** From this number of runs on, noise is judged. */
    private static final int ENOUGH_RUNS = 20;
    /** The share of runs that contradict others with which voting still works. */
    private static final double MOST_NOISE = 0.4;

    private static final long HOUR_MILLIS = Duration.ofHours(1).toMillis();

    private final LearnableDevice device;
    private final Clock clock;
    private final SafetyRules rules;
    private final Duration longest;
    private final Duration budget;
    private final AnswerTree tree;
    private final Deque<Pressed> lastHour = new ArrayDeque<>();
    private final long beganNanos;
    private @Nullable AnswerLog log;
    private int resets;
    private int presses;

    /** Whether the log ended with a run that was cut off. */
    private boolean cutOff;

    /** Presses up to a time. */
    private record Pressed(long wallMillis, int presses) {}

    /** The algorithm must start again: what it was told is no longer believed. */
    @SuppressWarnings("serial") // never written
    static final class Again extends RuntimeException {}

    /** Learning ends here; the message says why. */
    @SuppressWarnings("serial") // never written
    static final class Stopped extends RuntimeException {
        Stopped(String reason, @Nullable Throwable cause) {
            super(reason, cause);
        }

        String reason() {
            return String.valueOf(getMessage());
        }
    }

    Asking(LearnableDevice device, Clock clock, SafetyRules rules, Duration longest, Duration budget) {
        this.device = device;
        this.clock = clock;
        this.rules = rules;
        this.longest = longest;
        this.budget = budget;
        this.tree = new AnswerTree(rules);
        this.beganNanos = clock.nanoTime();
    }

    void logTo(AnswerLog opened) {
        log = opened;
        if (cutOff) {
            // When it was pressed last is not known.
            pressedUntil(clock.wallTime().toEpochMilli());
        }
    }

    @Override
    public void asked(long wallMillis, int number) {
        lastHour.add(new Pressed(wallMillis, number));
        cutOff = true;
    }

    @Override
    public void ran(Run run) {
        if (cutOff) {
            List<Step> steps = run.steps();
            pressedUntil(lastHour.getLast().wallMillis()
                    + steps.get(steps.size() - 1).startMillis());
            cutOff = false;
        }
        tree.add(run);
    }

    private void pressedUntil(long wallMillis) {
        Pressed last = lastHour.removeLast();
        lastHour.add(new Pressed(wallMillis, last.presses()));
    }

    AnswerTree tree() {
        return tree;
    }

    LearnedModel.Cost cost() {
        return new LearnedModel.Cost(resets, presses, Duration.ofNanos(clock.nanoTime() - beganNanos));
    }

    @Override
    public Word<Answer> answerQuery(Word<String> prefix, Word<String> suffix) {
        List<String> word = new ArrayList<>(prefix.asList());
        word.addAll(suffix.asList());
        List<Answer> answers = ask(word);
        return Word.fromList(answers.subList(prefix.length(), answers.size()));
    }

    /** The answers to a word, without that to the reset. */
    List<Answer> ask(List<String> inputs) {
        List<Answer> answers = askFromReset(inputs);
        return answers.subList(1, answers.size());
    }

    /** What the device shows after a reset. */
    String firstShown() {
        return askFromReset(List.of()).get(0).shows();
    }

    private List<Answer> askFromReset(List<String> inputs) {
        List<String> word = new ArrayList<>();
        word.add(Run.RESET);
        word.addAll(inputs);
        for (int tried = 0; tried < MOST_TRIES; tried++) {
            List<Answer> known = tree.answers(word);
            if (known != null) {
                return known;
            }
            run(tree.withoutIdle(word));
        }
        throw new Stopped(
                "the device is not deterministic: it goes on giving different answers "
                        + tree.dispute(word).orElse("to " + String.join(", ", word)),
                null);
    }

    private void run(List<String> word) {
        if (clock.nanoTime() - beganNanos >= budget.toNanos()) {
            throw new Stopped("the time that learning may take is over", null);
        }
        Run run;
        try {
            awaitTurn(word);
            run = perform(word);
            pressedUntil(clock.wallTime().toEpochMilli());
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new Stopped("learning was interrupted", interrupted);
        } catch (LearnException failed) {
            throw new Stopped(String.valueOf(failed.getMessage()), failed);
        }
        if (log != null) {
            log.ran(run);
        }
        boolean again = tree.add(run);
        int runs = tree.runs().size();
        if (runs >= ENOUGH_RUNS && tree.contradicted() > MOST_NOISE * runs) {
            throw new Stopped(
                    "the device answers at random, or a reset does not lead to one state: " + tree.contradicted()
                            + " of " + runs + " runs contradict the others"
                            + tree.dispute(word)
                                    .map(where -> ", for example " + where)
                                    .orElse(""),
                    null);
        }
        if (again) {
            throw new Again();
        }
    }

    /** Waits until the rule about presses an hour allows the whole word, since a pause inside it would be another word. */
    private void awaitTurn(List<String> word) throws InterruptedException {
        int needed =
                (int) word.stream().filter(input -> !input.equals(Run.WAIT)).count();
        if (rules.mostAnHour().isPresent()) {
            int most = rules.mostAnHour().getAsInt();
            if (needed > most) {
                throw new LearnException("the rule 'at most " + most + " presses an hour' does not allow a word of "
                        + needed + " presses; allow more");
            }
            for (long pause = pauseMillis(needed, most); pause > 0; pause = pauseMillis(needed, most)) {
                clock.sleep(Duration.ofMillis(pause));
            }
        }
        long now = clock.wallTime().toEpochMilli();
        lastHour.add(new Pressed(now, needed));
        if (log != null) {
            log.asks(now, needed);
        }
    }

    private long pauseMillis(int needed, int most) {
        long now = clock.wallTime().toEpochMilli();
        lastHour.removeIf(pressed -> pressed.wallMillis() <= now - HOUR_MILLIS);
        int sum = needed + lastHour.stream().mapToInt(Pressed::presses).sum();
        long pause = 0;
        for (Pressed oldest : lastHour) {
            if (sum <= most) {
                break;
            }
            sum -= oldest.presses();
            pause = Math.max(pause, oldest.wallMillis() + HOUR_MILLIS - now);
        }
        return pause;
    }

    private Run perform(List<String> word) throws InterruptedException {
        long began = clock.nanoTime();
        List<Step> steps = new ArrayList<>();
        String shows = "";
        for (String input : word) {
            if (rules.forbids(input, shows).isPresent()) {
                continue;
            }
            long start = clock.nanoTime();
            Heard heard = hear(input);
            steps.add(new Step(input, heard.answer(), millis(start - began), millis(heard.firstNanos() - began)));
            shows = heard.answer().shows();
        }
        return new Run(steps);
    }

    private static long millis(long nanos) {
        return Duration.ofNanos(nanos).toMillis();
    }

    private Heard hear(String input) throws InterruptedException {
        if (input.equals(Run.RESET)) {
            resets++;
            return device.reset();
        }
        if (!input.equals(Run.WAIT)) {
            presses++;
            return device.press(input);
        }
        Heard heard = device.await(longest);
        if (heard.answer().reply() != Reply.WAITED) {
            throw new IllegalStateException("the device answered '" + heard.answer() + "' to a wait");
        }
        return heard;
    }
}
