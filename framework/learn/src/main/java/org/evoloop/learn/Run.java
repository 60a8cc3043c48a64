package org.evoloop.learn;

import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.learn.Answer.Reply;

/**
 * What happened from one reset on; the first step is the reset. As a line of the log, its end is marked, so that one that
 * was cut off is recognized.
 */
record Run(List<Step> steps) {
    /** The input that is a reset, that is waiting, or only looking. No event has a name in parentheses. */
    static final String RESET = "(reset)";

    static final String WAIT = "(wait)";
    static final String LOOK = "(look)";

    private static final String END = ".";

    /**
     * A step; its times are milliseconds since the run began.
     *
     * @param startMillis when it was pressed
     * @param firstMillis when the first sign of the answer came
     */
    record Step(String input, Answer answer, long startMillis, long firstMillis) {
        private String line() {
            return String.join(
                    "|",
                    escaped(input),
                    answer.reply().name(),
                    answer.acts().stream().map(Step::escaped).collect(Collectors.joining(",")),
                    escaped(answer.shows()),
                    Long.toString(startMillis),
                    Long.toString(firstMillis));
        }

        private static Step read(String text) {
            String[] parts = text.split("\\|", -1);
            List<String> acts = parts[2].isEmpty()
                    ? List.of()
                    : Arrays.stream(parts[2].split(",", -1)).map(Step::plain).toList();
            Answer answer = new Answer(Reply.valueOf(parts[1]), acts, plain(parts[3]));
            return new Step(plain(parts[0]), answer, Long.parseLong(parts[4]), Long.parseLong(parts[5]));
        }

        private static String escaped(String text) {
            return URLEncoder.encode(text, StandardCharsets.UTF_8);
        }

        private static String plain(String text) {
            return URLDecoder.decode(text, StandardCharsets.UTF_8);
        }
    }

    Run {
        steps = List.copyOf(steps);
    }

    String line() {
        return steps.stream().map(Step::line).collect(Collectors.joining(" ")) + " " + END;
    }

    /**
     * The run that {@link #line()} wrote.
     *
     * @throws IllegalArgumentException if it is none
     */
    static Run read(String line) {
        List<String> parts = Arrays.asList(line.split(" ", -1));
        List<Step> steps = new ArrayList<>();
        try {
            for (String part : parts.subList(0, parts.size() - 1)) {
                steps.add(Step.read(part));
            }
        } catch (ArrayIndexOutOfBoundsException tooShort) {
            throw new IllegalArgumentException("a step has too few parts", tooShort);
        }
        if (!parts.get(parts.size() - 1).equals(END) || steps.isEmpty()) {
            throw new IllegalArgumentException("the line has no end");
        }
        return new Run(steps);
    }
}
