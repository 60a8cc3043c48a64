package org.evoloop.journal;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * Read access to a journal in its directory. Nothing is written and no lock is taken: the journal may be in use, and is
 * read as far as it has been written.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class JournalFiles {
    private final Path directory;

    /**
     * The contents of a segment's first record.
     *
     * @param segment the name of its file
     * @param fingerprint the fingerprint of the models
     * @param original the name of the device's model
     * @param evolved the name of the new model
     * @param begun when the segment began
     * @param records how many inputs it holds
     * @param cutOff whether a record was being written when its process ended, or is being written now
     */
    public record SegmentInfo(
            String segment,
            String fingerprint,
            String original,
            String evolved,
            Instant begun,
            long records,
            boolean cutOff) {}

    /**
     * The journal in {@code directory}.
     *
     * @throws JournalException if there is none
     */
    public JournalFiles(Path directory) {
        this.directory = directory;
        if (!Files.isDirectory(directory)) {
            throw new JournalException(directory + (Files.exists(directory) ? " is no directory" : " does not exist")
                    + "; name the directory of a journal, as it was given with --journal");
        }
        if (Directory.segments(directory).isEmpty()) {
            throw new JournalException(
                    directory + " is not a journal: it contains no file such as 0000000001.journal; name the"
                            + " directory that was given with --journal");
        }
    }

    /**
     * Reads every record, oldest first. A takeover by other models is a record, too, with number 0.
     *
     * @return its segments, the oldest first
     * @throws JournalException if it is damaged, of another version or cannot be read
     */
    public List<SegmentInfo> read(Consumer<JournalRecord> reader) {
        List<SegmentInfo> read = new ArrayList<>();
        each(file -> new SegmentRecords(file, new SegmentReader(file)), segment -> {
            SegmentInfo info = segment.info();
            SegmentInfo before = read.isEmpty() ? null : read.get(read.size() - 1);
            if (before != null && !before.fingerprint().equals(info.fingerprint())) {
                reader.accept(segment.evolvedFrom(before));
            }
            segment.records().forEach(reader);
            read.add(info);
        });
        return read;
    }

    /**
     * Reads every segment that is still there, oldest first; each is passed on only after it has been read completely.
     */
    <T> void each(Function<Path, T> reading, Consumer<T> reader) {
        each(directory, reading, reader);
    }

    static <T> void each(Path directory, Function<Path, T> reading, Consumer<T> reader) {
        for (Path file : Chain.whileInUse(directory).files()) {
            T segment = stillThere(directory, file, reading);
            if (segment != null) {
                reader.accept(segment);
            }
        }
    }

    /** Null if it has been deleted with the oldest ones since it was listed. */
    private static <T> @Nullable T stillThere(Path directory, Path file, Function<Path, T> reading) {
        try {
            return reading.apply(file);
        } catch (JournalException unreadable) {
            // It may also have been closed while it was read, or not be as it was written; that is thrown here.
            return Chain.whileInUse(directory).files().contains(file) ? reading.apply(file) : null;
        }
    }

    static String word(Enum<?> kind) {
        return kind.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
