package org.evoloop.models.temporal;

import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.Moment;
import org.evoloop.check.temporal.Outlook;
import org.evoloop.evolution.ModelPair;

/**
 * Informative prefixes by their definition (Kupferman and Vardi, 2001): whether the moments so far show by themselves
 * that a formula is broken, whatever follows. Examines all of them again each time.
 */
final class Refutation {
    private final ModelPair pair;
    private final Outlook outlook;
    private List<Moment> moments = List.of();

    Refutation(ModelPair pair, Outlook outlook) {
        this.pair = pair;
        this.outlook = outlook;
    }

    boolean of(Formula formula, List<Moment> seen) {
        moments = seen;
        return refuted(formula, 0);
    }

    private boolean refuted(Formula formula, int at) {
        if (formula.isPlain()) {
            return !formula.isSeenIn(moments.get(at), pair);
        } else if (formula instanceof Formula.Not not) {
            return shown(not.operand(), at);
        } else if (formula instanceof Formula.And and) {
            return refuted(and.left(), at) || refuted(and.right(), at);
        } else if (formula instanceof Formula.Or or) {
            return refuted(or.left(), at) && refuted(or.right(), at);
        } else if (formula instanceof Formula.Can) {
            return !outlook.holds(formula, moments.get(at));
        } else if (formula instanceof Formula.Always always) {
            return any(at, later -> refuted(always.operand(), later));
        } else if (formula instanceof Formula.Next next) {
            return at + 1 < moments.size() && refuted(next.operand(), at + 1);
        } else if (formula instanceof Formula.Unless unless) {
            return brokenOff(unless.left(), unless.right(), at);
        } else if (formula instanceof Formula.Until until) {
            return brokenOff(until.left(), until.right(), at);
        }
        return false;
    }

    private boolean shown(Formula formula, int at) {
        if (formula.isPlain()) {
            return formula.isSeenIn(moments.get(at), pair);
        } else if (formula instanceof Formula.Not not) {
            return refuted(not.operand(), at);
        } else if (formula instanceof Formula.And and) {
            return shown(and.left(), at) && shown(and.right(), at);
        } else if (formula instanceof Formula.Or or) {
            return shown(or.left(), at) || shown(or.right(), at);
        }
        return outlook.holds(formula, moments.get(at));
    }

    private boolean brokenOff(Formula left, Formula right, int at) {
        return any(
                at,
                end -> refuted(left, end) && IntStream.rangeClosed(at, end).allMatch(before -> refuted(right, before)));
    }

    private boolean any(int from, IntPredicate test) {
        return IntStream.range(from, moments.size()).anyMatch(test);
    }
}
