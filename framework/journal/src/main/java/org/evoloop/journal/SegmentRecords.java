package org.evoloop.journal;

import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Output;
import org.evoloop.core.Rules;
import org.evoloop.core.text.SnapshotException;
import org.evoloop.core.text.SnapshotText;
import org.evoloop.journal.JournalFiles.SegmentInfo;

/** The records of one segment, in order, and where the converter was at each. */
final class SegmentRecords {
    private final Path file;
    private final SegmentReader segment;
    private final Core core;
    private final Decoder decoder;
    private final List<JournalRecord> records = new ArrayList<>();
    private final List<String> endings = new ArrayList<>();

    SegmentRecords(Path file, SegmentReader segment) {
        this.file = file;
        this.segment = segment;
        Rules rules = segment.head().rules();
        this.decoder = new Decoder(segment.cursor(), rules);
        this.core = core(rules);
        while (segment.next()) {
            try {
                records.add(record());
            } catch (RuntimeException e) {
                throw segment.damaged("it makes no sense: " + e.getMessage());
            }
        }
    }

    private Core core(Rules rules) {
        try {
            return new Core(rules, SnapshotText.read(rules, segment.snapshot()), this::heard);
        } catch (SnapshotException e) {
            throw JournalException.ofDamage(file + ", record 0: " + e.getMessage());
        }
    }

    private void heard(Output output) {
        if (output instanceof Output.Ended ended) {
            endings.add(ended.occurrence().label() + " " + JournalFiles.word(ended.outcome())
                    + (ended.detail().isEmpty() ? "" : ": " + ended.detail()));
        } else if (output instanceof Output.Dropped dropped) {
            endings.add(dropped.occurrence().label() + " dropped: the queue was full");
        } else if (output instanceof Output.Refused refused) {
            endings.add(refused.occurrence().label() + " refused: the converter is stopped");
        }
    }

    private JournalRecord record() {
        Input input = decoder.read(segment.at(), segment.length());
        core.apply(input);
        List<String> ended = List.copyOf(endings);
        endings.clear();
        return new JournalRecord(
                name(),
                segment.number(),
                segment.at(),
                wallTime(),
                core.nowNanos(),
                JournalFiles.word(segment.kind()),
                input,
                core.at(),
                core.doubt(),
                ended);
    }

    private Instant wallTime() {
        Head head = segment.head();
        return Instant.ofEpochSecond(0, head.wallNanos() + core.nowNanos() - head.nowNanos());
    }

    private String name() {
        return String.valueOf(file.getFileName());
    }

    List<JournalRecord> records() {
        return records;
    }

    SegmentInfo info() {
        Head head = segment.head();
        return new SegmentInfo(
                name(),
                head.fingerprint(),
                head.models().original().name(),
                head.models().evolved().name(),
                Instant.ofEpochSecond(0, head.wallNanos()),
                records.size(),
                segment.isTorn());
    }
}
