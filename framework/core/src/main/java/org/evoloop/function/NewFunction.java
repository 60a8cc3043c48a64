package org.evoloop.function;

/**
 * A function that the device does not have. It starts when its state is entered and must end when the state is left.
 *
 * <p>There are three ways to write one: block in {@link #run} and let the interrupt end it; return at once and leave
 * timers ({@link Visit#finishAfter}) or listeners behind, cleaned up by {@link Visit#onEnd}; or build it from parts
 * with {@link ControlLoopFunction} or {@link StatePatternFunction}.
 *
 * <p>Threading: every visit of the state calls {@link #run} once, on a thread of its own. In a converter without
 * threads it is called on the thread that takes the steps, and must not block.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface NewFunction {

    /**
     * Performs the function.
     *
     * @param visit this visit of the state
     * @throws InterruptedException if the state is left meanwhile; that is never an error
     * @throws Exception any failure: it is reported and counted; the system stays in the state
     */
    void run(Visit visit) throws Exception;

    /** The function of a state in which nothing has to run; always the same object, which needs no thread. */
    static NewFunction none() {
        return Nothing.INSTANCE;
    }
}
