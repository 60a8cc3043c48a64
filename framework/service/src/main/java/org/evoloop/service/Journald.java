package org.evoloop.service;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.IThrowableProxy;
import ch.qos.logback.classic.spi.ThrowableProxyUtil;
import ch.qos.logback.core.LayoutBase;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * Log lines for the journal of systemd: each begins with its level as {@code <N>} (sd-daemon(3)), and has no time, since the
 * journal knows it.
 */
final class Journald extends LayoutBase<ILoggingEvent> {
    /** Where a standard stream of a process is found; what it leads to is a socket or a file. */
    static final Path STANDARD_ERROR = Path.of("/proc/self/fd/2");

    /**
     * Whether the journal reads {@code stream}.
     *
     * @param journalStream the variable {@code JOURNAL_STREAM}: {@code DEVICE:INODE} of the stream that systemd has opened;
     *     a program that was started with its output redirected has inherited the variable, but not the stream
     */
    static boolean reads(Path stream, @Nullable String journalStream) {
        if (journalStream == null) {
            return false;
        }
        try {
            return journalStream.equals(
                    Files.getAttribute(stream, "unix:dev") + ":" + Files.getAttribute(stream, "unix:ino"));
        } catch (IOException | UnsupportedOperationException | IllegalArgumentException unknown) {
            return false;
        }
    }

    @Override
    public String doLayout(ILoggingEvent event) {
        IThrowableProxy cause = event.getThrowableProxy();
        String text = event.getFormattedMessage() + (cause == null ? "" : "\n" + ThrowableProxyUtil.asString(cause));
        String prefix = "<" + priority(event.getLevel()) + ">";
        return text.lines().map(line -> prefix + line + "\n").collect(Collectors.joining());
    }

    /** As syslog(3) numbers them. */
    private static int priority(Level level) {
        return switch (level.toInt()) {
            case Level.ERROR_INT -> 3;
            case Level.WARN_INT -> 4;
            case Level.INFO_INT -> 6;
            default -> 7;
        };
    }
}
