package org.evoloop.check.temporal;

/**
 * What a formula requires of future moments, which are observed one after another.
 *
 * <p>A formula about all possible futures requires the same of the actual one. A formula about one possible future,
 * such as {@code can}, requires nothing to happen: it is a fact about a moment, which the models determine.
 *
 * <p>Threading: immutable.
 */
sealed interface Duty {
    /** That this holds in the moment. */
    record Fact(Formula formula) implements Duty {}

    /** Both. */
    record Both(Duty left, Duty right) implements Duty {}

    /** At least one. */
    record Either(Duty left, Duty right) implements Duty {}

    /** In this moment and each that follows. */
    record Always(Duty duty) implements Duty {}

    /** In the moment that follows. */
    record Next(Duty duty) implements Duty {}

    /** {@code left} in each moment before one with {@code right}; {@code must} if there has to be one. */
    record Until(Duty left, Duty right, boolean must) implements Duty {}

    /** The duty that {@code formula} holds, or that it does not. */
    static Duty of(Formula formula, boolean wanted) {
        if (formula.isPlain()) {
            return fact(formula, wanted);
        } else if (formula instanceof Formula.Not not) {
            return of(not.operand(), !wanted);
        } else if (formula instanceof Formula.And and) {
            Duty left = of(and.left(), wanted);
            Duty right = of(and.right(), wanted);
            return wanted ? new Both(left, right) : new Either(left, right);
        } else if (formula instanceof Formula.Or or) {
            Duty left = of(or.left(), wanted);
            Duty right = of(or.right(), wanted);
            return wanted ? new Either(left, right) : new Both(left, right);
        }
        return wanted && !(formula instanceof Formula.Can) ? later(formula) : fact(formula, wanted);
    }

    private static Duty fact(Formula formula, boolean wanted) {
        return new Fact(wanted ? formula : new Formula.Not(formula));
    }

    private static Duty later(Formula formula) {
        if (formula instanceof Formula.Always always) {
            return new Always(of(always.operand(), true));
        } else if (formula instanceof Formula.Next next) {
            return new Next(of(next.operand(), true));
        } else if (formula instanceof Formula.Eventually eventually) {
            return new Until(new Fact(new Formula.Constant(true)), of(eventually.operand(), true), true);
        } else if (formula instanceof Formula.Unless unless) {
            return new Until(of(unless.left(), true), of(unless.right(), true), false);
        } else if (formula instanceof Formula.Until until) {
            return new Until(of(until.left(), true), of(until.right(), true), true);
        }
        throw new AssertionError(formula);
    }

    /** Whether something that has to come has not come yet. */
    default boolean isOwed() {
        if (this instanceof Both both) {
            return both.left().isOwed() || both.right().isOwed();
        } else if (this instanceof Either either) {
            return either.left().isOwed() && either.right().isOwed();
        } else if (this instanceof Until until) {
            return until.must();
        }
        return this instanceof Fact || this instanceof Next;
    }
}
