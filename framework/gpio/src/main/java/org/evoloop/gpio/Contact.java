package org.evoloop.gpio;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Debounces a contact: reports only states that last.
 *
 * <p>Threading: thread-safe; {@code news} is called on the clock's thread.
 */
final class Contact {
    private final Clock clock;
    private final Duration lasting;
    private final Consumer<Boolean> news;
    private boolean now;
    private boolean settled;
    private Clock.@Nullable Timer timer;

    /**
     * A contact.
     *
     * @param lasting how long a state must last to count
     * @param closed its state now, which is no news
     * @param news receives whether it is closed, when that has changed
     */
    Contact(Clock clock, Duration lasting, boolean closed, Consumer<Boolean> news) {
        this.clock = clock;
        this.lasting = lasting;
        this.news = news;
        this.now = closed;
        this.settled = closed;
    }

    synchronized void changed(boolean closed) {
        now = closed;
        if (timer != null) {
            timer.cancel();
        }
        timer = clock.schedule(lasting, this::settle);
    }

    private void settle() {
        // Outside of the lock: what is told may wait.
        change().ifPresent(news);
    }

    private synchronized Optional<Boolean> change() {
        boolean same = now == settled;
        settled = now;
        return same ? Optional.empty() : Optional.of(now);
    }
}
