package org.evoloop.mqtt.edge;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * What devices have told and the receiver may not have yet, in a file: a line each, on the disk before it counts. The
 * number of a line is never given twice, so that the receiver knows what comes again.
 *
 * <p>Errors: if the directory cannot be used, {@link UncheckedIOException}.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Outbox implements AutoCloseable {
    private static final char BETWEEN = '\t';

    private final Path positionFile;
    private final FileChannel lines;
    private final List<Entry> waiting = new ArrayList<>();
    private long number;
    private long sent;

    /**
     * One line.
     *
     * @param number of this outbox
     * @param topic where it is to go
     */
    public record Entry(long number, String topic, String device, String record) {}

    /**
     * What is kept in {@code directory}, which is made if it is not there.
     *
     * @param before the numbers begin after this one if nothing was kept there yet
     */
    public Outbox(Path directory, long before) {
        Path file = directory.resolve("outbox");
        positionFile = directory.resolve("outbox.sent");
        try {
            Files.createDirectories(directory);
            sent = Files.exists(positionFile)
                    ? Long.parseLong(Files.readString(positionFile).strip())
                    : before;
            number = sent;
            read(file);
            lines = FileChannel.open(
                    file, StandardOpenOption.CREATE, StandardOpenOption.WRITE, StandardOpenOption.APPEND);
        } catch (IOException e) {
            throw new UncheckedIOException(directory + " cannot be used: " + e.getMessage(), e);
        }
    }

    /** A line that was not written to its end was never told of; it is cut off. */
    private void read(Path file) throws IOException {
        if (!Files.exists(file)) {
            return;
        }
        String text = Files.readString(file);
        int whole = text.lastIndexOf('\n') + 1;
        for (String line : text.substring(0, whole).lines().toList()) {
            String[] parts = line.split(String.valueOf(BETWEEN), 4);
            long its = Long.parseLong(parts[0]);
            number = Math.max(number, its);
            if (its > sent) {
                waiting.add(new Entry(its, parts[1], parts[2], parts[3]));
            }
        }
        if (whole < text.length()) {
            try (RandomAccessFile whatIs = new RandomAccessFile(file.toFile(), "rw")) {
                whatIs.setLength(text.substring(0, whole).getBytes(StandardCharsets.UTF_8).length);
            }
        }
    }

    /** One more; when this returns, it is on the disk. */
    public synchronized void add(String topic, String device, String record) {
        Entry entry = new Entry(number + 1, topic, device, record.replace('\n', ' '));
        String line = entry.number + String.valueOf(BETWEEN) + topic + BETWEEN + device + BETWEEN + entry.record + '\n';
        try {
            ByteBuffer bytes = ByteBuffer.wrap(line.getBytes(StandardCharsets.UTF_8));
            while (bytes.hasRemaining()) {
                lines.write(bytes);
            }
            lines.force(false);
        } catch (IOException e) {
            throw new UncheckedIOException("the outbox cannot be written: " + e.getMessage(), e);
        }
        number++;
        waiting.add(entry);
        notifyAll();
    }

    /** The first that wait, {@code most} at most; waits for one for {@code limitMillis}. */
    public synchronized List<Entry> first(int most, long limitMillis) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(limitMillis);
        for (long left = limitMillis; waiting.isEmpty() && left > 0; ) {
            wait(left);
            left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
        }
        return List.copyOf(waiting.subList(0, Math.min(most, waiting.size())));
    }

    /** All up to this number is where it is for. */
    public synchronized void sent(long last) {
        if (last <= sent || last > number) {
            return;
        }
        waiting.removeIf(entry -> entry.number <= last);
        sent = last;
        try {
            Files.writeString(positionFile, sent + "\n");
            if (waiting.isEmpty()) {
                lines.truncate(0);
            }
        } catch (IOException e) {
            throw new UncheckedIOException("the outbox cannot be written: " + e.getMessage(), e);
        }
    }

    /** How many wait. */
    public synchronized int size() {
        return waiting.size();
    }

    @Override
    public synchronized void close() {
        try {
            lines.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
