package org.evoloop.service;

import ch.qos.logback.classic.ClassicConstants;
import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.PatternLayout;
import ch.qos.logback.classic.spi.Configurator;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.ConsoleAppender;
import ch.qos.logback.core.Layout;
import ch.qos.logback.core.LayoutBase;
import ch.qos.logback.core.encoder.LayoutWrappingEncoder;
import ch.qos.logback.core.joran.spi.ConsoleTarget;
import ch.qos.logback.core.spi.ContextAwareBase;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Configures a program's log: the transcript goes to stdout, warnings and errors to stderr, in systemd's journal with
 * their levels. Logback finds this class as a service; a {@code logback.xml} takes precedence. Parsing such a file, and
 * patterns before they are needed, would take a tenth of a program's start-up time.
 *
 * <p>Threading: called once by Logback.
 *
 * @since 0.1
 */
public final class ProgramLog extends ContextAwareBase implements Configurator {
    /** For Logback's service loader. */
    public ProgramLog() {}

    @Override
    public ExecutionStatus configure(LoggerContext context) {
        if (isFileGiven()) {
            return ExecutionStatus.INVOKE_NEXT_IF_ANY;
        }
        Logger transcript = context.getLogger("org.evoloop.transcript");
        transcript.setLevel(Level.INFO);
        transcript.setAdditive(false);
        transcript.addAppender(appender(ConsoleTarget.SystemOut, new Lines()));
        Logger root = context.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
        root.setLevel(Level.WARN);
        root.addAppender(
                appender(ConsoleTarget.SystemErr, ErrorOutput.isJournal() ? new Journald() : new TimedLines()));
        return ExecutionStatus.DO_NOT_INVOKE_NEXT_IF_ANY;
    }

    private static boolean isFileGiven() {
        return System.getProperty(ClassicConstants.CONFIG_FILE_PROPERTY) != null
                || Stream.of(ClassicConstants.TEST_AUTOCONFIG_FILE, ClassicConstants.AUTOCONFIG_FILE)
                        .anyMatch(file -> ClassLoader.getSystemResource(file) != null);
    }

    private ConsoleAppender<ILoggingEvent> appender(ConsoleTarget target, Layout<ILoggingEvent> layout) {
        layout.setContext(getContext());
        layout.start();
        LayoutWrappingEncoder<ILoggingEvent> encoder = new LayoutWrappingEncoder<>();
        encoder.setContext(getContext());
        encoder.setLayout(layout);
        encoder.start();
        ConsoleAppender<ILoggingEvent> appender = new ConsoleAppender<>();
        appender.setContext(getContext());
        appender.setName(target.getName());
        appender.setTarget(target.getName());
        appender.setEncoder(encoder);
        appender.start();
        return appender;
    }

    /** Only the message. */
    private static final class Lines extends LayoutBase<ILoggingEvent> {
        @Override
        public String doLayout(ILoggingEvent event) {
            return event.getFormattedMessage() + System.lineSeparator();
        }
    }

    /**
     * Time, level, message, and an exception if there is one. Thread-safe, since an appender calls it under its lock.
     */
    private static final class TimedLines extends LayoutBase<ILoggingEvent> {
        private @Nullable PatternLayout pattern;

        @Override
        public String doLayout(ILoggingEvent event) {
            PatternLayout layout = pattern;
            if (layout == null) {
                layout = new PatternLayout();
                layout.setContext(getContext());
                layout.setPattern("%d{HH:mm:ss.SSS} %-5level %msg%n");
                layout.start();
                pattern = layout;
            }
            return layout.doLayout(event);
        }
    }
}
