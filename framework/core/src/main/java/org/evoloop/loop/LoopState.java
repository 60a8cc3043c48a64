package org.evoloop.loop;

/**
 * The lifecycle of a loop.
 *
 * <pre>
 *          build()            start()
 *   NEW ------------&gt; STOPPED --------&gt; RUNNING
 *    |                  |  ^              |  |
 *    |                  |  '--------------'  |
 *    | close()          |       stop()       |
 *    '------------------+--------------------'
 *                       | close()
 *                       v
 *                     EXITED
 * </pre>
 *
 * @since 0.1
 */
public enum LoopState {
    /** Being put together; there are no threads yet. */
    NEW,
    /** The threads run, but the loop is closed: occurrences are refused. */
    STOPPED,
    /** The loop is open. */
    RUNNING,
    /** All threads have been asked to end; nothing can be started again. */
    EXITED
}
