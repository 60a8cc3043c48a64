package org.evoloop.journal;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.evoloop.converter.ConverterJournal.Past;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.codec.CodecException;
import org.evoloop.engine.codec.SnapshotText;
import org.evoloop.journal.Place.Link;
import org.evoloop.journal.Preamble.Ending;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Replays the segments of a journal on a core. */
final class Replay {
    private static final Logger LOG = LoggerFactory.getLogger(Journal.class);

    private final Rules present;
    private final String fingerprint;
    private final Past past;
    private @Nullable Snapshot last;
    private @Nullable Head lastHead;

    Replay(Rules present, String fingerprint, Past past) {
        this.present = present;
        this.fingerprint = fingerprint;
        this.past = past;
    }

    /** @throws JournalException if one is damaged, or of other models */
    void of(List<Path> segments) {
        for (int index = 0; index < segments.size(); index++) {
            of(segments.get(index), index == segments.size() - 1);
        }
    }

    /** Only replays; repairs nothing, and is not continued from. */
    void apply(SegmentReader segment) {
        apply(segment.file(), segment);
    }

    private void of(Path file, boolean newest) {
        SegmentReader segment = new SegmentReader(file);
        if (newest) {
            // Earlier segments may be of models from which the converter has evolved.
            Fingerprint.requireSame(
                    file, segment.head(), fingerprint, present.table().models());
        }
        Core core = apply(file, segment);
        if (segment.isTorn()) {
            LOG.warn(
                    "{} ends in the middle of record {}, at byte {}: it was being written when its process ended, and "
                            + "is cut off",
                    file,
                    segment.number() + 1,
                    segment.end());
        }
        if (newest && segment.preamble().ending() == Ending.OPEN) {
            close(file, segment.link());
        }
        last = core.snapshot();
        lastHead = segment.head();
    }

    private Core apply(Path file, SegmentReader segment) {
        Head head = segment.head();
        Rules rules = head.rules(present, fingerprint);
        Core core = new Core(rules, snapshot(file, segment, rules), past);
        past.at(() -> head.wallTime(core.nowNanos()), core::nowNanos);
        Decoder decoder = new Decoder(segment.cursor(), rules);
        while (segment.next()) {
            Input input;
            try {
                input = decoder.read(segment.at(), segment.length());
            } catch (RuntimeException e) {
                throw segment.damaged("it is inconsistent: " + e.getMessage());
            }
            core.apply(input);
        }
        return core;
    }

    /** Does what its process could not, and cuts off a record that was not written completely. */
    private static void close(Path file, Link end) {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
            Preamble.end(channel, Ending.CLOSED, end);
            channel.truncate(end.end());
        } catch (IOException e) {
            throw Directory.cannotBeWritten(file, e);
        }
    }

    private static Snapshot snapshot(Path file, SegmentReader segment, Rules rules) {
        try {
            return SnapshotText.read(rules, segment.snapshot());
        } catch (CodecException e) {
            throw new JournalException(file + ", record 0: " + e.getMessage());
        }
    }

    /** The last state of the converter, with times of {@code clock}; null if there is none. */
    @Nullable
    Snapshot result(Clock clock) {
        Snapshot kept = last;
        Head head = lastHead;
        if (kept == null || head == null) {
            return null;
        }
        // The monotonic clocks of two processes are unrelated; the time of day tells how much time passed in between.
        long passed = Math.max(0, Times.nanos(clock.wallTime()) - head.wallNanos());
        long thenNow = Math.max(kept.nowNanos(), head.nowNanos() + passed);
        return kept.later(clock.nanoTime() - thenNow);
    }
}
