package org.evoloop.journal;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.evoloop.core.Core;
import org.evoloop.core.Rules;
import org.evoloop.core.text.SnapshotText;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/** The segments of a journal that is being written: the last one, and when the next one begins. */
final class Segments implements AutoCloseable {
    /** So much room a new segment has at least, beyond its head and snapshot. */
    private static final int LEAST_ROOM = 1 << 16;

    /** So long after it could not be begun a segment is tried again. */
    private static final long RETRY_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final Journal options;
    private final Directory directory;
    private final Clock clock;
    private final String fingerprint;
    private final @Nullable Forcer forcer;
    private @Nullable Segment segment;
    private @Nullable Head head;
    private boolean closed;
    private boolean failing;
    private long failedNanos;

    Segments(Journal options, Directory directory, Clock clock, String fingerprint, String name) {
        this.options = options;
        this.directory = directory;
        this.clock = clock;
        this.fingerprint = fingerprint;
        this.forcer = options.forcing() == Forcing.NEVER ? null : new Forcer(name);
    }

    Path path() {
        return directory.path();
    }

    Masks masks() {
        return options.masks();
    }

    /** Whether there was room the last time that any was needed. */
    boolean isWritable() {
        return !failing;
    }

    /** Whether a segment may be begun now: nothing is closed, and the last failure is not too recent. */
    boolean mayBegin() {
        return !closed && (!failing || System.nanoTime() - failedNanos >= RETRY_NANOS);
    }

    /** Appends the record; false if the segment is full, or there is none. @throws IOException if it fits into none */
    boolean append(Bytes record) throws IOException {
        if (record.length() > Frame.MOST_BYTES) {
            throw new IOException("an input takes " + record.length() + " bytes, allowed are " + Frame.MOST_BYTES);
        }
        Segment current = segment;
        if (current == null || !current.append(record.array(), record.length())) {
            return closed;
        }
        if (forcer != null) {
            forcer.written();
        }
        return true;
    }

    /** Begins another segment with what {@code core} knows. */
    void begin(Core core, Bytes bytes) throws IOException {
        byte[] snapshot = SnapshotText.write(masks().of(core.snapshot())).getBytes(StandardCharsets.UTF_8);
        Head begun = Head.of(fingerprint, core.rules(), Times.nanos(clock.wallTime()), clock.nanoTime());
        int unwritten = bytes.length();
        bytes.forgetNames();
        begun.write(bytes);
        int least = Preamble.BYTES + bytes.length() + snapshot.length + unwritten + LEAST_ROOM;
        end();
        try {
            int size = Math.max(options.segmentBytes(), least);
            Segment next = new Segment(directory.next(), size);
            next.append(bytes.array(), bytes.length());
            next.append(snapshot, snapshot.length);
            next.begin();
            directory.add(next.file(), size);
            segment = next;
        } catch (IOException | InternalError e) {
            failing = true;
            failedNanos = System.nanoTime();
            throw e;
        }
        failing = false;
        head = begun;
        if (options.forcing() == Forcing.PER_INTENT) {
            segment.force();
        }
        if (forcer != null) {
            forcer.use(segment);
        }
        directory.prune(options.keptBytes());
    }

    private void end() throws IOException {
        Segment ended = segment;
        segment = null;
        if (ended != null) {
            if (closed || options.forcing() == Forcing.PER_INTENT) {
                ended.force();
            }
            ended.close();
        }
    }

    /** The segment cannot be gone on with: the next input begins another one. */
    void suspend() {
        try {
            end();
        } catch (IOException | InternalError lost) {
            failing = true;
            failedNanos = System.nanoTime();
        }
    }

    /** Whether the segment was begun with these rules. */
    boolean isBy(Rules rules) {
        Head begun = head;
        return begun != null && begun.hasRulesOf(Head.of(fingerprint, rules, 0, 0));
    }

    /** Something is about to be sent. */
    void forceIntent() {
        Segment current = segment;
        if (current != null && options.forcing() == Forcing.PER_INTENT) {
            current.force();
        }
    }

    @Override
    public void close() {
        closed = true;
        if (forcer != null) {
            forcer.close();
        }
        suspend();
        directory.close();
    }
}
