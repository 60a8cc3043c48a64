package org.evoloop.service;

import java.io.File;
import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.Trouble;
import org.evoloop.statemachine.Names;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs the operator's command for each new trouble of a converter: the option {@code --on-trouble}. The command gets
 * the words in its environment. One runs at a time, for at most {@link #limit}, and for the same part at most once in
 * {@link #QUIET}; what is still wrong then is told then. A command that fails is reported once, until it works again.
 *
 * <p>Threading: runs on its own thread, which no converter waits for.
 */
final class TroubleHook implements AutoCloseable {
    /** For how long a part that was told of is not told of again. */
    static final Duration QUIET = Duration.ofMinutes(1);

    /** How often the converters are looked at. */
    static final Duration LOOK = Duration.ofMillis(500);

    /** How long the command may take. */
    static final Duration LIMIT = Duration.ofSeconds(30);

    private static final Logger LOG = LoggerFactory.getLogger(TroubleHook.class);
    private static final Duration END_LIMIT = Duration.ofSeconds(2);

    private record Part(String converter, String name) {}

    /** The last time that a part was told of, and whether that trouble has lasted since. */
    private record Told(long nanos, long times, boolean lasts) {}

    private final String command;
    private final List<SystemEventConverter> converters;
    private final Clock clock;
    private final Duration limit;
    private final Map<Part, Told> told = new HashMap<>();
    private final Thread thread = new Thread(this::run, "evoloop-on-trouble");
    private boolean failing;

    /** @param limit how long the command may take */
    TroubleHook(String command, List<SystemEventConverter> converters, Clock clock, Duration limit) {
        this.command = command;
        this.converters = List.copyOf(converters);
        this.clock = clock;
        this.limit = limit;
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    private void run() {
        try {
            while (true) {
                look();
                clock.sleep(LOOK);
            }
        } catch (InterruptedException end) {
            // It is being closed.
        }
    }

    private void look() throws InterruptedException {
        Set<Part> present = new HashSet<>();
        for (SystemEventConverter converter : converters) {
            ConverterStatus status = converter.status();
            for (Trouble trouble : status.troubles()) {
                Part part = new Part(status.name(), trouble.part());
                present.add(part);
                if (isDue(told.get(part), trouble.times())) {
                    told.put(part, new Told(clock.nanoTime(), trouble.times(), true));
                    tell(status.name(), trouble);
                }
            }
        }
        told.replaceAll((part, last) -> new Told(last.nanos(), last.times(), last.lasts() && present.contains(part)));
        told.values().removeIf(last -> !last.lasts() && isLongAgo(last));
    }

    private boolean isDue(@Nullable Told last, long times) {
        return last == null || ((!last.lasts() || times > last.times()) && isLongAgo(last));
    }

    private boolean isLongAgo(Told last) {
        return clock.nanoTime() - last.nanos() >= QUIET.toNanos();
    }

    private void tell(String converter, Trouble trouble) throws InterruptedException {
        ProcessBuilder builder = new ProcessBuilder("sh", "-c", command)
                .redirectInput(new File("/dev/null"))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.INHERIT);
        builder.environment().put("EVOLOOP_CONVERTER", Names.inOneLine(converter));
        builder.environment().put("EVOLOOP_PART", Names.inOneLine(trouble.part()));
        builder.environment().put("EVOLOOP_TROUBLE", Names.inOneLine(trouble.words()));
        String failure;
        try {
            failure = failure(builder.start());
        } catch (IOException noShell) {
            failure = String.valueOf(noShell.getMessage());
        }
        if (!failure.isEmpty() && !failing) {
            LOG.warn(
                    "the command of --on-trouble failed for '{}': {}; this is not repeated until it works",
                    trouble.words(),
                    failure);
        }
        failing = !failure.isEmpty();
    }

    /** How the command failed; empty if it did not. */
    private String failure(Process process) throws InterruptedException {
        try {
            if (!process.waitFor(limit.toNanos(), TimeUnit.NANOSECONDS)) {
                return "it did not end within " + limit.toSeconds() + " s, so it was killed";
            }
            return process.exitValue() == 0 ? "" : "it ended with status " + process.exitValue();
        } finally {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
        }
    }

    /** Ends it, and a command that is still running. Idempotent. */
    @Override
    public void close() {
        thread.interrupt();
        if (!Threads.join(thread, END_LIMIT)) {
            LOG.warn("thread {} did not end within {} ms", thread.getName(), END_LIMIT.toMillis());
        }
    }
}
