package org.evoloop.journal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.engine.Input;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;

/**
 * The inputs of a converter in one segment.
 *
 * @param rules those by which it was written
 * @param from the converter's state when the segment began
 * @param inputs in order
 */
record SegmentHistory(Head head, Rules rules, Snapshot from, List<Input> inputs) {

    /** @throws JournalException if the segment is damaged */
    static SegmentHistory of(Path file) {
        SegmentReader segment = new SegmentReader(file);
        SegmentInputs inputs = new SegmentInputs(file, segment);
        inputs.begin(output -> {});
        List<Input> all = new ArrayList<>();
        while (segment.next()) {
            all.add(inputs.apply());
        }
        return new SegmentHistory(segment.head(), inputs.rules(), inputs.from(), all);
    }
}
