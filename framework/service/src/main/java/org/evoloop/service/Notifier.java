package org.evoloop.service;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sends {@code sd_notify} messages to {@code $NOTIFY_SOCKET}; does nothing if there is none.
 *
 * <p>The JDK does not support datagrams on Unix sockets. The program {@code systemd-notify}, which comes with systemd,
 * does, and supports every kind of address that systemd uses.
 *
 * <p>Threading: thread-safe.
 */
final class Notifier implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Notifier.class);
    private static final String SOCKET = "NOTIFY_SOCKET";
    private static final long LIMIT_SECONDS = 5;

    private final Map<String, String> environment;
    private @Nullable Process last;
    private boolean warned;

    Notifier(Map<String, String> environment) {
        this.environment = environment;
    }

    /** Whether a service manager expects messages. */
    boolean isThere() {
        return !environment.getOrDefault(SOCKET, "").isEmpty();
    }

    /** The watchdog's period, in which it must receive a message; null if there is no watchdog. */
    @Nullable
    Duration watchdog() {
        String micros = environment.getOrDefault("WATCHDOG_USEC", "");
        String meant = environment.getOrDefault("WATCHDOG_PID", "");
        boolean ours = meant.isEmpty()
                || meant.equals(Long.toString(ProcessHandle.current().pid()));
        return isThere() && ours && micros.matches("[1-9][0-9]{0,17}")
                ? Duration.ofNanos(Math.multiplyExact(Long.parseLong(micros), 1000))
                : null;
    }

    /** Sends {@code fields}, such as {@code READY=1}, in one message, and waits until it is sent. */
    void send(String... fields) {
        start(fields);
        awaitLast();
    }

    /** Sends {@code fields} without waiting. */
    synchronized void start(String... fields) {
        if (!isThere()) {
            return;
        }
        awaitLast();
        List<String> command = new ArrayList<>(List.of("systemd-notify"));
        command.addAll(List.of(fields));
        ProcessBuilder builder = new ProcessBuilder(command)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD);
        builder.environment().put(SOCKET, environment.getOrDefault(SOCKET, ""));
        try {
            last = builder.start();
        } catch (IOException failure) {
            warn("systemd-notify cannot be run: " + failure.getMessage());
        }
    }

    private synchronized void awaitLast() {
        Process running = last;
        last = null;
        if (running == null) {
            return;
        }
        try {
            if (!running.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS)) {
                running.destroyForcibly();
                warn("systemd-notify has not ended within " + LIMIT_SECONDS + " s");
            } else if (running.exitValue() != 0) {
                warn("systemd-notify has ended with status " + running.exitValue());
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    private void warn(String problem) {
        if (!warned) {
            warned = true;
            LOG.warn("the service manager cannot be notified: {}", problem);
        }
    }

    /** Waits until everything has been sent. */
    @Override
    public void close() {
        awaitLast();
    }
}
