package org.evoloop.journal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.stream.Collectors;
import org.evoloop.journal.Place.Link;
import org.evoloop.journal.Preamble.Ending;
import org.jspecify.annotations.Nullable;

/**
 * The segments of a journal, read from the first to the last byte: each is the one that its name says, is as it was
 * written, and continues the one before. None is missing but the oldest ones, of which the journal keeps only so many.
 *
 * @param files the segments, oldest first
 * @param leftOver segments that should have been deleted, and one that was being created when the power was cut
 * @param journal the journal's identity; null if there is no segment
 * @param end where the newest one ends
 */
record Chain(
        List<Path> files, List<Path> leftOver, @Nullable UUID journal, Link end) {
    /** A read may see files that are being changed; reading them again sees the change complete. */
    private static final int LOOKS = 3;

    /** A segment, after all its records have been read. */
    private record Read(Path file, Preamble preamble, boolean powerCut, Link end) {
        static Read of(Path file) {
            SegmentReader reader = new SegmentReader(file);
            while (reader.next()) {
                // Reading checks it.
            }
            return new Read(file, reader.preamble(), reader.isBeforePowerCut(), reader.link());
        }

        Place place() {
            return preamble.place();
        }

        String name() {
            return file.getFileName().toString();
        }

        /** Whether the segment after it may be lost, or blank: the power was cut before it was on the disk. */
        boolean mayBeLast() {
            return switch (preamble.ending()) {
                case OPEN, CLOSED -> true;
                case CONTINUED -> powerCut;
                case SURELY_CONTINUED -> false;
            };
        }

        /** Whether {@code next} was written after it. What a power cut took from its end is not missed. */
        boolean isContinuedBy(Read next) {
            Link before = next.place().before();
            return before.equals(end) || (preamble.ending() == Ending.OPEN && powerCut && end.end() <= before.end());
        }
    }

    /**
     * A journal that may be in use.
     *
     * @throws JournalException if it is not as it was written
     */
    static Chain whileInUse(Path directory) {
        for (int looks = 1; ; looks++) {
            try {
                return of(directory);
            } catch (JournalException wrong) {
                if (looks == LOOKS) {
                    throw wrong;
                }
            }
        }
    }

    /**
     * A journal that nobody else writes.
     *
     * @throws JournalException if it is not as it was written
     */
    static Chain of(Path directory) {
        List<Path> leftOver = new ArrayList<>();
        List<Read> segments = read(Directory.segments(directory), leftOver);
        if (segments.isEmpty()) {
            return new Chain(List.of(), leftOver, null, Link.NONE);
        }
        requireOneJournal(directory, segments);
        segments.forEach(segment -> requireName(directory, segment));
        Read newest = segments.get(segments.size() - 1);
        int first = segments.size() - 1;
        while (first > 0 && number(segments, first) == number(segments, first - 1) + 1) {
            first--;
        }
        if (first > 0 || !Remedy.isSetAside(directory)) {
            requireOutgrown(directory, segments.get(first), newest.place().oldest());
        }
        segments.subList(0, first).forEach(old -> leftOver.add(old.file()));
        List<Read> kept = segments.subList(first, segments.size());
        for (int index = 1; index < kept.size(); index++) {
            requireContinued(kept.get(index - 1), kept.get(index));
        }
        requireLast(directory, newest);
        return new Chain(
                kept.stream().map(Read::file).toList(), leftOver, newest.place().journal(), newest.end());
    }

    private static List<Read> read(List<Path> files, List<Path> leftOver) {
        List<Read> segments = new ArrayList<>();
        for (Path file : files) {
            try {
                segments.add(Read.of(file));
            } catch (JournalException wrong) {
                boolean newest = file.equals(files.get(files.size() - 1));
                Read before = segments.isEmpty() ? null : segments.get(segments.size() - 1);
                if (!newest || !wrong.isDamage() || before == null || !before.powerCut() || !before.mayBeLast()) {
                    throw wrong;
                }
                leftOver.add(file);
            }
        }
        return segments;
    }

    private static long number(List<Read> segments, int index) {
        return segments.get(index).place().number();
    }

    private static void requireOneJournal(Path directory, List<Read> segments) {
        Map<String, String> journals = segments.stream()
                .collect(Collectors.groupingBy(
                        segment -> segment.place().journalName(),
                        LinkedHashMap::new,
                        Collectors.mapping(Read::name, Collectors.joining(", "))));
        if (journals.size() > 1) {
            String all = journals.entrySet().stream()
                    .map(each -> each.getValue() + " of journal " + each.getKey())
                    .collect(Collectors.joining("; "));
            throw JournalException.damaged(
                    "the journal " + directory + " holds segments of different journals: " + all,
                    "move those of the other journal into a directory of their own, and restore what is missing then");
        }
    }

    private static void requireName(Path directory, Read segment) {
        Path right = directory.resolve(Directory.name(segment.place().number()));
        if (segment.file().getFileName().equals(right.getFileName())) {
            return;
        }
        String what = ", byte 48: this is segment " + segment.place().number() + ", under another name";
        String remedy;
        if (Directory.isGone(right)) {
            remedy = "rename it to " + right.getFileName();
        } else if (SegmentReader.preamble(right).place().number()
                == segment.place().number()) {
            remedy = "it is there under its own name, too, so move this file out of the directory";
        } else {
            remedy = "give each file the name of its segment; another file has the name " + right.getFileName();
        }
        throw JournalException.damaged(segment.file() + what, remedy);
    }

    private static void requireOutgrown(Path directory, Read first, long oldest) {
        long before = first.place().number() - 1;
        if (before >= oldest) {
            throw JournalException.damaged(
                    "the journal " + directory + " lacks " + Directory.name(before) + ", which " + first.name()
                            + " continues",
                    Remedy.ofMissing(first.file()));
        }
    }

    private static void requireContinued(Read segment, Read next) {
        if (!segment.isContinuedBy(next)) {
            throw JournalException.damaged(
                    next.file() + ", byte 64: it continues a segment that ended at "
                            + next.place().before() + ", but " + segment.name() + " ends at " + segment.end(),
                    Remedy.ofMissing(next.file()));
        }
    }

    private static void requireLast(Path directory, Read newest) {
        if (!newest.mayBeLast()) {
            String next = Directory.name(newest.place().number() + 1);
            throw JournalException.damaged(
                    "the journal " + directory + " lacks " + next + ", which continued " + newest.name(),
                    Remedy.ofDamage(directory.resolve(next)));
        }
    }
}
