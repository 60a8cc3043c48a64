package org.evoloop.journal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Rules;
import org.evoloop.core.Snapshot;
import org.evoloop.core.text.SnapshotException;
import org.evoloop.core.text.SnapshotText;
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
        Rules rules = segment.head().rules();
        Chronicle chronicle = new Chronicle();
        Snapshot from;
        try {
            from = SnapshotText.read(rules, segment.snapshot());
        } catch (SnapshotException e) {
            throw JournalException.ofDamage(file + ", record 0: " + e.getMessage());
        }
        Core core = new Core(rules, from, chronicle);
        Decoder decoder = new Decoder(segment.cursor(), rules);
        List<Moment> moments = new ArrayList<>();
        while (segment.next()) {
            Input input;
            try {
                input = decoder.read(segment.at(), segment.length());
            } catch (RuntimeException e) {
                throw segment.damaged("it makes no sense: " + e.getMessage());
            }
            long visit = Math.max(from.visit().number(), chronicle.visit());
            State state = core.at().evolved();
            core.apply(input);
            moments.add(new Moment(input, core.nowNanos(), visit, state));
        }
        return new Told(segment.head(), from, moments, new LinkedHashMap<>(chronicle.endings()));
    }
}
