package org.evoloop.roomba.session.connection;

import java.util.concurrent.CompletableFuture;

/**
 * The first frame of a robot, and waiting for it.
 *
 * <p>Threading: thread-safe.
 */
final class FirstAnswer {
    private final CompletableFuture<Void> answer = new CompletableFuture<>();
    private volatile boolean patient;
    private volatile Runnable greeting = () -> {};

    /** From now on only the end counts as a failure; {@code firstGreeting} is run when the frame comes. */
    void waitPatiently(Runnable firstGreeting) {
        patient = true;
        greeting = firstGreeting;
    }

    /** A frame was received. */
    void came() {
        if (answer.complete(null)) {
            greeting.run();
        }
    }

    /** No frame was received in time. */
    void failed(RuntimeException cause) {
        if (!patient) {
            answer.completeExceptionally(cause);
        }
    }

    /** No frame will be received any more. */
    void ended(RuntimeException cause) {
        answer.completeExceptionally(cause);
    }

    CompletableFuture<Void> future() {
        return answer;
    }
}
