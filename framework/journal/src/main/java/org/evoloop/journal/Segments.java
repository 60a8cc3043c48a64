package org.evoloop.journal;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.evoloop.engine.Core;
import org.evoloop.engine.Rules;
import org.evoloop.engine.codec.ByteWriter;
import org.evoloop.engine.codec.SnapshotText;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.Place.Link;
import org.evoloop.journal.Preamble.Ending;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The segments of a journal that is being written; decides when the next one begins. */
final class Segments implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Journal.class);

    /** The least room in a new segment, beyond its head and snapshot. */
    private static final int LEAST_ROOM = 1 << 16;

    /** The pause after a failed attempt to begin a segment. */
    private static final long RETRY_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final Journal options;
    private final Directory directory;
    private final Clock clock;
    private final String built;
    private ModelPair models;
    private String fingerprint;
    private final @Nullable Forcer forcer;
    private @Nullable Segment segment;
    private volatile @Nullable Prepared prepared;
    private @Nullable Head head;
    private boolean closed;
    private boolean failing;
    private long failedNanos;

    /** A segment with only its head, and the names used there. */
    private record Prepared(Rules rules, Head head, ByteWriter names, Segment segment) {}

    /** @param built the fingerprint of the models with which the converter was built */
    Segments(Journal options, Directory directory, Clock clock, ModelPair models, String built, String name) {
        this.options = options;
        this.directory = directory;
        this.clock = clock;
        this.built = built;
        this.models = models;
        this.fingerprint = Fingerprint.of(models);
        this.forcer = options.forcing() == Forcing.NEVER ? null : new Forcer(name);
    }

    Path path() {
        return directory.path();
    }

    Masks masks() {
        return options.masks();
    }

    /** Whether the last attempt to write succeeded. */
    boolean isWritable() {
        return !failing;
    }

    /** Whether a segment may be begun now: the journal is open, and the last failure is not too recent. */
    boolean mayBegin() {
        return !closed && (!failing || System.nanoTime() - failedNanos >= RETRY_NANOS);
    }

    /** The file that is written, if it is not in its place any more; null otherwise. */
    @Nullable
    Path lost() {
        Segment current = segment;
        return current != null && current.isLost() ? current.file() : null;
    }

    /**
     * Appends the record; false if the segment is full or lost, or there is none.
     *
     * @throws IOException if it does not fit into
     * any
     */
    boolean append(ByteWriter record) throws IOException {
        if (record.length() > Frame.MOST_BYTES) {
            throw new IOException("an input takes " + record.length() + " bytes, allowed are " + Frame.MOST_BYTES);
        }
        Segment current = segment;
        if (current == null || current.isLost() || !current.append(record.array(), record.length())) {
            return closed;
        }
        if (forcer != null) {
            forcer.written();
        }
        return true;
    }

    /** Begins another segment with the state of {@code core}; if that fails, the previous one can still be written. */
    void begin(Core core, ByteWriter bytes) throws IOException {
        byte[] snapshot = snapshot(core);
        Head begun = head(core.rules());
        int unwritten = bytes.length();
        bytes.forgetNames();
        begun.write(bytes);
        Segment next = new Segment(directory.fresh("beginning"), size(bytes.length() + snapshot.length + unwritten));
        next.append(bytes.array(), bytes.length());
        begin(next, snapshot, begun);
    }

    private byte[] snapshot(Core core) {
        return SnapshotText.write(masks().of(core.snapshot())).getBytes(StandardCharsets.UTF_8);
    }

    private int size(int written) {
        return Math.max(options.segmentBytes(), Preamble.BYTES + written + LEAST_ROOM);
    }

    private void begin(Segment next, byte[] snapshot, Head begun) throws IOException {
        next.append(snapshot, snapshot.length);
        Segment ended = segment;
        Path before = directory.newest();
        if (ended != null) {
            directory.ends(ended.link());
        }
        Link end = directory.end();
        List<Path> outgrown = directory.outgrown(next.size(), options.keptBytes());
        next.begin(directory.next(), directory.place(next.size(), outgrown));
        directory.begun(next.file(), next.size(), outgrown);
        segment = next;
        failing = false;
        head = begun;
        models = begun.models();
        fingerprint = begun.fingerprint();
        if (before == null) {
            // Without a segment before it, a blank one would be a journal without a state.
            next.force();
        } else if (options.forcing() == Forcing.PER_INTENT) {
            if (ended != null) {
                ended.force();
            }
            next.force();
        }
        Runnable chore = () -> tidy(ended, next, before, end, outgrown);
        if (forcer != null) {
            forcer.use(next, chore);
        } else {
            chore.run();
        }
    }

    /**
     * @param ended null if it has been closed
     * @param before the file of the segment before {@code next}, which ended at {@code end}; null if there was none
     */
    private void tidy(@Nullable Segment ended, Segment next, @Nullable Path before, Link end, List<Path> outgrown) {
        try {
            if (ended != null) {
                if (forcer != null) {
                    ended.force();
                }
                ended.close();
            }
            if (forcer != null) {
                next.force();
            }
            if (before != null && (ended == null || !ended.isLost())) {
                Preamble.continued(before, forcer == null ? Ending.CONTINUED : Ending.SURELY_CONTINUED, end);
            }
        } catch (IOException | RuntimeException | InternalError e) {
            LOG.warn("{} cannot be put on the disk; a power cut would lose what was written there", before, e);
        }
        outgrown.forEach(Directory::delete);
    }

    /** Writes the beginning of a segment by {@code rules} in advance, in a file that is not a segment yet. */
    void prepare(Rules rules) throws IOException {
        discardPrepared();
        ByteWriter names = ByteWriter.withTable();
        Head begun = head(rules);
        begun.write(names);
        Segment next = new Segment(directory.fresh("prepared"), size(2 * LEAST_ROOM + names.length()));
        next.append(names.array(), names.length());
        prepared = new Prepared(rules, begun, names, next);
    }

    /**
     * Begins the prepared segment with the state of {@code core}, which has the same rules.
     *
     * @return the names used in its head
     */
    ByteWriter beginPrepared(Core core) throws IOException {
        Prepared ready = prepared;
        if (ready == null || !ready.rules().equals(core.rules())) {
            ByteWriter names = ByteWriter.withTable();
            begin(core, names);
            return names;
        }
        byte[] snapshot = snapshot(core);
        prepared = null;
        if (snapshot.length > LEAST_ROOM) {
            ready.segment().discard();
            begin(core, ready.names());
        } else {
            begin(ready.segment(), snapshot, ready.head());
        }
        return ready.names();
    }

    private void discardPrepared() {
        Prepared unused = prepared;
        prepared = null;
        if (unused != null) {
            unused.segment().discard();
        }
    }

    private Head head(Rules rules) {
        return Head.of(fingerprintOf(rules), built, rules, Times.nanos(clock.wallTime()), clock.nanoTime());
    }

    private String fingerprintOf(Rules rules) {
        ModelPair present = rules.table().models();
        return present.equals(models) ? fingerprint : Fingerprint.of(present);
    }

    private void end() throws IOException {
        Segment ended = segment;
        segment = null;
        if (ended != null) {
            directory.ends(ended.link());
            if (closed || options.forcing() == Forcing.PER_INTENT) {
                ended.force();
            }
            ended.close();
        }
    }

    /** Ends the present segment: the next input begins another one. */
    void suspend() {
        try {
            end();
        } catch (IOException | InternalError lost) {
            fails();
        }
    }

    private void fails() {
        failing = true;
        failedNanos = System.nanoTime();
    }

    /** Notes that writing failed: for a while no segment is begun. */
    void fail() {
        suspend();
        fails();
    }

    /** Whether the segment was begun with these rules. */
    boolean isBy(Rules rules) {
        Head begun = head;
        return begun != null && begun.hasRulesOf(head(rules));
    }

    /** Called before a step is sent. */
    void forceIntent() {
        Segment current = segment;
        if (current != null && options.forcing() == Forcing.PER_INTENT) {
            current.force();
        }
    }

    @Override
    public void close() {
        closed = true;
        discardPrepared();
        if (forcer != null) {
            forcer.close();
        }
        suspend();
        directory.close();
    }
}
