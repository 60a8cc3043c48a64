package org.evoloop.converter;

import java.util.LinkedHashMap;
import java.util.Map;
import org.evoloop.loop.Failure;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Logs failures and warnings so that one that happens again and again cannot flood the log: the first, the second, the fourth, the
 * eighth, and so on.
 *
 * <p>Threading: thread-safe.
 */
final class FailureLog {
    private static final Logger LOG = LoggerFactory.getLogger(SystemEventConverter.class);
    private static final int DISTINCT = 100;

    private final Map<String, Long> counts = new LinkedHashMap<>();

    void log(Failure<?> failure) {
        long count = count(failure.toString());
        if (count == 1 && isBug(failure.cause())) {
            LOG.error("{}", failure, failure.cause());
        } else {
            warn(failure.toString(), count);
        }
    }

    /**
     * The same for what is no failure of a component.
     *
     * @param what the same text each time that the same happens
     */
    void warn(String what) {
        warn(what, count(what));
    }

    private static void warn(String what, long count) {
        if (Long.bitCount(count) == 1) {
            LOG.warn("{}{}", what, count == 1 ? "" : " (" + count + " times)");
        }
    }

    /** A stack trace helps the author of a component, but not a user who has unplugged the device. */
    private static boolean isBug(Throwable cause) {
        return cause.getClass().getName().startsWith("java.")
                && (cause instanceof RuntimeException || cause instanceof Error);
    }

    private synchronized long count(String what) {
        if (counts.size() >= DISTINCT && !counts.containsKey(what)) {
            counts.remove(counts.keySet().iterator().next());
        }
        long count = counts.getOrDefault(what, 0L) + 1;
        counts.put(what, count);
        return count;
    }
}
