package org.evoloop.journal;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Outputs;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.codec.CodecException;
import org.evoloop.engine.codec.SnapshotText;
import org.jspecify.annotations.Nullable;

/** Replays a segment on a core of its own, with the models that the segment contains. */
final class SegmentInputs {
    private final SegmentReader segment;
    private final Decoder decoder;
    private final Snapshot from;
    private final Rules rules;
    private @Nullable Core core;

    /** @throws JournalException if the segment's beginning is damaged */
    SegmentInputs(Path file, SegmentReader segment) {
        this.segment = segment;
        this.rules = segment.head().rules();
        this.decoder = new Decoder(segment.cursor(), rules);
        try {
            this.from = SnapshotText.read(rules, segment.snapshot());
        } catch (CodecException e) {
            throw JournalException.ofDamage(file, ", record 0: " + e.getMessage());
        }
    }

    /** The converter's state when the segment began. */
    Snapshot from() {
        return from;
    }

    /** The rules by which the segment was written. */
    Rules rules() {
        return rules;
    }

    /** Creates the core, which gives its outputs to these. */
    Core begin(Outputs outputs) {
        Core begun = new Core(rules, from, outputs);
        core = begun;
        return begun;
    }

    /**
     * Gives the record at which {@link SegmentReader#next} has arrived to the core. @throws JournalException if it is
     * damaged
     */
    Input apply() {
        try {
            Input input = decoder.read(segment.at(), segment.length());
            requireNonNull(core).apply(input);
            return input;
        } catch (RuntimeException e) {
            throw segment.damaged("it is inconsistent: " + e.getMessage());
        }
    }
}
