package org.evoloop.converter;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/**
 * A monitor whose events come from other threads: a console, a driver's callback, a web server.
 *
 * <p>Threading: {@link #push} and {@link #press} may be called from any thread and never wait.
 */
public class PushMonitor extends EventMonitor {
    private final BlockingQueue<Occurrence> pushed = new LinkedBlockingQueue<>();

    /** A monitor that is called like its class. */
    public PushMonitor() {}

    /** @param name what the console calls it, unique within a converter */
    public PushMonitor(String name) {
        super(name);
    }

    /** A control of the controller was operated. */
    public final void press(String event) {
        push(fromController(event));
    }

    /** Tells an occurrence. */
    protected final void push(Occurrence occurrence) {
        pushed.add(occurrence);
    }

    @Override
    protected final @Nullable Occurrence getEvent() throws InterruptedException {
        return hasThread() ? pushed.take() : pushed.poll();
    }
}
