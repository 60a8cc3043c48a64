package org.evoloop.converter;

import java.util.concurrent.CompletableFuture;
import org.evoloop.evolution.EventOutcome;
import org.jspecify.annotations.Nullable;

/**
 * An event on its way into the converter, and the future of its outcome. The reason why it is not taken is known better to
 * who submits it than to the core, and wins.
 *
 * <p>Threading: thread-safe.
 */
final class Submission {
    final CompletableFuture<EventOutcome> outcome = new CompletableFuture<>();
    private boolean taken;
    private @Nullable EventOutcome early;

    synchronized void ended(EventOutcome ended) {
        if (taken) {
            outcome.complete(ended);
        } else {
            early = ended;
        }
    }

    synchronized void taken() {
        taken = true;
        if (early != null) {
            outcome.complete(early);
        }
    }

    void notTaken(EventOutcome why) {
        outcome.complete(why);
    }
}
