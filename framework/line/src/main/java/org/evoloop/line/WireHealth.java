package org.evoloop.line;

import java.time.Instant;
import org.evoloop.time.Attempts;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Whether a wire is connected, and what is wrong with it. A fault is logged once, until it changes or ends.
 *
 * <p>Threading: updated by the reading thread, read by any.
 */
final class WireHealth {
    private static final Logger LOG = LoggerFactory.getLogger(LineConnection.class);

    private final String place;
    private final Clock clock;
    private final Attempts attempts = new Attempts();
    private volatile @Nullable Instant downSince;
    private volatile String trouble;

    /** @param place the wire's destination, for messages */
    WireHealth(String place, Clock clock) {
        this.place = place;
        this.clock = clock;
        this.downSince = clock.wallTime();
        this.trouble = place + " has not been reached yet";
    }

    void up() {
        downSince = null;
        trouble = "";
        if (attempts.succeeded(clock.nanoTime())) {
            LOG.info("{} is connected", place);
        }
    }

    void down(String why) {
        if (downSince == null) {
            downSince = clock.wallTime();
        }
        trouble = why;
    }

    /** Logs a new fault, and pauses before the next attempt. */
    void tryAgain() throws InterruptedException {
        if (attempts.failed(trouble, clock.nanoTime())) {
            LOG.warn("{}; trying to connect again", trouble);
        }
        clock.sleep(attempts.pause());
    }

    /** When the wire was lost; null while it is connected. */
    @Nullable
    Instant downSince() {
        return downSince;
    }

    /** What is wrong; empty if nothing is. */
    String trouble() {
        return trouble;
    }
}
