package org.evoloop.learn;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.learn.Heard.Reply;
import org.evoloop.time.Clock;

/**
 * A device behind a running converter whose models assume nothing: the states that the device reports, each with a loop for
 * every event, for {@link LookExecute#LOOK} and for {@link LookExecute#SEEN}.
 *
 * <p>Threading: as every device that is learned; the converter's threads tell it what happened.
 *
 * @since 0.1
 */
public final class ConverterDevice implements LearnedDevice {
    private static final Duration TICK = Duration.ofMillis(5);
    private static final Duration PATIENCE = Duration.ofSeconds(30);
    /** How often the events of the reset are sent until the device is at home. */
    private static final int MOST_ROUNDS = 10;

    private final SystemEventConverter converter;
    private final PushMonitor buttons;
    private final String home;
    private final List<String> resets;
    private final Duration settle;
    private final Clock clock;
    private final BlockingQueue<News> news = new LinkedBlockingQueue<>();
    private String shown = "";
    /** When it was first heard that the device is as it is. */
    private long since;

    private int sent;

    private record News(HistoryEntry entry, long nanos) {}

    /**
     * @param converter a converter that runs
     * @param buttons its monitor through which events are pressed
     * @param home the state to which the device is reset; empty if it does not say where it is
     * @param resets the events that bring it there
     * @param settle how long nothing must happen after an event
     */
    public ConverterDevice(
            SystemEventConverter converter, PushMonitor buttons, String home, List<String> resets, Duration settle) {
        this.converter = requireNonNull(converter, "the converter is null");
        this.buttons = requireNonNull(buttons, "the monitor is null");
        this.home = home;
        this.resets = List.copyOf(resets);
        this.settle = settle;
        this.clock = converter.clock();
        converter.addListener(new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                news.add(new News(entry, clock.nanoTime()));
            }
        });
    }

    /** How many events were sent to the device. */
    @Override
    public int sent() {
        return sent;
    }

    @Override
    public Heard reset() throws InterruptedException {
        look();
        for (int round = 0; round < MOST_ROUNDS; round++) {
            if (home.isEmpty() ? round > 0 : shown.equals(home)) {
                return Heard.accepted(shown);
            }
            for (String event : resets) {
                if (home.isEmpty() || !shown.equals(home)) {
                    send(event);
                    quiet();
                }
            }
        }
        throw new LostException("the device could not be brought to " + home + " by " + String.join(", ", resets)
                + "; it is in " + shown + "; correct learn.reset, or bring it there by hand");
    }

    @Override
    public Heard press(String event) throws InterruptedException {
        requireNothingHappened();
        Reply reply = send(event);
        return new Heard(reply, quiet(), shown, Duration.ZERO);
    }

    @Override
    public Heard await(Duration longest) throws InterruptedException {
        long begin = since;
        String before = shown;
        List<String> acts = new ArrayList<>();
        while (clock.nanoTime() - begin < longest.toNanos()) {
            look();
            acts.addAll(acts());
            if (!acts.isEmpty() || !shown.equals(before)) {
                Duration lasted = Duration.ofNanos(since - begin);
                acts.addAll(quiet());
                return new Heard(Reply.ACCEPTED, acts, shown, lasted);
            }
            clock.sleep(settle);
        }
        return Heard.silent(shown);
    }

    @Override
    public Map<String, Double> readings() {
        Map<String, Double> numbers = new HashMap<>();
        ConverterStatus.LinkStatus link = converter.status().link();
        if (link != null) {
            link.readings().forEach(reading -> {
                try {
                    numbers.put(reading.name(), Double.valueOf(String.valueOf(reading.value())));
                } catch (NumberFormatException text) {
                    // Not a number: no rule is about it.
                }
            });
        }
        return numbers;
    }

    private Reply send(String event) throws InterruptedException {
        sent++;
        EventOutcome outcome = submit(event);
        since = clock.nanoTime();
        if (outcome.isHandled()) {
            return Reply.ACCEPTED;
        }
        if (outcome instanceof EventOutcome.Failed failed) {
            return failed.why().contains("unknown") ? Reply.UNANSWERED : Reply.REFUSED;
        }
        throw new DisturbedException(event + ": " + outcome);
    }

    private EventOutcome submit(String event) throws InterruptedException {
        ConverterStatus.LinkStatus link = converter.status().link();
        long begin = clock.nanoTime();
        while (link != null && !link.up()) {
            if (clock.nanoTime() - begin > PATIENCE.toNanos()) {
                throw new LostException("the device cannot be reached: " + link.text());
            }
            clock.sleep(TICK);
            link = converter.status().link();
        }
        CompletableFuture<EventOutcome> outcome = buttons.submit(event);
        while (!outcome.isDone()) {
            if (clock.nanoTime() - begin > PATIENCE.toNanos()) {
                throw new LostException("the device does not take " + event + " within " + PATIENCE.toSeconds()
                        + " s; switch it off and on");
            }
            clock.sleep(TICK);
        }
        return outcome.join();
    }

    /** Listens until nothing has happened for a time; returns what the device did by itself. */
    private List<String> quiet() throws InterruptedException {
        List<String> acts = new ArrayList<>();
        long begin = clock.nanoTime();
        while (clock.nanoTime() - begin < settle.toNanos()) {
            clock.sleep(TICK);
            List<String> more = acts();
            if (!more.isEmpty()) {
                acts.addAll(more);
                begin = clock.nanoTime();
            }
        }
        look();
        acts.addAll(acts());
        return acts;
    }

    /** Lets the converter ask the device where it is. */
    private void look() throws InterruptedException {
        submit(LookExecute.LOOK);
        submit(LookExecute.SEEN);
        String now = converter.status().states().original().name();
        if (!now.equals(shown)) {
            shown = now;
            since = clock.nanoTime();
        }
    }

    /** What the device did by itself since this was called last. */
    private List<String> acts() {
        List<String> acts = new ArrayList<>();
        for (News next = news.poll(); next != null; next = news.poll()) {
            Occurrence occurrence = next.entry().occurrence();
            if (occurrence instanceof Occurrence.Heard heard && heard.source() == Source.DEVICE) {
                acts.add(heard.event().name());
                since = next.nanos();
            } else if (occurrence instanceof Occurrence.Heard other && isForeign(other)) {
                throw new DisturbedException("somebody pressed " + other.event());
            }
        }
        return acts;
    }

    /** Whether a person pressed something: what is sent from here was answered before its entry is read. */
    private boolean isForeign(Occurrence.Heard heard) {
        return heard.source() == Source.PANEL;
    }

    private void requireNothingHappened() {
        List<String> acts = acts();
        if (!acts.isEmpty()) {
            throw new DisturbedException(
                    "the device did " + String.join(", ", acts) + " before the next event was sent");
        }
    }
}
