package org.evoloop.page;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.evoloop.console.StatusJson;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.Trouble;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.function.Reading;
import org.evoloop.loop.Failure;
import org.evoloop.payload.JsonObject;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The converter's activity, for all viewers. It listens to the converter only while there is a viewer. All viewers get
 * the same updates; a slow one misses some, never the newest. Nothing waits for it and nothing is stored for it.
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
     * @param readings the readings of device and function with units, and what is wrong, for people
     * @param outlook see {@link OutlookJson}
     * @param last the number of the last event that ended
     * @param events the events that are new to the viewer, oldest first, at most {@value #RECENT}
     */
    record Update(
            long number, JsonObject status, JsonObject readings, JsonObject outlook, long last, List<Ended> events) {
        /** The update as JSON for the page. */
        String json() {
            return new JsonObject()
                    .put("status", status)
                    .put("readings", readings)
                    .put("outlook", outlook)
                    .put("last", last)
                    .put("events", events.stream().map(Ended::json).toList())
                    .toString();
        }

        private Update since(long seenEvent) {
            return new Update(
                    number,
                    status,
                    readings,
                    outlook,
                    last,
                    events.stream().filter(event -> event.number > seenEvent).toList());
        }
    }

    /** An event that has ended, formatted when a viewer first needs it. */
    static final class Ended {
        private final long number;
        private final HistoryEntry entry;
        private @Nullable JsonObject json;

        private Ended(HistoryEntry entry) {
            this.number = entry.number();
            this.entry = entry;
        }

        private synchronized JsonObject json() {
            JsonObject known = json;
            if (known == null) {
                known = EntryJson.of(entry);
                json = known;
            }
            return known;
        }
    }

    private final SystemEventConverter converter;
    private final Clock clock;
    private final Deque<Ended> recent = new ArrayDeque<>();
    private int viewers;
    private long last;

    /** The newest update, with all recent events. */
    private Update newest = new Update(0, new JsonObject(), new JsonObject(), new JsonObject(), 0, List.of());

    private long newestNanos;

    /** Whether anything has happened since the newest update. */
    private boolean news;

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

    /** Wakes the viewers only for the first news after an update, since this is called for every event. */
    private synchronized void update(@Nullable HistoryEntry entry) {
        if (entry != null) {
            recent.add(new Ended(entry));
            last = entry.number();
            if (recent.size() > RECENT) {
                recent.remove();
            }
        }
        if (!news) {
            news = true;
            notifyAll();
        }
    }

    /** Adds a viewer. */
    synchronized void join() {
        if (viewers++ == 0) {
            recent.clear();
            // Listening comes first: an event that ends between the two lines is in the history as well, and not in
            // neither.
            converter.addListener(listener);
            List<HistoryEntry> before = converter.history();
            last = before.isEmpty() ? 0 : before.get(before.size() - 1).number();
            renew();
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
     * Waits for the next update, at most a second.
     *
     * @param seen the number of the previous update; -1 for none
     * @param seenEvent the number of the last event that the viewer has
     */
    synchronized Update after(long seen, long seenEvent) throws InterruptedException {
        while (newest.number() <= seen) {
            // Each viewer waits for itself, and the first whose time is up makes the update for all.
            long left = (news ? PAUSE_NANOS : LOOK_NANOS) - (clock.nanoTime() - newestNanos);
            if (left > 0) {
                wait(left / 1_000_000, (int) (left % 1_000_000));
            } else {
                renew();
            }
        }
        return newest.since(seenEvent);
    }

    /** Makes an update, once for all viewers. */
    private synchronized void renew() {
        ConverterStatus status = converter.status();
        newest = new Update(
                newest.number() + 1,
                StatusJson.of(status),
                readings(status),
                OutlookJson.of(converter.outlook()),
                last,
                List.copyOf(recent));
        newestNanos = clock.nanoTime();
        news = false;
        notifyAll();
    }

    private static JsonObject readings(ConverterStatus status) {
        ConverterStatus.LinkStatus link = status.link();
        return new JsonObject()
                .put(
                        "device",
                        link == null
                                ? List.of()
                                : link.readings().stream()
                                        .map(Broadcast::reading)
                                        .toList())
                .putTexts(
                        "function",
                        status.function().readings().stream()
                                .map(Reading::toString)
                                .toList())
                .put(
                        "troubles",
                        status.troubles().stream().map(Broadcast::trouble).toList());
    }

    /** A reading as a label and its value. */
    private static JsonObject reading(Reading reading) {
        String text = reading.toString();
        String value = reading.value() instanceof Boolean holds
                ? holds ? "yes" : "no"
                : text.substring(reading.words().length()).strip();
        return new JsonObject().put("name", reading.words()).put("value", value);
    }

    private static JsonObject trouble(Trouble trouble) {
        return new JsonObject().put("part", trouble.part()).put("words", trouble.words());
    }
}
