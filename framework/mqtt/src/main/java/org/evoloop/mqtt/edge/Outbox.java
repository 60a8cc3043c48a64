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
 * Records of devices that the receiver may not have yet, in a file with one line each, which is on the disk before the
 * record counts. A line's number is never used again, so the receiver can recognise repetitions.
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
     * A record.
     *
     * @param number its number in this outbox
     * @param topic its destination
     */
    public record Entry(long number, String topic, String device, String record) {}

    /**
     * Opens the outbox in {@code directory}, which is created if necessary.
     *
     * @param before the number before the first one, in a new outbox
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

    /** An incomplete last line does not count; it is cut off. */
    private void read(Path file) throws IOException {
        if (!Files.exists(file)) {
            return;
        }
        String text = Files.readString(file);
        int whole = text.lastIndexOf('\n') + 1;
        for (String line : text.substring(0, whole).lines().toList()) {
            String[] parts = line.split(String.valueOf(BETWEEN), 4);
            long own = Long.parseLong(parts[0]);
            number = Math.max(number, own);
            if (own > sent) {
                waiting.add(new Entry(own, parts[1], parts[2], parts[3]));
            }
        }
        if (whole < text.length()) {
            try (RandomAccessFile present = new RandomAccessFile(file.toFile(), "rw")) {
                present.setLength(text.substring(0, whole).getBytes(StandardCharsets.UTF_8).length);
            }
        }
    }

    /** Adds a record, which is on the disk when this returns. */
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

    /** The first waiting records, at most {@code most}; if there are none, waits up to {@code limitMillis} for one. */
    public synchronized List<Entry> first(int most, long limitMillis) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(limitMillis);
        for (long left = limitMillis; waiting.isEmpty() && left > 0; ) {
            wait(left);
            left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
        }
        return List.copyOf(waiting.subList(0, Math.min(most, waiting.size())));
    }

    /** The receiver has all records up to this number. */
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

    /** How many records wait. */
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
