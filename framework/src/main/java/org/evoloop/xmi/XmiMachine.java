package org.evoloop.xmi;

import java.util.Optional;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;

/**
 * One state machine of an {@link XmiFile}, not checked yet.
 *
 * <p>Threading: immutable.
 */
public interface XmiMachine {

    /** The {@code xmi.id}, unique in a file that its tool wrote; empty if the file gives none. */
    String id();

    /** The machine's own name, often the tool's default such as {@code StateMachine0}; may be empty. */
    String machineName();

    /** The name of the diagram that shows the machine: the one its author sees; empty if there is none. */
    Optional<String> diagramName();

    /** Where the machine starts in the file, counted from 1. */
    int line();

    /**
     * The machine as (E, S, T).
     *
     * @throws ModelException if it holds anything that is not supported or not valid; the message lists all of it, one
     *     line each
     */
    StateMachine toStateMachine();

    /** What messages call it: the diagram name, else the machine's own name, else its id. */
    default String name() {
        return diagramName().orElse(machineName().isEmpty() ? id() : machineName());
    }

    /** Whether {@code name} is the diagram name, the machine's own name or the id. */
    default boolean answersTo(String name) {
        return name.equals(id())
                || name.equals(machineName())
                || diagramName().filter(name::equals).isPresent();
    }
}
