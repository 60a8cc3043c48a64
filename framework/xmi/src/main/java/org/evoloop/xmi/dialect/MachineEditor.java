package org.evoloop.xmi.dialect;

import org.evoloop.statemachine.ModelException;

/**
 * Edits the text of one machine. Each method changes the lines that it concerns and no others, once; a state is called
 * by its name or key, and a transition is found by its line.
 *
 * <p>Errors: a {@link ModelException} says why something cannot be done; then the text has not been used.
 *
 * <p>Threading: for one thread.
 */
public interface MachineEditor {
    /** Whether the machine has no state yet. */
    boolean isEmpty();

    /** Adds a state, in another one or, if {@code parent} is empty, at the top. The first one in a region is its start. */
    int addState(String name, String parent);

    /** Adds a transition; {@code guard} may be empty. */
    int addTransition(String source, String target, String event, String guard);

    /** Renames a state. */
    int renameState(String from, String to);

    /** Renames the device state in which new states want the device. */
    void renameDeviceState(String from, String to);

    /** Gives a transition other events, separated by commas. */
    int setTrigger(int line, String event);

    /** Gives a transition another guard; none if it is empty. */
    int setGuard(int line, String guard);

    /** Says in which state the device must be while in this one; none if it is empty. */
    int setDeviceState(String state, String device);

    /** Makes a state the start of its region. */
    int setInitial(String state);

    /** Gives a transition other ends; an empty name keeps one. */
    int retarget(int line, String source, String target);

    /** Removes a transition. */
    int deleteTransition(int line);

    /** Removes a state with its contents and all transitions from and to it. */
    int deleteState(String state);

    /** The text as it is now. */
    String text();
}
