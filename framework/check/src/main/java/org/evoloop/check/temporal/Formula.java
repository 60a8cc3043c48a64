package org.evoloop.check.temporal;

import java.util.List;
import org.evoloop.evolution.ModelPair;

/**
 * A formula of computation tree logic (CTL) over moments.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Formula {
    /** Its parts, in order. */
    default List<Formula> operands() {
        return List.of();
    }

    /** Whether it is about one moment only, not about the future. */
    default boolean isPlain() {
        boolean simple = this instanceof Constant || this instanceof Atom || this instanceof Not;
        return (simple || this instanceof And || this instanceof Or)
                && operands().stream().allMatch(Formula::isPlain);
    }

    /** Whether it names something of this kind anywhere. */
    default boolean names(Kind kind) {
        return (this instanceof Atom atom && atom.kind() == kind)
                || operands().stream().anyMatch(operand -> operand.names(kind));
    }

    /**
     * Whether it holds in {@code moment}.
     *
     * @param pair the models of the moment
     * @throws IllegalStateException if it is not {@linkplain #isPlain plain}
     */
    default boolean isSeenIn(Moment moment, ModelPair pair) {
        if (this instanceof Constant constant) {
            return constant.value();
        } else if (this instanceof Atom atom) {
            return moment.shows(atom, pair);
        } else if (this instanceof Not not) {
            return !not.operand().isSeenIn(moment, pair);
        } else if (this instanceof And and) {
            return and.left().isSeenIn(moment, pair) && and.right().isSeenIn(moment, pair);
        } else if (this instanceof Or or) {
            return or.left().isSeenIn(moment, pair) || or.right().isSeenIn(moment, pair);
        }
        throw new IllegalStateException(this + " is about more than one moment");
    }

    /** A formula of one part. */
    sealed interface Unary extends Formula {
        /** The operand. */
        Formula operand();

        @Override
        default List<Formula> operands() {
            return List.of(operand());
        }
    }

    /** A formula of two parts. */
    sealed interface Binary extends Formula {
        /** The operand before the operator. */
        Formula left();

        /** The operand after the operator. */
        Formula right();

        @Override
        default List<Formula> operands() {
            return List.of(left(), right());
        }
    }

    /** True or false. */
    record Constant(boolean value) implements Formula {}

    /** A fact that can be observed in a moment. */
    record Atom(Kind kind, String name) implements Formula {}

    /** The kind of an atom. */
    enum Kind {
        /** The state of the new model. */
        STATE,
        /** The state of the original model, that is, of the device. */
        DEVICE,
        /** The event that has led here. */
        EVENT,
        /** The running function of a new state. */
        FUNCTION
    }

    /** Negation. */
    record Not(Formula operand) implements Unary {}

    /** Both. */
    record And(Formula left, Formula right) implements Binary {}

    /** At least one. */
    record Or(Formula left, Formula right) implements Binary {}

    /** Now and for ever, whatever happens. */
    record Always(Formula operand) implements Unary {}

    /** Now, or if the right events come. */
    record Can(Formula operand) implements Unary {}

    /** Now or later, whatever happens. */
    record Eventually(Formula operand) implements Unary {}

    /** After any one event. */
    record Next(Formula operand) implements Unary {}

    /** {@code left} holds for as long as {@code right} does not, which may be for ever. */
    record Unless(Formula left, Formula right) implements Binary {}

    /** {@code left} holds until {@code right} does, which must come. */
    record Until(Formula left, Formula right) implements Binary {}
}
