package org.evoloop.service;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.IThrowableProxy;
import ch.qos.logback.classic.spi.ThrowableProxyUtil;
import ch.qos.logback.core.LayoutBase;
import java.util.stream.Collectors;

/**
 * Log lines for systemd's journal: each begins with its level as {@code <N>} (sd-daemon(3)), and has no time, since the
 * journal adds it.
 */
final class Journald extends LayoutBase<ILoggingEvent> {
    @Override
    public String doLayout(ILoggingEvent event) {
        IThrowableProxy cause = event.getThrowableProxy();
        String text = event.getFormattedMessage() + (cause == null ? "" : "\n" + ThrowableProxyUtil.asString(cause));
        String prefix = "<" + priority(event.getLevel()) + ">";
        return text.lines().map(line -> prefix + line + "\n").collect(Collectors.joining());
    }

    /** The level's number in syslog(3). */
    private static int priority(Level level) {
        return switch (level.toInt()) {
            case Level.ERROR_INT -> 3;
            case Level.WARN_INT -> 4;
            case Level.INFO_INT -> 6;
            default -> 7;
        };
    }
}
