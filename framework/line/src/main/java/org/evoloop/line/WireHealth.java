package org.evoloop.line;

import java.time.Instant;
import org.evoloop.time.Attempts;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Whether a wire is there, and what is wrong with it, which is logged once until it is something else or over.
 *
 * <p>Threading: told by the thread that reads, asked by any.
 */
final class WireHealth {
    private static final Logger LOG = LoggerFactory.getLogger(LineConnection.class);

    private final String place;
    private final Clock clock;
    private final Attempts attempts = new Attempts();
    private volatile @Nullable Instant downSince;
    private volatile String trouble;

    /** @param place where the wire leads, for messages */
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

    /** It will be tried again. */
    void tryAgain() throws InterruptedException {
        if (attempts.failed(trouble, clock.nanoTime())) {
            LOG.warn("{}; it is tried again until it works", trouble);
        }
        clock.sleep(attempts.pause());
    }

    /** Since when it has been gone; null while it is there. */
    @Nullable
    Instant downSince() {
        return downSince;
    }

    /** What is wrong; empty if nothing is. */
    String trouble() {
        return trouble;
    }
}
