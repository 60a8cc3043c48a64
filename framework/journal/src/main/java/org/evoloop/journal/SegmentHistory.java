package org.evoloop.journal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Snapshot;
import org.evoloop.rehearsal.Chronicle;
import org.evoloop.rehearsal.Ending;
import org.evoloop.statemachine.State;

/**
 * The inputs of a converter in one segment, and their results.
 *
 * @param from its state when the segment began
 * @param moments its inputs, in order
 */
record SegmentHistory(Head head, Snapshot from, List<Moment> moments) {

    /**
     * An input.
     *
     * @param atNanos the latest input time so far
     * @param visit the visit before it
     * @param endings the events that ended with it
     */
    record Moment(Input input, long atNanos, long visit, State state, List<Ending> endings) {}

    /** @throws JournalException if the segment is damaged */
    static SegmentHistory of(Path file) {
        SegmentReader segment = new SegmentReader(file);
        SegmentInputs inputs = new SegmentInputs(file, segment);
        Snapshot from = inputs.from();
        List<Ending> endings = new ArrayList<>();
        Chronicle chronicle = new Chronicle(from.visit().number(), endings::add);
        Core core = inputs.begin(chronicle);
        List<Moment> moments = new ArrayList<>();
        while (segment.next()) {
            long visit = chronicle.visit();
            State state = core.at().evolved();
            Input input = inputs.apply();
            moments.add(new Moment(input, core.nowNanos(), visit, state, List.copyOf(endings)));
            endings.clear();
        }
        return new SegmentHistory(segment.head(), from, moments);
    }
}
