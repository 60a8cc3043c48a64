package org.evoloop.learn;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.learn.Heard.Reply;
import org.evoloop.learn.Session.Answer;
import org.jspecify.annotations.Nullable;

/**
 * The answers as lines of a file, each written when its word is at its end. The learner asks the same words in the same order
 * when it begins again, so that it gets its answers from here as far as they go. The process may be killed at any time: a line
 * without its end is dropped, and its word is asked again.
 *
 * <p>Threading: for one thread; a file is open in one process only.
 *
 * @since 0.1
 */
public final class AnswerLog implements AutoCloseable {
    private static final String HEAD = "evoloop-learn 1";
    /** Those of a step. */
    private static final int FIELDS = 5;

    private static final Pattern ESCAPED = Pattern.compile("\\\\(.)");
    private static final String ACTS = "\u001f";

    private final FileChannel channel;
    private final Deque<Answer> recorded = new ArrayDeque<>();

    private AnswerLog(FileChannel channel) {
        this.channel = channel;
    }

    /**
     * Opens a file, or begins one.
     *
     * @param file in a folder that exists
     * @param device its name, which must be the one that the file was begun with
     * @throws IOException if it cannot be used; the message says why
     */
    public static AnswerLog open(Path file, String device) throws IOException {
        FileChannel channel =
                FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            lock(channel, file);
            AnswerLog log = new AnswerLog(channel);
            log.read(file, device);
            return log;
        } catch (IOException | RuntimeException unusable) {
            channel.close();
            throw unusable;
        }
    }

    private static void lock(FileChannel channel, Path file) throws IOException {
        try {
            if (channel.tryLock() != null) {
                return;
            }
        } catch (OverlappingFileLockException inThisProcess) {
            // As below.
        }
        throw new IOException(file + " is in use: another process learns with it");
    }

    private void read(Path file, String device) throws IOException {
        String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
        int end = text.lastIndexOf('\n') + 1;
        channel.truncate(text.substring(0, end).getBytes(StandardCharsets.UTF_8).length);
        channel.position(channel.size());
        if (end == 0) {
            write(List.of(HEAD, device));
            return;
        }
        String[] found = text.substring(0, end).split("\n", 0);
        if (!fields(found[0]).equals(List.of(HEAD, device))) {
            throw new IOException(file + ":1 is not what was heard of the device " + device
                    + "; give another folder, or remove the file to begin again");
        }
        for (int i = 1; i < found.length; i++) {
            try {
                recorded.add(answer(fields(found[i])));
            } catch (IllegalArgumentException unreadable) {
                throw new IOException(file + ":" + (i + 1) + " is no line of answers; remove it and what follows");
            }
        }
    }

    private static List<String> fields(String line) {
        return Arrays.stream(line.split("\t", -1)).map(AnswerLog::unescaped).toList();
    }

    /** What {@code word} was answered before; null if it was not asked next then. */
    @Nullable
    Answer recorded(List<String> word) {
        Answer next = recorded.peek();
        return next != null && next.steps().stream().map(Step::input).toList().equals(word) ? recorded.poll() : null;
    }

    /** All that has not been asked for again, which is forgotten: other words are asked now, as other rules hold. */
    List<Answer> rest() {
        List<Answer> rest = List.copyOf(recorded);
        recorded.clear();
        return rest;
    }

    /** A word that was answered. */
    void heard(Answer answer) {
        List<String> line = new ArrayList<>(List.of(answer.atReset()));
        for (Step step : answer.steps()) {
            Heard heard = step.heard();
            line.add(step.input());
            line.add(heard.reply().name());
            line.add(String.join(ACTS, heard.acts()));
            line.add(heard.shown());
            line.add(String.valueOf(heard.after().toMillis()));
        }
        try {
            write(line);
        } catch (IOException full) {
            throw new UncheckedIOException("what was heard could not be written: " + full.getMessage(), full);
        }
    }

    private void write(List<String> line) throws IOException {
        String text = String.join("\t", line.stream().map(AnswerLog::escaped).toList()) + "\n";
        ByteBuffer bytes = ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    private static Answer answer(List<String> line) {
        if (line.size() == 1 || line.size() % FIELDS != 1) {
            throw new IllegalArgumentException("fields are missing");
        }
        List<Step> steps = new ArrayList<>();
        for (int i = 1; i < line.size(); i += FIELDS) {
            String acts = line.get(i + 2);
            steps.add(new Step(
                    line.get(i),
                    new Heard(
                            Reply.valueOf(line.get(i + 1)),
                            acts.isEmpty() ? List.of() : List.of(acts.split(ACTS)),
                            line.get(i + 3),
                            Duration.ofMillis(Long.parseLong(line.get(i + 4))))));
        }
        return new Answer(line.get(0), steps);
    }

    private static String escaped(String field) {
        return field.replace("\\", "\\\\")
                .replace("\t", "\\t")
                .replace("\n", "\\n")
                .replace("\r", "\\r");
    }

    private static String unescaped(String field) {
        return ESCAPED.matcher(field)
                .replaceAll(found -> Matcher.quoteReplacement(
                        switch (found.group(1)) {
                            case "t" -> "\t";
                            case "n" -> "\n";
                            case "r" -> "\r";
                            default -> found.group(1);
                        }));
    }

    /** Closes the file. */
    @Override
    public void close() throws IOException {
        channel.close();
    }
}
