package org.evoloop.journal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Output;
import org.evoloop.journal.JournalFiles.SegmentInfo;

/** The records of one segment, in order, and the converter's states at each. */
final class SegmentRecords {
    private final Path file;
    private final SegmentReader segment;
    private final SegmentInputs inputs;
    private final Core core;
    private final List<JournalRecord> records = new ArrayList<>();
    private final List<String> endings = new ArrayList<>();

    SegmentRecords(Path file, SegmentReader segment) {
        this.file = file;
        this.segment = segment;
        this.inputs = new SegmentInputs(file, segment);
        this.core = inputs.begin(this::heard);
        while (segment.next()) {
            records.add(record());
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
        Input input = inputs.apply();
        List<String> ended = List.copyOf(endings);
        endings.clear();
        return new JournalRecord(
                name(),
                segment.number(),
                segment.at(),
                segment.head().wallTime(core.nowNanos()),
                core.nowNanos(),
                JournalFiles.word(segment.kind()),
                input,
                core.at(),
                core.doubt(),
                ended);
    }

    /** The record of the takeover by this segment's models from those of {@code before}. */
    JournalRecord evolvedFrom(SegmentInfo before) {
        Head head = segment.head();
        Core begun = new SegmentInputs(file, segment).begin(output -> {});
        return new JournalRecord(
                name(),
                0,
                Preamble.BYTES,
                head.wallTime(head.nowNanos()),
                head.nowNanos(),
                "evolved",
                new Input.Changed(begun.rules(), head.nowNanos()),
                begun.at(),
                begun.doubt(),
                List.of("'" + head.models().evolved().name() + "' took over from '" + before.evolved() + "'"));
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
                head.wallTime(head.nowNanos()),
                records.size(),
                segment.isTorn());
    }
}
