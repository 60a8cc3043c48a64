package org.evoloop.check.timing;

import java.util.List;
import java.util.Set;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.timing.Situation.Branch;
import org.evoloop.statemachine.Event;

/** Computes the clocks after an event, and after a tick. */
final class Rows {
    private final Clocks clocks;
    private final Situations situations;
    private final Surroundings around;

    /** What the monitors said of the row that was made last: a bit for each that was violated. */
    int violated;

    /** How long it took, or how many there were, that the first monitor has seen the end of. */
    long measured = TimeMonitor.NONE;

    long leastMeasured = TimeMonitor.NONE;

    private final List<Set<Event>> raised;

    /** @param raised for each monitor what follows from its violation */
    Rows(Clocks clocks, Situations situations, Surroundings around, List<Set<Event>> raised) {
        this.raised = raised;
        this.clocks = clocks;
        this.situations = situations;
        this.around = around;
    }

    /** Where nothing has happened yet. */
    int[] first() {
        int[] row = new int[clocks.length];
        for (int gap = 0; gap < clocks.gaps.size(); gap++) {
            row[clocks.gapsAt + gap] = clocks.ticks.of(clocks.gaps.get(gap).minNanos());
        }
        return row;
    }

    /** Whether no control of this kind was pressed too short a while ago. */
    boolean mayCome(Stimulus stimulus, int[] row) {
        for (int gap = 0; gap < clocks.gaps.size(); gap++) {
            Assumption.Gap assumed = clocks.gaps.get(gap);
            if (concerns(assumed, stimulus) && row[clocks.gapsAt + gap] < clocks.ticks.of(assumed.minNanos())) {
                return false;
            }
        }
        return true;
    }

    private boolean concerns(Assumption.Gap gap, Stimulus stimulus) {
        Event event = stimulus.event();
        return gap.event() == null
                ? around.isPress(stimulus)
                : event != null && gap.event().equals(event.name());
    }

    /**
     * The row after something has happened.
     *
     * @param coming which of the awaited events it was; -1 if none
     * @param owed the monitor whose violation it followed from; -1 if none
     */
    void happen(int[] row, Edge edge, int coming, int owed, int[] next) {
        Branch branch = edge.branch;
        System.arraycopy(row, 0, next, 0, row.length);
        next[Clocks.SITUATION] = branch.target().number;
        next[Clocks.STEP] = branch.sends() || branch.target().sending() == null ? 0 : row[Clocks.STEP];
        for (int slot = Clocks.TIMERS; slot < clocks.gapsAt; slot++) {
            int place = slot - Clocks.TIMERS;
            long timer = place < branch.timers().size() ? branch.timers().get(place) : 0;
            next[slot] = timer >= 0 ? clocks.ticks.of(timer) : row[Clocks.TIMERS + (int) (-1 - timer)];
        }
        for (int gap = 0; gap < clocks.gaps.size(); gap++) {
            if (edge.stimulus != null && concerns(clocks.gaps.get(gap), edge.stimulus)) {
                next[clocks.gapsAt + gap] = 0;
            }
        }
        for (int index = 0; index < clocks.comings.size(); index++) {
            int place = clocks.comingsAt + index;
            next[place] = awaited(next[place], edge, index, index == coming);
        }
        if (owed >= 0) {
            next[clocks.owedAt + owed] = 0;
        }
        watch(row, edge, next);
    }

    private int awaited(int before, Edge edge, int index, boolean hasCome) {
        Assumption.Comes comes = clocks.comings.get(index);
        int value = hasCome ? clocks.max(comes) + 2 : before;
        for (boolean lasts : edge.lasts[index]) {
            value = !lasts ? 0 : value == 0 ? 1 : value;
        }
        boolean anew = edge.branch.enters() && comes.during().kind() != Formula.Kind.DEVICE;
        return anew && value > 0 ? 1 : value;
    }

    private void watch(int[] row, Edge edge, int[] next) {
        violated = 0;
        measured = TimeMonitor.NONE;
        leastMeasured = TimeMonitor.NONE;
        if (clocks.monitors.isEmpty()) {
            return;
        }
        clocks.recall(row);
        for (int index = 0; index < clocks.monitors.size(); index++) {
            TimeMonitor monitor = clocks.monitors.get(index);
            for (int code : edge.seen[index]) {
                if (monitor.sees(Clocks.NOW, (code & 1) != 0, (code & 2) != 0)) {
                    violate(index, next);
                }
                if (index == 0 && monitor.measured != TimeMonitor.NONE) {
                    leastMeasured =
                            measured == TimeMonitor.NONE ? monitor.measured : Math.min(leastMeasured, monitor.measured);
                    measured = Math.max(measured, monitor.measured);
                }
            }
        }
        clocks.note(next, Clocks.NOW);
    }

    private void violate(int monitor, int[] next) {
        violated |= 1 << monitor;
        next[clocks.owedAt + monitor] = raised.get(monitor).isEmpty() ? 0 : 1;
    }

    /** The row one tick later. */
    void pass(int[] row, int[] next) {
        System.arraycopy(row, 0, next, 0, row.length);
        Situation situation = situations.number(row[Clocks.SITUATION]);
        if (situation.sending() != null) {
            next[Clocks.STEP]++;
        }
        for (int timer = 0; timer < situation.timers.size(); timer++) {
            int slot = Clocks.TIMERS + timer;
            next[slot] = Math.max(0, row[slot] - 1);
        }
        for (int gap = 0; gap < clocks.gaps.size(); gap++) {
            int slot = clocks.gapsAt + gap;
            next[slot] =
                    Math.min(row[slot] + 1, clocks.ticks.of(clocks.gaps.get(gap).minNanos()));
        }
        for (int index = 0; index < clocks.comings.size(); index++) {
            int slot = clocks.comingsAt + index;
            next[slot] = row[slot] == 0 ? 0 : Math.min(row[slot] + 1, clocks.max(clocks.comings.get(index)) + 2);
        }
        violated = 0;
        measured = TimeMonitor.NONE;
        if (!clocks.monitors.isEmpty()) {
            clocks.recall(row);
            for (int index = 0; index < clocks.monitors.size(); index++) {
                if (clocks.monitors.get(index).lapsed(Clocks.NOW + 1)) {
                    violate(index, next);
                }
            }
            clocks.note(next, Clocks.NOW + 1);
        }
    }
}
