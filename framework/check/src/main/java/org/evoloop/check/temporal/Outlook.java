package org.evoloop.check.temporal;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.check.PairGraph;
import org.evoloop.evolution.DecisionTable;

/**
 * Decides whether a formula holds in a moment, by everything that can happen from there according to a converter's
 * decisions.
 *
 * <p>Threading: not thread-safe; it caches its results.
 *
 * @since 0.1
 */
public final class Outlook {
    private final DecisionTable table;
    private final List<Labels> known = new ArrayList<>();

    /**
     * An outlook by the decisions of a converter.
     *
     * @param table the decisions for a valid pair
     */
    public Outlook(DecisionTable table) {
        this.table = table;
    }

    /**
     * Whether {@code formula} holds in {@code moment}, which need not be reachable by expected events. The first answer
     * about the future takes as long as exploring all reachable moments.
     */
    public boolean holds(Formula formula, Moment moment) {
        return formula.isPlain()
                ? formula.isSeenIn(moment, table.models())
                : from(moment).where(formula).contains(moment);
    }

    private Labels from(Moment moment) {
        if (known.isEmpty()) {
            known.add(labels(new Moment(table.models().initial(), null)));
        }
        for (Labels labels : known) {
            if (labels.graph().moments().contains(moment)) {
                return labels;
            }
        }
        Labels labels = labels(moment);
        known.add(labels);
        return labels;
    }

    private Labels labels(Moment start) {
        return new Labels(new MomentGraph(new PairGraph(start.at(), table), start), table.models());
    }
}
