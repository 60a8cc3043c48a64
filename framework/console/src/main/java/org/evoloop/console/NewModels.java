package org.evoloop.console;

import java.util.List;
import java.util.function.Function;
import org.evoloop.converter.Probation;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;

/**
 * Reads the models that {@code evolve} names, see {@link Console#evolvesBy}.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface NewModels {
    /**
     * Reads any model, and offers some of them.
     *
     * @param references what is offered, each as {@code FILE#NAME}, such as all machines of a file
     * @param reader as {@link #read}
     */
    static NewModels offering(List<String> references, Function<String, StateMachine> reader) {
        List<String> offered = List.copyOf(references);
        return new NewModels() {
            @Override
            public StateMachine read(String reference) {
                return reader.apply(reference);
            }

            @Override
            public List<String> offered() {
                return offered;
            }
        };
    }

    /**
     * Reads a machine.
     *
     * @param reference {@code FILE#NAME}
     * @throws org.evoloop.statemachine.ModelException if there is none, or it is invalid; the message says what and
     *     where
     */
    StateMachine read(String reference);

    /**
     * The new models offered as a choice, as {@code FILE#NAME}; those that do not fit the device are left out, see
     * {@link OfferedModels}. Others may also be named.
     */
    default List<String> offered() {
        return List.of();
    }

    /**
     * What has to hold while the models are on probation, in addition to the absence of failures.
     *
     * @param reference the reference of the new model
     * @param next both models
     * @throws org.evoloop.statemachine.ModelException if its properties cannot be understood
     */
    default Probation.Watches watches(String reference, ModelPair next) {
        return Probation.NONE.watches();
    }
}
