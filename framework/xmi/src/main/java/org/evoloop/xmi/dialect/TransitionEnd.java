package org.evoloop.xmi.dialect;

/**
 * One end of a transition, for messages. Every dialect then reports the same mistake in the same words.
 *
 * @param transition name and id
 * @param role the dialect's name for this end
 */
public record TransitionEnd(String transition, String role) {

    /** The message that there is no such end, or more than one. */
    public String notOne(boolean none) {
        return "transition " + transition + " has " + (none ? "no " : "more than one ") + role
                + "; draw it from one state to one state";
    }

    /** The message that the end refers to something else: {@code what}, with its kind and label. */
    public String noVertex(String what) {
        return "the " + role + " of transition " + transition + " is not a vertex of this state machine but " + what
                + "; draw it from state to state";
    }
}
