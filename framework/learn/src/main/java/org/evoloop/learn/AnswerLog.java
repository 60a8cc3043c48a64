package org.evoloop.learn;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jspecify.annotations.Nullable;

/**
 * The file of all runs, a line for each, on disk before it counts. A line before each run says how much it will press, so
 * that a run that was cut off still counts for {@code at most N presses an hour}.
 */
final class AnswerLog implements AutoCloseable {
    private static final String ASK = "ask ";
    private static final String RUN = "run ";

    /** Null if nothing is kept. */
    private final @Nullable FileChannel channel;

    private final String name;

    private AnswerLog(@Nullable FileChannel channel, String name) {
        this.channel = channel;
        this.name = name;
    }

    /** What is in the file. */
    interface Content {
        void asked(long wallMillis, int presses);

        void ran(Run run);
    }

    /**
     * Opens or creates the file and reads it.
     *
     * @param file null if nothing is to be kept
     * @param head its first line, which says what was learned: a file with another one is refused
     */
    static AnswerLog open(@Nullable Path file, String head, Content content) {
        if (file == null) {
            return new AnswerLog(null, "");
        }
        FileChannel channel = null;
        try {
            channel = FileChannel.open(
                    file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
            if (channel.tryLock() == null) {
                throw new OverlappingFileLockException();
            }
            AnswerLog log = new AnswerLog(channel, file.toString());
            log.read(head, content);
            return log;
        } catch (OverlappingFileLockException busy) {
            close(channel);
            throw new LearnException(
                    file + " is in use: another learning writes to it; end that one or name another file", busy);
        } catch (IOException failed) {
            close(channel);
            throw new LearnException(file + " cannot be used: " + failed, failed);
        } catch (LearnException refused) {
            close(channel);
            throw refused;
        }
    }

    private static void close(@Nullable FileChannel channel) {
        if (channel != null) {
            try {
                channel.close();
            } catch (IOException failed) {
                throw new LearnException("the file of learning cannot be closed: " + failed, failed);
            }
        }
    }

    private void read(String head, Content content) throws IOException {
        FileChannel from = requireNonNull(channel);
        ByteBuffer bytes = ByteBuffer.allocate(Math.toIntExact(from.size()));
        while (bytes.hasRemaining() && from.read(bytes) >= 0) {
            // Read to the end.
        }
        String text = new String(bytes.array(), StandardCharsets.ISO_8859_1);
        int whole = text.lastIndexOf('\n') + 1;
        // What follows the last line's end was cut off.
        from.truncate(whole);
        from.position(whole);
        if (whole == 0) {
            append(head);
            return;
        }
        String[] lines = text.substring(0, whole).split("\n", -1);
        if (!lines[0].equals(head)) {
            throw new LearnException(name + ", line 1: it is about '" + lines[0] + "', but what is to be learned is '"
                    + head + "'; name another file");
        }
        for (int i = 1; i < lines.length - 1; i++) {
            readLine(lines[i], i + 1, content);
        }
    }

    private void readLine(String line, int number, Content content) {
        try {
            if (line.startsWith(RUN)) {
                content.ran(Run.read(line.substring(RUN.length())));
            } else if (line.startsWith(ASK)) {
                String[] parts = line.substring(ASK.length()).split(" ", 2);
                content.asked(Long.parseLong(parts[0]), Integer.parseInt(parts[1]));
            } else {
                throw new IllegalArgumentException("it begins with neither '" + RUN + "' nor '" + ASK + "'");
            }
        } catch (IllegalArgumentException | ArrayIndexOutOfBoundsException damaged) {
            throw new LearnException(
                    name + ", line " + number + " is damaged; delete that line, which costs its answers, or the file",
                    damaged);
        }
    }

    /** Says before a run how much it will press. */
    void asks(long wallMillis, int presses) {
        append(ASK + wallMillis + " " + presses);
    }

    void ran(Run run) {
        append(RUN + run.line());
    }

    private void append(String line) {
        if (channel == null) {
            return;
        }
        try {
            ByteBuffer bytes = ByteBuffer.wrap((line + "\n").getBytes(StandardCharsets.ISO_8859_1));
            while (bytes.hasRemaining()) {
                channel.write(bytes);
            }
            channel.force(false);
        } catch (IOException failed) {
            throw new LearnException(name + " cannot be written: " + failed, failed);
        }
    }

    @Override
    public void close() {
        close(channel);
    }
}
