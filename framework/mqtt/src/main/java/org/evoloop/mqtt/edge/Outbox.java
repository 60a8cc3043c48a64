package org.evoloop.mqtt.edge;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayDeque;
import java.util.Deque;
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
    private static final char END = '\n';

    /** A shorter file is not worth rewriting. */
    private static final long SHORT = 1 << 20;

    private final Path file;
    private final Path positionFile;
    private final FileChannel owner;
    private final Deque<Entry> waiting = new ArrayDeque<>();
    private volatile RandomAccessFile lines;
    private long rewriteAt = SHORT;
    private long number;
    private long sent;

    /**
     * A record.
     *
     * @param number its number in this outbox
     * @param topic its destination
     */
    public record Entry(long number, String topic, String device, String record) {
        private byte[] line() {
            return (number + String.valueOf(BETWEEN) + topic + BETWEEN + device + BETWEEN + record + END)
                    .getBytes(StandardCharsets.UTF_8);
        }
    }

    /**
     * Opens the outbox in {@code directory}, which is created if necessary. Another one in the same directory is refused.
     *
     * @param before the number before the first one, in a new outbox
     */
    public Outbox(Path directory, long before) {
        file = directory.resolve("outbox");
        positionFile = directory.resolve("outbox.sent");
        try {
            Files.createDirectories(directory);
            owner = owner(directory.resolve("outbox.lock"));
            boolean nothingSent = !Files.exists(positionFile);
            sent = nothingSent
                    ? before
                    : numberIn(Files.readString(positionFile).strip(), positionFile);
            number = sent;
            read(nothingSent);
            lines = new RandomAccessFile(file.toFile(), "rw");
            lines.seek(lines.length());
        } catch (IOException e) {
            throw new UncheckedIOException(directory + " cannot be used: " + e.getMessage(), e);
        }
    }

    /** Whether there has been an outbox in {@code directory}. */
    public static boolean isIn(Path directory) {
        return Files.exists(directory.resolve("outbox"));
    }

    /** The lock is the process's, and ends with it. */
    private static FileChannel owner(Path lock) throws IOException {
        FileChannel channel = FileChannel.open(lock, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        try {
            if (channel.tryLock() != null) {
                return channel;
            }
        } catch (OverlappingFileLockException usedHere) {
            // The same as if another process had it.
        }
        channel.close();
        throw new IOException("another program uses it");
    }

    private static long numberIn(String text, Path file) throws IOException {
        try {
            return Long.parseLong(text);
        } catch (NumberFormatException e) {
            throw new IOException(file + " is damaged: a number was expected, found '" + text + "'");
        }
    }

    /** An incomplete last line does not count; it is cut off. */
    private void read(boolean nothingSent) throws IOException {
        if (!Files.exists(file)) {
            return;
        }
        String text = Files.readString(file);
        int whole = text.lastIndexOf(END) + 1;
        int begin = 0;
        while (begin < whole) {
            int end = text.indexOf(END, begin);
            String[] parts = text.substring(begin, end).split(String.valueOf(BETWEEN), 4);
            long own = numberIn(parts[0], file);
            if (nothingSent && begin == 0) {
                sent = own - 1;
                number = sent;
            }
            number = Math.max(number, own);
            if (own > sent && parts.length == 4) {
                waiting.add(new Entry(own, parts[1], parts[2], parts[3]));
            }
            begin = end + 1;
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
        Entry entry = new Entry(number + 1, topic, device, record.replace(END, ' '));
        try {
            long before = lines.getFilePointer();
            try {
                lines.write(entry.line());
            } catch (IOException e) {
                // A part of the line, as on a full disk, would spoil the next one.
                lines.setLength(before);
                throw e;
            }
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
        RandomAccessFile present = lines;
        try {
            present.getFD().sync();
        } catch (IOException e) {
            // If the file was rewritten meanwhile, the new one is on the disk.
            if (present == lines) {
                throw cannotBeWritten(e);
            }
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
        return waiting.stream().limit(most).toList();
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
        while (!waiting.isEmpty() && waiting.getFirst().number <= last) {
            waiting.removeFirst();
        }
        sent = last;
        try {
            // A crash or a full disk must not leave it empty.
            Path next = positionFile.resolveSibling("outbox.sent.new");
            Files.writeString(next, sent + "\n");
            Files.move(next, positionFile, StandardCopyOption.ATOMIC_MOVE);
            if (waiting.isEmpty()) {
                lines.setLength(0);
                rewriteAt = SHORT;
            } else if (lines.length() > rewriteAt) {
                rewrite();
            }
        } catch (IOException e) {
            throw cannotBeWritten(e);
        }
    }

    /** Without the records sent: while devices always have something to report, the file would grow forever. */
    private void rewrite() throws IOException {
        Path next = file.resolveSibling("outbox.new");
        Files.deleteIfExists(next);
        RandomAccessFile fresh = new RandomAccessFile(next.toFile(), "rw");
        try {
            ByteArrayOutputStream all = new ByteArrayOutputStream();
            for (Entry entry : waiting) {
                all.write(entry.line());
            }
            fresh.write(all.toByteArray());
            fresh.getFD().sync();
            Files.move(next, file, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException e) {
            fresh.close();
            throw e;
        }
        RandomAccessFile former = lines;
        lines = fresh;
        former.close();
        rewriteAt = Math.max(SHORT, 2 * fresh.length());
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
            owner.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
