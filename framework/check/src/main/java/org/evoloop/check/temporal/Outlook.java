package org.evoloop.check.temporal;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.check.PairGraph;
import org.evoloop.evolution.DecisionTable;

/**
 * Whether a formula holds in a moment, by what can happen from there: the decisions of a converter say that.
 *
 * <p>Threading: not thread-safe; it remembers what it has found out.
 *
 * @since 0.1
 */
public final class Outlook {
    private final DecisionTable table;
    private final List<Labels> known = new ArrayList<>();

    /**
     * By the decisions of a converter.
     *
     * @param table of a valid pair
     */
    public Outlook(DecisionTable table) {
        this.table = table;
    }

    /**
     * Whether {@code formula} holds in {@code moment}, which need not be one that events as they should go lead to. The
     * first answer about the future takes as long as to look at every moment that can be reached.
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
