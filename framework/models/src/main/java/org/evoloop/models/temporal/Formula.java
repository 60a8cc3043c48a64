package org.evoloop.models.temporal;

import java.util.List;

/**
 * A formula of computation tree logic over moments.
 *
 * <p>Threading: immutable.
 */
sealed interface Formula {
    /** Its parts, in order. */
    default List<Formula> operands() {
        return List.of();
    }

    /** A formula of one part. */
    sealed interface Unary extends Formula {
        Formula operand();

        @Override
        default List<Formula> operands() {
            return List.of(operand());
        }
    }

    /** A formula of two parts. */
    sealed interface Binary extends Formula {
        Formula left();

        Formula right();

        @Override
        default List<Formula> operands() {
            return List.of(left(), right());
        }
    }

    /** True or false. */
    record Constant(boolean value) implements Formula {}

    /** Something that can be seen of a moment. */
    record Atom(Kind kind, String name) implements Formula {}

    /** What an atom is about. */
    enum Kind {
        /** The state of the new model. */
        STATE,
        /** The state of the original model: where the device is. */
        DEVICE,
        /** The event that has led here. */
        EVENT,
        /** The function of a new state that runs. */
        FUNCTION
    }

    record Not(Formula operand) implements Unary {}

    record And(Formula left, Formula right) implements Binary {}

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
