package org.evoloop.loop;

/**
 * What is to be known of one component.
 *
 * <p>Threading: immutable; a picture of one moment.
 *
 * @param name the component's name
 * @param role its place in the loop
 * @param thread the name of the thread that calls it, which it may share with others, or in which it is stuck; empty in a
 *     loop without threads
 * @param activity what it does now: waiting, working, stuck or ended
 * @param failures how often it has failed
 * @param lastFailure the message of the last failure, empty if there was none
 * @since 0.1
 */
public record ComponentStatus(
        String name, Component.Role role, String thread, Activity activity, long failures, String lastFailure) {

    /** What a component does. */
    public enum Activity {
        /** It waits for work; of a monitor, for something to occur. */
        WAITING,
        /** It works on an occurrence. */
        WORKING,
        /** It was interrupted and has not returned; exchange it. */
        STUCK,
        /** No thread calls it, or none any more. */
        ENDED
    }
}
