package org.evoloop.check.timing;

/** Searches for the first violation of the first watched property, and measures its best and worst values. */
final class Measuring implements Exploration.Judge {
    private final Exploration exploration;
    private final boolean stops;
    private long best = Long.MAX_VALUE;
    private long worst = -1;
    private boolean violated;
    private boolean lapsed;
    private int from;
    private int label;

    /** @param stops whether a violation is enough */
    Measuring(Exploration exploration, boolean stops) {
        this.exploration = exploration;
        this.stops = stops;
    }

    @Override
    public boolean goes(int before, int by, Rows rows) {
        if (rows.measured != TimeMonitor.NONE) {
            best = Math.min(best, rows.leastMeasured);
            worst = Math.max(worst, rows.measured);
        }
        if ((rows.violated & 1) != 0) {
            lapsed |= by == Exploration.TICK;
            if (!violated) {
                violated = true;
                from = before;
                label = by;
            }
        }
        return violated && stops;
    }

    boolean isViolated() {
        return violated;
    }

    /** Whether a time has run out without the required event. */
    boolean hasLapsed() {
        return lapsed;
    }

    int from() {
        return from;
    }

    int label() {
        return label;
    }

    /** The lowest value, in nanoseconds or as a count; -1 if it never occurred. */
    long best() {
        return best == Long.MAX_VALUE ? -1 : best;
    }

    TimeVerdict verdict(TimeProperty property, Exploration explored) {
        boolean isCount = property.form() instanceof TimeForm.Count;
        long unit = isCount ? 1 : exploration.clocks.ticks.nanos();
        return new TimeVerdict(
                property,
                !violated,
                best() < 0 ? -1 : best() * unit,
                worst < 0 ? -1 : worst * unit,
                explored.visited.size());
    }
}
