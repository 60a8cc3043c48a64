package org.evoloop.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The segments of a journal, and the lock that reserves them for one process. */
final class Directory implements AutoCloseable {
    static final String DAMAGED =
            "The journal is damaged; restore a copy of its directory, or move that away to start without it";

    private static final Logger LOG = LoggerFactory.getLogger(Journal.class);
    private static final String SUFFIX = ".journal";

    private final Path path;
    private final FileChannel lock;
    private final ArrayDeque<Piece> pieces = new ArrayDeque<>();
    private long total;

    /** A segment, and its size on the disk. */
    private record Piece(Path file, long bytes) {}

    /** @throws JournalException if it cannot be written, or another process has it */
    Directory(Path path) {
        this.path = path;
        FileChannel channel = null;
        try {
            Files.createDirectories(path);
            channel = FileChannel.open(path.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            if (take(channel) == null) {
                channel.close();
                throw new JournalException("the journal " + path
                        + " is in use by another converter; close that one, or use another directory");
            }
            channel.truncate(0)
                    .write(ByteBuffer.wrap((ProcessHandle.current().pid() + "\n").getBytes(StandardCharsets.US_ASCII)));
        } catch (IOException e) {
            throw cannotBeWritten(path, e);
        }
        this.lock = channel;
    }

    private static @Nullable FileLock take(FileChannel channel) throws IOException {
        try {
            return channel.tryLock();
        } catch (OverlappingFileLockException sameProcess) {
            return null;
        }
    }

    static JournalException cannotBeWritten(Path path, Throwable e) {
        String why = e instanceof FileSystemException || e.getMessage() == null ? e.toString() : e.getMessage();
        return new JournalException(
                "the journal " + path + " cannot be written: " + why
                        + "; make it a directory that this user may write to, with room on its disk, or use another",
                e);
    }

    Path path() {
        return path;
    }

    /** The segments, oldest first. @throws JournalException if one is missing in between */
    static List<Path> segments(Path path) {
        List<Path> segments = new ArrayList<>();
        try (Stream<Path> files = Files.list(path)) {
            files.filter(file -> file.getFileName().toString().matches("\\d{10}\\" + SUFFIX))
                    .sorted()
                    .forEach(segments::add);
        } catch (IOException e) {
            throw new JournalException("the journal " + path + " cannot be read: " + e, e);
        }
        for (int index = 1; index < segments.size(); index++) {
            if (number(segments.get(index)) != number(segments.get(index - 1)) + 1) {
                throw JournalException.ofDamage("the journal " + path + " lacks the segment before "
                        + segments.get(index).getFileName() + "; it is needed to go on");
            }
        }
        return segments;
    }

    /**
     * Whether a listed segment has been deleted since, as its converter does with those that are too old to be kept.
     */
    static boolean isGone(Path segment) {
        return !Files.exists(segment, LinkOption.NOFOLLOW_LINKS);
    }

    /**
     * The last segments, oldest first, as many as hold {@code bytes}, and at least two. One whose creation was not
     * completed does not count, and is deleted.
     */
    List<Path> last(int bytes) {
        for (Path file : segments(path)) {
            add(file, file.toFile().length());
        }
        Piece newest = pieces.pollLast();
        if (newest != null) {
            total -= newest.bytes();
            long written = SegmentReader.writtenBytes(newest.file());
            if (written > 0) {
                // A killed process leaves the unused room allocated.
                add(newest.file(), written);
            } else {
                LOG.info("{} was being created when its process ended, and is left out", newest.file());
                delete(newest.file());
            }
        }
        ArrayDeque<Path> last = new ArrayDeque<>();
        long sum = 0;
        for (Iterator<Piece> from = pieces.descendingIterator(); from.hasNext() && (sum < bytes || last.size() < 2); ) {
            Piece piece = from.next();
            sum += piece.bytes();
            last.addFirst(piece.file());
        }
        return List.copyOf(last);
    }

    void add(Path file, long bytes) {
        pieces.add(new Piece(file, bytes));
        total += bytes;
    }

    /** The file of the segment after the last one. */
    Path next() {
        Piece newest = pieces.peekLast();
        long number = newest == null ? 1 : number(newest.file()) + 1;
        return path.resolve(String.format(Locale.ROOT, "%010d", number) + SUFFIX);
    }

    /** The file of a segment that is being prepared; deletes one that an earlier process has left. */
    Path prepared() throws IOException {
        Path file = path.resolve("prepared");
        Files.deleteIfExists(file);
        return file;
    }

    private static long number(Path segment) {
        return Long.parseLong(segment.getFileName().toString().replace(SUFFIX, ""));
    }

    /**
     * Removes the oldest segments from the list until the others take at most {@code bytes}; two always stay. Returns
     * the removed ones, to be deleted.
     */
    List<Path> outgrown(long bytes) {
        List<Path> files = new ArrayList<>();
        while (total > bytes && pieces.size() > 2) {
            Piece oldest = pieces.remove();
            total -= oldest.bytes();
            files.add(oldest.file());
        }
        return files;
    }

    /**
     * Forces the names of new files to the disk; where a directory cannot be opened, the system does that by itself.
     */
    static void force(Path directory) {
        try (FileChannel channel = FileChannel.open(directory, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (IOException notNeeded) {
            LOG.debug("{} cannot be forced", directory, notNeeded);
        }
    }

    static void delete(Path file) {
        if (!file.toFile().delete()) {
            LOG.warn("{} cannot be deleted; delete it by hand", file);
        }
    }

    @Override
    public void close() {
        try {
            lock.close();
        } catch (IOException e) {
            LOG.warn("the lock of {} cannot be released", path, e);
        }
    }
}
