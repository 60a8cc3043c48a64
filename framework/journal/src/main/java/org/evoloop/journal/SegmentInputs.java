package org.evoloop.journal;

import java.nio.file.Path;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Outputs;
import org.evoloop.core.Rules;
import org.evoloop.core.Snapshot;
import org.evoloop.core.text.SnapshotException;
import org.evoloop.core.text.SnapshotText;

/** Tells a core of its own again what a segment holds, by the models that the segment holds. */
final class SegmentInputs {
    private final SegmentReader segment;
    private final Decoder decoder;
    private final Snapshot from;
    private final Core core;

    /** @throws JournalException if the segment's beginning is damaged */
    SegmentInputs(Path file, SegmentReader segment, Outputs outputs) {
        this.segment = segment;
        Rules rules = segment.head().rules();
        this.decoder = new Decoder(segment.cursor(), rules);
        try {
            this.from = SnapshotText.read(rules, segment.snapshot());
        } catch (SnapshotException e) {
            throw JournalException.ofDamage(file + ", record 0: " + e.getMessage());
        }
        this.core = new Core(rules, from, outputs);
    }

    /** Where the converter was when the segment began. */
    Snapshot from() {
        return from;
    }

    Core core() {
        return core;
    }

    /** The record that {@link SegmentReader#next} has come to, told to the core. @throws JournalException if it is damaged */
    Input tell() {
        try {
            Input input = decoder.read(segment.at(), segment.length());
            core.apply(input);
            return input;
        } catch (RuntimeException e) {
            throw segment.damaged("it makes no sense: " + e.getMessage());
        }
    }
}
