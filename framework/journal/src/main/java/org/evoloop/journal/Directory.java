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
import java.util.UUID;
import java.util.stream.Stream;
import org.evoloop.journal.Place.Link;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The segments of a journal, and the lock that reserves them for one process. */
final class Directory implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Journal.class);
    private static final String SUFFIX = ".journal";

    private final Path path;
    private final FileChannel lock;
    private final ArrayDeque<Piece> pieces = new ArrayDeque<>();
    private long total;
    private UUID journal = new UUID(0, 0);
    private Link end = Link.NONE;

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

    /** The files with the names of segments, oldest first. */
    static List<Path> segments(Path path) {
        List<Path> segments = new ArrayList<>();
        try (Stream<Path> files = Files.list(path)) {
            files.filter(file -> file.getFileName().toString().matches("\\d{10}\\" + SUFFIX))
                    .sorted()
                    .forEach(segments::add);
        } catch (IOException e) {
            throw new JournalException("the journal " + path + " cannot be read: " + e, e);
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
     * The last segments, oldest first, as many as hold {@code bytes}, and at least two. What a retention or a power cut
     * has left over is deleted.
     *
     * @throws JournalException if the journal is not as it was written
     */
    List<Path> last(int bytes) {
        Chain chain = Chain.of(path);
        chain.leftOver().forEach(file -> {
            LOG.info("{} is left over from an earlier process, and is deleted", file);
            delete(file);
        });
        UUID present = chain.journal();
        journal = present == null ? UUID.randomUUID() : present;
        end = chain.end();
        for (Path file : chain.files()) {
            // A killed process leaves the unused room of the newest one, which is released when that is replayed.
            boolean newest = file.equals(chain.files().get(chain.files().size() - 1));
            add(file, newest ? chain.end().end() : file.toFile().length());
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

    private void add(Path file, long bytes) {
        pieces.add(new Piece(file, bytes));
        total += bytes;
    }

    /** The newest segment; null if there is none. */
    @Nullable
    Path newest() {
        Piece newest = pieces.peekLast();
        return newest == null ? null : newest.file();
    }

    /** Where the newest segment ends. */
    Link end() {
        return end;
    }

    /** Nothing more is appended to the newest segment. */
    void ends(Link at) {
        end = at;
    }

    /** The next segment has begun there; the outgrown ones are no longer part of the journal. */
    void begun(Path next, int bytes, List<Path> outgrown) {
        for (int left = outgrown.size(); left > 0; left--) {
            total -= pieces.remove().bytes();
        }
        add(next, bytes);
    }

    /** The place of the next segment, of {@code bytes}. */
    Place place(int bytes, List<Path> outgrown) {
        Iterator<Piece> kept = pieces.stream().skip(outgrown.size()).iterator();
        long number = number(next());
        return new Place(journal, number, kept.hasNext() ? number(kept.next().file()) : number, end, bytes);
    }

    /** The file of the segment after the last one. */
    Path next() {
        Piece newest = pieces.peekLast();
        long number = newest == null ? 1 : number(newest.file()) + 1;
        return path.resolve(name(number));
    }

    /** The file of a segment before it begins; deletes one that an earlier process has left. */
    Path fresh(String name) throws IOException {
        Path file = path.resolve(name);
        Files.deleteIfExists(file);
        return file;
    }

    /** The name of the segment's file. */
    static String name(long number) {
        return String.format(Locale.ROOT, "%010d", number) + SUFFIX;
    }

    private static long number(Path segment) {
        return Long.parseLong(segment.getFileName().toString().replace(SUFFIX, ""));
    }

    /**
     * The oldest segments, without which the others and {@code coming} more bytes take at most {@code most}; with the
     * next one two always stay.
     */
    List<Path> outgrown(int coming, long most) {
        List<Path> files = new ArrayList<>();
        long left = total + coming;
        for (Piece piece : pieces) {
            if (left <= most || pieces.size() - files.size() < 2) {
                break;
            }
            left -= piece.bytes();
            files.add(piece.file());
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
