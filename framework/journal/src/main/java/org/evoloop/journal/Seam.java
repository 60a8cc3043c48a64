package org.evoloop.journal;

import java.util.List;
import org.evoloop.engine.Core;
import org.evoloop.engine.Outputs;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Work;

/**
 * Where one segment of a journal ends and the next begins.
 *
 * @param end the state with which one ended
 * @param next the state with which the next begins
 */
record Seam(Snapshot end, Rules before, Rules rules, Snapshot next) {

    static Seam between(Core before, SegmentHistory segment) {
        return new Seam(before.snapshot(), before.rules(), segment.rules(), segment.from());
    }

    /** By how much the clock of the next segment's process is ahead. */
    long nanos() {
        return next.lastStepNanos() - end.lastStepNanos();
    }

    /** Whether another process has continued. */
    boolean isRestart() {
        if (isSame(end, next) || isSame(changed(), next)) {
            return false;
        }
        Core core = restarted(output -> {});
        core.recovered(next.nowNanos());
        return isSame(core.snapshot(), next);
    }

    /** The state of the next process before it has recovered. */
    Core restarted(Outputs outputs) {
        return new Core(rules, end.later(nanos()), outputs);
    }

    /** Whether something is missing between the two, if no process has ended. */
    boolean isGap() {
        return !isSame(end, next) && !isSame(changed(), next) && !isRestart();
    }

    /** The state after other components have come. */
    private Snapshot changed() {
        Core core = new Core(before, end, output -> {});
        core.changed(rules, next.nowNanos());
        return core.snapshot();
    }

    /** Whether both are the same, apart from values that the journal does not show. */
    private static boolean isSame(Snapshot one, Snapshot another) {
        return one.open() == another.open()
                && one.at().equals(another.at())
                && one.nowNanos() == another.nowNanos()
                && one.steps() == another.steps()
                && one.lastStepNanos() == another.lastStepNanos()
                && one.visit().equals(another.visit())
                && one.followOwed() == another.followOwed()
                && one.tally().equals(another.tally())
                && numbers(one).equals(numbers(another));
    }

    private static List<Object> numbers(Snapshot of) {
        List<Object> numbers = new java.util.ArrayList<>();
        for (Pending pending : of.waiting()) {
            numbers.add(pending.number());
        }
        Work work = of.work();
        if (work != null) {
            numbers.add(work.pending().number());
            numbers.add(work.stage());
        }
        return numbers;
    }
}
