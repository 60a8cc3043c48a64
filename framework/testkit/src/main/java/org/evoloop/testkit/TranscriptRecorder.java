package org.evoloop.testkit;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.AppenderBase;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.slf4j.ILoggerFactory;
import org.slf4j.LoggerFactory;

/**
 * Records the transcript of one converter without threads: its lines come on the thread that steps it.
 *
 * <p>Threading: one thread, like its harness; those of several harnesses may run in parallel.
 */
final class TranscriptRecorder {
    private static final String LOGGER = "org.evoloop.transcript";

    /** The transcript's format for a step that has had its effect. */
    private static final String COMMAND = " {} command";

    /** The recorder of the converter that runs on this thread. */
    private static final ThreadLocal<@Nullable TranscriptRecorder> LISTENING = new ThreadLocal<>();

    private static final boolean AVAILABLE = listen();

    private final List<String> lines = new ArrayList<>();
    private final List<String> sent = new ArrayList<>();

    private static boolean listen() {
        ILoggerFactory factory = LoggerFactory.getILoggerFactory();
        if (!(factory instanceof LoggerContext context)) {
            return false;
        }
        Logger logger = context.getLogger(LOGGER);
        if (!logger.isInfoEnabled()) {
            // If the transcript is silenced in tests, it stays silenced.
            logger.setAdditive(false);
            logger.setLevel(Level.INFO);
        }
        Ear ear = new Ear();
        ear.setContext(context);
        ear.start();
        logger.addAppender(ear);
        return true;
    }

    private static final class Ear extends AppenderBase<ILoggingEvent> {
        @Override
        protected void append(ILoggingEvent event) {
            TranscriptRecorder listening = LISTENING.get();
            if (listening != null) {
                listening.add(event);
            }
        }
    }

    private void add(ILoggingEvent event) {
        lines.add(event.getFormattedMessage());
        if (event.getMessage().equals(COMMAND)) {
            sent.add(String.valueOf(event.getArgumentArray()[0]));
        }
    }

    /**
     * Records the lines on this thread while {@code work} runs, except those of other converters within it.
     */
    void during(Runnable work) {
        TranscriptRecorder before = LISTENING.get();
        LISTENING.set(this);
        try {
            work.run();
        } finally {
            LISTENING.set(before);
        }
    }

    boolean isAvailable() {
        return AVAILABLE;
    }

    List<String> lines() {
        requireAvailable();
        return List.copyOf(lines);
    }

    /** The events of the steps that have had their effect. */
    List<String> sent() {
        requireAvailable();
        return List.copyOf(sent);
    }

    private void requireAvailable() {
        if (!AVAILABLE) {
            throw new IllegalStateException("the transcript is recorded through Logback, and SLF4J has found "
                    + LoggerFactory.getILoggerFactory().getClass().getName()
                    + "; leave logback-classic the only SLF4J provider on the tests' class path");
        }
    }
}
