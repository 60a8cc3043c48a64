package org.evoloop.gpio;

import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Debounces a contact: reports only states that last.
 *
 * <p>Threading: thread-safe; {@code whenClosed} is called on the clock's thread.
 */
final class Contact {
    private final Clock clock;
    private final Runnable whenClosed;
    private boolean now;
    private boolean settled;
    private Clock.@Nullable Timer timer;

    Contact(Clock clock, boolean closed, Runnable whenClosed) {
        this.clock = clock;
        this.whenClosed = whenClosed;
        this.now = closed;
        this.settled = closed;
    }

    synchronized void changed(boolean closed) {
        now = closed;
        if (timer != null) {
            timer.cancel();
        }
        timer = clock.schedule(GpioMonitor.SETTLED, this::settle);
    }

    private void settle() {
        if (hasClosed()) {
            whenClosed.run();
        }
    }

    private synchronized boolean hasClosed() {
        boolean news = now && !settled;
        settled = now;
        return news;
    }
}
