package org.evoloop.loop;

/**
 * The status of one component.
 *
 * <p>Threading: immutable; a snapshot of one moment.
 *
 * @param name the component's name
 * @param role its role in the loop
 * @param thread the name of the thread that calls it, possibly shared with others, or in which it is stuck; empty in a
 *     loop without threads
 * @param activity its present activity: waiting, working, stuck or ended
 * @param failures how often it has failed
 * @param lastFailure the message of the last failure, empty if there was none
 * @since 0.1
 */
public record ComponentStatus(
        String name, Component.Role role, String thread, Activity activity, long failures, String lastFailure) {

    /** The activity of a component. */
    public enum Activity {
        /** It waits for work; of a monitor, for something to occur. */
        WAITING,
        /** It works on an occurrence. */
        WORKING,
        /** It was interrupted and has not returned; it should be exchanged. */
        STUCK,
        /** No thread calls it, or no longer. */
        ENDED
    }
}
