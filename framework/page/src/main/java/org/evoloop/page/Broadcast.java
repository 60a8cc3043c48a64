package org.evoloop.page;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.evoloop.console.JsonObject;
import org.evoloop.console.StatusJson;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.function.Reading;
import org.evoloop.loop.Failure;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The converter's activity, for all viewers. It listens to the converter only while there is a viewer. A slow viewer
 * misses intermediate updates, never the newest; nothing waits for it and nothing is stored for it.
 *
 * <p>Threading: thread-safe.
 */
final class Broadcast {
    /** The most events in one update; a viewer that has missed more requests the history. */
    static final int RECENT = 64;

    /** The refresh period: readings of the device and a function's progress change without events. */
    private static final long LOOK_NANOS = 1_000_000_000;

    /** The least time between updates, whatever the rate of events. */
    private static final long PAUSE_NANOS = 25_000_000;

    /**
     * An update for a viewer.
     *
     * @param number the number of the update, for the next call
     * @param status see {@link StatusJson}
     * @param readings the readings of device and function, with units
     * @param last the number of the last event that ended
     * @param events the events that are new to the viewer, oldest first, at most {@value #RECENT}
     */
    record Update(long number, String status, String readings, long last, List<HistoryEntry> events) {
        /** The update as JSON for the page. */
        String json() {
            List<String> entries = new ArrayList<>();
            for (HistoryEntry event : events) {
                entries.add(EntryJson.of(event).toString());
            }
            return "{\"status\":" + status + ",\"readings\":" + readings + ",\"last\":" + last + ",\"events\":["
                    + String.join(",", entries) + "]}";
        }
    }

    private final SystemEventConverter converter;
    private final Clock clock;
    private final Deque<HistoryEntry> recent = new ArrayDeque<>();
    private int viewers;
    private long number;
    private long last;
    private String status = "";
    private String readings = "";
    private long statusOf = -1;
    private long statusNanos;

    private final ConverterListener listener = new ConverterListener() {
        @Override
        public void ended(HistoryEntry entry) {
            update(entry);
        }

        @Override
        public void moved(Configuration before, Configuration after) {
            update(null);
        }

        @Override
        public void failed(Failure<Occurrence> failure) {
            update(null);
        }

        @Override
        public void doubted(String why) {
            update(null);
        }

        @Override
        public void evolved(Evolution.Result result) {
            update(null);
        }
    };

    /** @param clock a clock in real time, whatever the converter's is */
    Broadcast(SystemEventConverter converter, Clock clock) {
        this.converter = converter;
        this.clock = clock;
    }

    private synchronized void update(@Nullable HistoryEntry entry) {
        if (entry != null) {
            recent.add(entry);
            last = entry.number();
            if (recent.size() > RECENT) {
                recent.remove();
            }
        }
        number++;
        notifyAll();
    }

    /** Adds a viewer. */
    synchronized void join() {
        if (viewers++ == 0) {
            recent.clear();
            converter.addListener(listener);
            List<HistoryEntry> newest = converter.history();
            last = newest.isEmpty() ? 0 : newest.get(newest.size() - 1).number();
        }
    }

    /** Removes a viewer. */
    synchronized void leave() {
        if (--viewers == 0) {
            converter.removeListener(listener);
        }
    }

    /** The number of viewers. */
    synchronized int viewers() {
        return viewers;
    }

    /**
     * Waits for news, at most a second.
     *
     * @param seen the number of the previous update; -1 for none
     * @param seenEvent the number of the last event that the viewer has
     */
    Update after(long seen, long seenEvent) throws InterruptedException {
        synchronized (this) {
            if (seen >= 0) {
                await(PAUSE_NANOS, Long.MAX_VALUE);
            }
            await(LOOK_NANOS, seen);
        }
        return update(seenEvent);
    }

    private synchronized void await(long nanos, long seen) throws InterruptedException {
        long end = clock.nanoTime() + nanos;
        for (long left = nanos; number <= seen && left > 0; left = end - clock.nanoTime()) {
            wait(left / 1_000_000, (int) (left % 1_000_000));
        }
    }

    private synchronized Update update(long seenEvent) {
        long now = clock.nanoTime();
        if (statusOf != number || now - statusNanos >= LOOK_NANOS / 2) {
            // Once for all viewers.
            ConverterStatus is = converter.status();
            status = StatusJson.of(is);
            readings = readings(is);
            statusOf = number;
            statusNanos = now;
        }
        List<HistoryEntry> missed = new ArrayList<>();
        for (HistoryEntry entry : recent) {
            if (entry.number() > seenEvent) {
                missed.add(entry);
            }
        }
        return new Update(number, status, readings, last, missed);
    }

    private static String readings(ConverterStatus status) {
        ConverterStatus.LinkStatus link = status.link();
        return new JsonObject()
                .putTexts("device", link == null ? List.of() : texts(link.readings()))
                .putTexts("function", texts(status.function().readings()))
                .toString();
    }

    private static List<String> texts(List<Reading> readings) {
        return readings.stream().map(Reading::toString).toList();
    }
}
