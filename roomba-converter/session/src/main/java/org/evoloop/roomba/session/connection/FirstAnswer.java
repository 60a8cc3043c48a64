package org.evoloop.roomba.session.connection;

import java.util.concurrent.CompletableFuture;

/**
 * The first frame of a robot, and who waits for it.
 *
 * <p>Threading: thread-safe.
 */
final class FirstAnswer {
    private final CompletableFuture<Void> answer = new CompletableFuture<>();
    private volatile boolean patient;
    private volatile Runnable greeting = () -> {};

    /** Nothing but the end is a failure from now on; {@code firstGreeting} is run when the frame comes. */
    void waitPatiently(Runnable firstGreeting) {
        patient = true;
        greeting = firstGreeting;
    }

    /** A frame has come. */
    void came() {
        if (answer.complete(null)) {
            greeting.run();
        }
    }

    /** None has come in time. */
    void failed(RuntimeException cause) {
        if (!patient) {
            answer.completeExceptionally(cause);
        }
    }

    /** None will come any more. */
    void ended(RuntimeException cause) {
        answer.completeExceptionally(cause);
    }

    CompletableFuture<Void> future() {
        return answer;
    }
}
