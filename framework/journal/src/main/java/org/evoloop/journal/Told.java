package org.evoloop.journal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Snapshot;
import org.evoloop.statemachine.State;

/**
 * What a converter was told while a segment was written, and what it made of it.
 *
 * @param from where it was when the segment began
 * @param moments its inputs, in order
 * @param endings what became of the events
 */
record Told(Head head, Snapshot from, List<Moment> moments, Map<EventKey, Chronicle.Ending> endings) {

    /**
     * An input.
     *
     * @param atNanos the latest time that was told by then
     * @param visit of which state, before
     */
    record Moment(Input input, long atNanos, long visit, State state) {}

    /** @throws JournalException if the segment is damaged */
    static Told of(Path file) {
        SegmentReader segment = new SegmentReader(file);
        Chronicle chronicle = new Chronicle();
        SegmentInputs inputs = new SegmentInputs(file, segment, chronicle);
        Core core = inputs.core();
        Snapshot from = inputs.from();
        List<Moment> moments = new ArrayList<>();
        while (segment.next()) {
            long visit = Math.max(from.visit().number(), chronicle.visit());
            State state = core.at().evolved();
            moments.add(new Moment(inputs.tell(), core.nowNanos(), visit, state));
        }
        return new Told(segment.head(), from, moments, new LinkedHashMap<>(chronicle.endings()));
    }
}
