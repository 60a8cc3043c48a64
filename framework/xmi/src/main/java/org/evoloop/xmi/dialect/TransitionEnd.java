package org.evoloop.xmi.dialect;

/**
 * One end of a transition, for messages: the same mistake is told in the same words, whatever the dialect.
 *
 * @param transition name and id
 * @param role which end it is, as the dialect calls it
 */
public record TransitionEnd(String transition, String role) {

    /** That it has no such end, or several. */
    public String notOne(boolean none) {
        return "transition " + transition + " has " + (none ? "no " : "more than one ") + role
                + "; draw it from one state to one state";
    }

    /** That the end is something else: {@code what}, with its kind and label. */
    public String noVertex(String what) {
        return "the " + role + " of transition " + transition + " is not a vertex of this state machine but " + what
                + "; draw it from state to state";
    }
}
