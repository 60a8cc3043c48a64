package org.evoloop.journal;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.evoloop.converter.ConverterJournal;
import org.evoloop.engine.Core;
import org.evoloop.engine.Inputs;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.ModelPair;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The journal of one converter, in a directory of its own.
 *
 * <pre>{@code
 * converter.journal(Journal.in(Path.of("/var/lib/lamp")).withForcing(Forcing.PER_INTENT));
 * }</pre>
 *
 * <p>The directory holds segments of {@code segmentBytes} each, {@value #DEFAULT_SEGMENT_BYTES} bytes by default, of
 * which the oldest are deleted when all take more than {@code keptBytes}, {@value #DEFAULT_KEPT_BYTES} by default. At a
 * start the last of them are read, as many as hold {@code segmentBytes}. A segment becomes larger only if the
 * converter's state does not fit into it.
 *
 * <p>Threading: options are set before it is opened; then it belongs to its converter.
 *
 * @since 0.1
 */
public final class Journal implements ConverterJournal {
    /** The size of a segment: room for some 40,000 inputs. */
    public static final int DEFAULT_SEGMENT_BYTES = 1 << 20;

    /** The total size kept. */
    public static final long DEFAULT_KEPT_BYTES = 16 << 20;

    private static final int LEAST_SEGMENT_BYTES = 1 << 16;
    private static final int MOST_SEGMENT_BYTES = 1 << 30;

    private final Path path;
    private final int segmentBytes;
    private final long keptBytes;
    private final Forcing forcing;
    private final Masks masks;
    private @Nullable Segments segments;

    /** The fingerprint of the models with which the converter was built, if it has evolved since. */
    private @Nullable String built;

    private Journal(Path path, int segmentBytes, long keptBytes, Forcing forcing, Masks masks) {
        this.path = requireNonNull(path, "the directory of a journal is null");
        this.segmentBytes = segmentBytes;
        this.keptBytes = keptBytes;
        this.forcing = requireNonNull(forcing, "forcing is null");
        this.masks = masks;
        if (segmentBytes < LEAST_SEGMENT_BYTES || segmentBytes > MOST_SEGMENT_BYTES) {
            throw new IllegalArgumentException("segmentBytes is " + segmentBytes + ", allowed is " + LEAST_SEGMENT_BYTES
                    + " to " + MOST_SEGMENT_BYTES);
        }
        if (keptBytes < 0) {
            throw new IllegalArgumentException("keptBytes is " + keptBytes + ", allowed is 0 and more");
        }
    }

    /** A journal with the default options, forced by batch. The directory is created if it does not exist. */
    public static Journal in(Path directory) {
        return new Journal(directory, DEFAULT_SEGMENT_BYTES, DEFAULT_KEPT_BYTES, Forcing.BY_BATCH, Masks.NONE);
    }

    /** A copy with segments of {@code bytes}, 65,536 to 1,073,741,824. */
    public Journal withSegmentBytes(int bytes) {
        return new Journal(path, bytes, keptBytes, forcing, masks);
    }

    /** A copy that keeps this many bytes; two segments are always kept. */
    public Journal withKeptBytes(long bytes) {
        return new Journal(path, segmentBytes, bytes, forcing, masks);
    }

    /** A copy with another forcing. */
    public Journal withForcing(Forcing when) {
        return new Journal(path, segmentBytes, keptBytes, when, masks);
    }

    /**
     * A copy that never writes these values of events. An event that is handled after a recovery does not have them:
     * code that asks for one gets the exception for a missing value, so the event fails.
     *
     * @param values names of values, such as {@code pin}, or of an event and its value, such as {@code unlock.pin}
     * @throws IllegalArgumentException if a name is blank
     */
    public Journal withMasked(String... values) {
        return new Journal(path, segmentBytes, keptBytes, forcing, masks.and(List.of(values)));
    }

    Masks masks() {
        return masks;
    }

    int segmentBytes() {
        return segmentBytes;
    }

    long keptBytes() {
        return keptBytes;
    }

    Forcing forcing() {
        return forcing;
    }

    /**
     * Checks, as far as is possible without writing, that a converter of these models could begin or continue this
     * journal, which may be in use.
     *
     * @throws JournalException if it could not; the message is that of a start
     */
    public void check(ModelPair models) {
        Path existing = path.toAbsolutePath();
        while (!Files.exists(existing) && existing.getParent() != null) {
            existing = existing.getParent();
        }
        if (!Files.isDirectory(existing)) {
            throw Directory.cannotBeWritten(path, new FileAlreadyExistsException(existing.toString()));
        }
        if (!Files.isWritable(existing)) {
            throw Directory.cannotBeWritten(path, new AccessDeniedException(existing.toString()));
        }
        Path newest = newest();
        if (newest != null && evolvedFrom(models) == null) {
            Fingerprint.requireSame(newest, new SegmentReader(newest).head(), Fingerprint.of(models), models);
        }
    }

    private @Nullable Path newest() {
        List<Path> all = Files.isDirectory(path) ? Chain.whileInUse(path).files() : List.of();
        return all.isEmpty() ? null : all.get(all.size() - 1);
    }

    /** @throws JournalException if it is damaged, or cannot be read */
    @Override
    public @Nullable ModelPair evolvedFrom(ModelPair models) {
        String fingerprint = Fingerprint.of(models);
        Path last = newest();
        if (last == null) {
            return null;
        }
        Head newest = new SegmentReader(last).head();
        if (newest.built().equals(fingerprint) && !newest.fingerprint().equals(fingerprint)) {
            built = fingerprint;
            return newest.models();
        }
        return null;
    }

    /** @throws JournalException if it cannot be continued */
    @Override
    public @Nullable Snapshot open(Rules rules, Clock usedClock, Past past) {
        Directory opened = new Directory(path);
        try {
            ModelPair models = rules.table().models();
            String fingerprint = Fingerprint.of(models);
            Replay replay = new Replay(rules, fingerprint, past);
            replay.of(opened.last(segmentBytes));
            segments = new Segments(
                    this,
                    opened,
                    usedClock,
                    models,
                    built == null ? fingerprint : built,
                    String.valueOf(path.toAbsolutePath().getFileName()));
            return replay.result(usedClock);
        } catch (RuntimeException refused) {
            opened.close();
            throw refused;
        }
    }

    /** @throws JournalException if it cannot be written */
    @Override
    public void prepare(Rules rules) {
        try {
            requireNonNull(segments, "the journal is not open").prepare(rules);
        } catch (IOException | InternalError e) {
            throw Directory.cannotBeWritten(path, e);
        }
    }

    /** @throws JournalException if it is damaged, or cannot be read */
    @Override
    public void replay(Rules rules, Past past) {
        Replay replay = new Replay(rules, Fingerprint.of(rules.table().models()), past);
        JournalFiles.each(path, SegmentReader::new, replay::apply);
    }

    /** @throws JournalException if it cannot be written */
    @Override
    public Inputs keep(Core core, Consumer<Exception> failed, Runnable works) {
        Segments opened = requireNonNull(segments, "the journal is not open");
        try {
            return new Recorder(core, opened, failed, works);
        } catch (IOException e) {
            close();
            throw Directory.cannotBeWritten(path, e);
        }
    }

    @Override
    public void close() {
        Segments opened = segments;
        segments = null;
        if (opened != null) {
            opened.close();
        }
    }

    @Override
    public String toString() {
        return "journal " + path;
    }
}
