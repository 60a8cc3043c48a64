package org.evoloop.converter.attachment;

import org.jspecify.annotations.Nullable;

/** Calls code that a user wrote. */
public final class UserCode {
    private UserCode() {}

    /** What a user wrote. */
    @FunctionalInterface
    public interface Call {
        void run() throws Exception;
    }

    /**
     * Makes {@code call}, and contains what it throws: exceptions, and those errors that are about its own code. Others,
     * such as that there is no memory left, are nobody's to contain.
     *
     * @return what it has thrown; null if it has returned
     * @throws InterruptedException if the thread was interrupted, which is no failure
     */
    public static @Nullable Throwable call(Call call) throws InterruptedException {
        try {
            call.run();
            return null;
        } catch (InterruptedException stop) {
            throw stop;
        } catch (Exception | LinkageError | AssertionError | StackOverflowError cause) {
            return cause;
        }
    }
}
