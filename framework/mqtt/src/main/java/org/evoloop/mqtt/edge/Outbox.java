package org.evoloop.mqtt.edge;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * Records of devices that the receiver may not have yet, in a file with one line each. A line's number is never used
 * again, so the receiver can recognise repetitions.
 *
 * <p>An interrupted thread may write: interrupts neither end a write nor close the file.
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
    private final RandomAccessFile lines;
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
            lines = new RandomAccessFile(file.toFile(), "rw");
            lines.seek(lines.length());
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
    public void add(String topic, String device, String record) {
        write(topic, device, record);
        force();
    }

    /**
     * Adds a record, without waiting for the disk. It outlives this process once this returns, and a loss of power only
     * after {@link #force}.
     */
    public synchronized void write(String topic, String device, String record) {
        Entry entry = new Entry(number + 1, topic, device, record.replace('\n', ' '));
        String line = entry.number + String.valueOf(BETWEEN) + topic + BETWEEN + device + BETWEEN + entry.record + '\n';
        try {
            lines.write(line.getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw cannotBeWritten(e);
        }
        number++;
        waiting.add(entry);
        notifyAll();
    }

    private static UncheckedIOException cannotBeWritten(IOException e) {
        return new UncheckedIOException("the outbox cannot be written: " + e.getMessage(), e);
    }

    /** Forces everything written to the disk. Other threads can write meanwhile. */
    public void force() {
        try {
            lines.getFD().sync();
        } catch (IOException e) {
            throw cannotBeWritten(e);
        }
    }

    /** Waits up to {@code limitMillis} for a record with a higher number than {@code known}; returns the highest number. */
    public synchronized long awaitAfter(long known, long limitMillis) throws InterruptedException {
        await(() -> number > known, limitMillis);
        return number;
    }

    /** The first waiting records, at most {@code most}; if there are none, waits up to {@code limitMillis} for one. */
    public synchronized List<Entry> first(int most, long limitMillis) throws InterruptedException {
        await(() -> !waiting.isEmpty(), limitMillis);
        return List.copyOf(waiting.subList(0, Math.min(most, waiting.size())));
    }

    private synchronized void await(BooleanSupplier there, long limitMillis) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(limitMillis);
        for (long left = limitMillis; !there.getAsBoolean() && left > 0; ) {
            wait(left);
            left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
        }
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
                lines.setLength(0);
            }
        } catch (IOException e) {
            throw cannotBeWritten(e);
        }
    }

    /** The highest number so far. */
    public synchronized long last() {
        return number;
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
