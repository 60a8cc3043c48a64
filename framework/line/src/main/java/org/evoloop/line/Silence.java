package org.evoloop.line;

import java.io.IOException;
import java.time.Duration;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;

/**
 * Detects a silent connection: if nothing was received for a while, sends a question, and hangs up if that is not
 * answered.
 *
 * <p>Threading: thread-safe. What may block runs on separate threads, not on the clock's.
 */
final class Silence implements WireUser {
    private final Clock clock;
    private final Duration limit;
    private final String question;
    private final Reconnector wire;
    private boolean heard;
    private boolean asked;
    private Clock.@Nullable Timer next;

    Silence(Clock clock, Duration limit, String question, Reconnector wire) {
        if (limit.isNegative() || limit.isZero()) {
            throw new IllegalArgumentException("silence cannot be noticed after " + limit + "; give more than 0");
        }
        this.clock = clock;
        this.limit = Clock.requireDelay(limit);
        this.question = question;
        this.wire = wire;
    }

    @Override
    public synchronized void connected() {
        asked = false;
        look();
    }

    @Override
    public synchronized void heard(String line) {
        heard = true;
    }

    @Override
    public synchronized void lost(String why) {
        if (next != null) {
            next.cancel();
        }
        next = null;
    }

    private synchronized void look() {
        heard = false;
        next = clock.schedule(limit, this::due);
    }

    private synchronized void due() {
        if (next == null) {
            return;
        }
        if (heard) {
            asked = false;
        } else if (asked) {
            Threads.start(
                    "line-silent",
                    () -> wire.hangUp("nothing was received for "
                            + limit.multipliedBy(2).toMillis() + " ms, and '" + question + "' not answered"));
            return;
        } else {
            asked = true;
            Threads.start("line-question", this::ask);
        }
        look();
    }

    private void ask() {
        try {
            wire.write(question);
        } catch (IOException lost) {
            // The reading thread notices it, too.
        }
    }
}
