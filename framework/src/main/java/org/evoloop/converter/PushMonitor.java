package org.evoloop.converter;

import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/**
 * A monitor whose events come from other threads: a console, a driver's callback, a web server.
 *
 * <p>Threading: {@link #push} and {@link #press} may be called from any thread and never wait. Once the loop has been
 * built they tell it directly, since the monitor's own thread would have to be woken first; what one thread pushes stays
 * in order.
 */
public class PushMonitor extends EventMonitor {
    private final BlockingQueue<Occurrence> pushed = new LinkedBlockingQueue<>();

    /** How many the monitor's own thread has still to tell; none may overtake them. */
    private final AtomicInteger behind = new AtomicInteger();

    private boolean telling;

    /** A monitor that is called like its class. */
    public PushMonitor() {}

    /** @param name what the console calls it, unique within a converter */
    public PushMonitor(String name) {
        super(name);
    }

    /**
     * A control of the controller was operated.
     *
     * @throws IllegalArgumentException if neither model knows the event; the message tells the nearest names
     * @throws IllegalStateException if the converter is not running, or this monitor is not part of one: the press is
     *     refused
     */
    public final void press(String event) {
        Occurrence pressed = fromController(event);
        requireHeard(pressed);
        push(pressed);
    }

    /** Tells an occurrence. What is told while the converter is stopped is refused, and counted by {@code status}. */
    protected final void push(Occurrence occurrence) {
        Objects.requireNonNull(occurrence, "the occurrence is null");
        if (behind.get() > 0 || !tell(occurrence)) {
            behind.incrementAndGet();
            pushed.add(occurrence);
        }
    }

    @Override
    protected final @Nullable Occurrence getEvent() throws InterruptedException {
        if (telling) {
            // Whoever asks again has told the last one.
            telling = false;
            behind.decrementAndGet();
        }
        Occurrence next = hasThread() ? pushed.take() : pushed.poll();
        telling = next != null;
        return next;
    }
}
