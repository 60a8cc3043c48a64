package org.evoloop.service;

import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.console.Console;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopState;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reports the converters' status to the service manager, and ends an unattended program whose converters have ended.
 *
 * <p>The watchdog is notified only while every converter responds to {@link Pulse}.
 *
 * <p>Threading: runs on its own thread, since a converter may block it.
 */
final class ServiceManager implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ServiceManager.class);
    private static final Duration LOOK = Duration.ofSeconds(1);
    private static final Duration STATUS_PERIOD = Duration.ofSeconds(10);
    private static final Duration END_LIMIT = Duration.ofSeconds(2);

    private final Console console;
    private final Clock clock;
    private final boolean unattended;
    private final Notifier notifier;
    private final Pulse pulse;
    private final Thread thread = new Thread(this::look, "evoloop-pulse");
    private String sentStatus = "";

    ServiceManager(Map<String, String> environment, Console console, Clock clock, boolean unattended) {
        this.console = console;
        this.clock = clock;
        this.unattended = unattended;
        this.notifier = new Notifier(environment);
        this.pulse = new Pulse(console.converters());
        thread.setDaemon(true);
        console.onEnd(reason -> notifier.start("STOPPING=1", "STATUS=stopping: " + reason));
    }

    /** Reports that the program is ready. */
    void ready() {
        sentStatus = status();
        notifier.send("READY=1", sentStatus);
        if (unattended || notifier.isThere()) {
            thread.start();
        }
    }

    private void look() {
        Duration watchdog = notifier.watchdog();
        // Three times per watchdog period, so that a single delay does not matter.
        long periodNanos = (watchdog == null ? STATUS_PERIOD : watchdog.dividedBy(3)).toNanos();
        Duration rest = Duration.ofNanos(Math.min(LOOK.toNanos(), periodNanos));
        long sentNanos = clock.nanoTime();
        try {
            while (!console.isEnding()) {
                clock.sleep(rest);
                endWithTheConverters();
                if (clock.nanoTime() - sentNanos >= periodNanos) {
                    sentNanos = clock.nanoTime();
                    send(watchdog != null);
                }
            }
        } catch (InterruptedException end) {
            // The program is ending, and the service manager has been notified.
        }
    }

    private void endWithTheConverters() {
        // A console that ends sets isEnding before it closes its converters, so isEnding must be read last.
        if (unattended && console.converters().stream().allMatch(ServiceManager::hasEnded) && !console.isEnding()) {
            LOG.warn("the converter was closed by a component of its own; the program ends");
            console.end("the converter was closed by a component of its own", 1);
        }
    }

    private static boolean hasEnded(SystemEventConverter converter) {
        return converter.status().loop() == LoopState.EXITED;
    }

    private void send(boolean watched) throws InterruptedException {
        if (notifier.isThere() && !console.isEnding()) {
            String trouble = pulse.trouble();
            String status = trouble.isEmpty() ? status() : "STATUS=" + trouble;
            if (watched && trouble.isEmpty()) {
                notifier.send("WATCHDOG=1", status);
            } else if (!status.equals(sentStatus)) {
                notifier.send(status);
            }
            sentStatus = status;
        }
    }

    private String status() {
        return "STATUS="
                + console.converters().stream()
                        .map(SystemEventConverter::status)
                        .map(ServiceManager::status)
                        .collect(Collectors.joining("; "));
    }

    private static String status(ConverterStatus status) {
        ConverterStatus.LinkStatus link = status.link();
        return status.name() + " " + status.loop().name().toLowerCase(Locale.ROOT) + ": "
                + status.states().original() + " / " + status.system()
                + (link == null ? "" : ", " + link.text());
    }

    @Override
    public void close() {
        thread.interrupt();
        if (!Threads.join(thread, END_LIMIT)) {
            LOG.warn("thread {} did not end within {} ms", thread.getName(), END_LIMIT.toMillis());
        }
        notifier.close();
    }
}
