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
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.learn.Heard.Reply;
import org.evoloop.loop.Failure;
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
    /** How often it may stay away for as long as its way home may take. */
    private static final int MOST_LATE = 2;

    private final SystemEventConverter converter;
    private final PushMonitor buttons;
    private final LearnRules rules;
    private final WayHome way;
    private final Duration settle;
    private final Clock clock;
    private final BlockingQueue<News> news = new LinkedBlockingQueue<>();
    /** What the device did by itself, and nobody has asked for yet. */
    private final List<String> done = new ArrayList<>();

    /** What a person pressed, at the device or at its controller; empty if nothing. */
    private String pressed = "";

    private String shown = "";
    /** The state that the device has told last. */
    private String told = "";
    /** Since when the device is as it is. */
    private long since;

    /** Whether that is known by what was sent or heard, so that the next look need not guess it. */
    private boolean dated;

    private boolean looking;
    /** When the last look ended. */
    private long looked;

    private int sent;

    /** Events that were sent from here, and of whose end was not heard yet. */
    private final List<String> own = new ArrayList<>();

    /** Whether it is unknown if the last of them had its effect. */
    private boolean unknown;

    /**
     * Something has ended.
     *
     * @param unknown whether it failed, and it is unknown if it had its effect
     */
    private record News(HistoryEntry entry, long nanos, boolean unknown) {}

    /**
     * @param converter a converter that runs
     * @param buttons its monitor through which events are pressed
     * @param rules what a reset must not send either
     * @param way how it is brought to where every word begins
     * @param settle how long nothing must happen after an event
     */
    public ConverterDevice(
            SystemEventConverter converter, PushMonitor buttons, LearnRules rules, WayHome way, Duration settle) {
        this.converter = requireNonNull(converter, "the converter is null");
        this.buttons = requireNonNull(buttons, "the monitor is null");
        this.rules = rules;
        this.way = way;
        this.settle = settle;
        this.clock = converter.clock();
        this.looked = clock.nanoTime();
        converter.addListener(new ConverterListener() {
            private boolean unknown;

            @Override
            public void failed(Failure<Occurrence> failure) {
                unknown = failure.cause() instanceof UnknownEffectException;
            }

            @Override
            public void ended(HistoryEntry entry) {
                news.add(new News(entry, clock.nanoTime(), unknown));
                unknown = false;
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
        int late = 0;
        for (int round = 0; round < MOST_ROUNDS && late < MOST_LATE; round++) {
            if (isHome() || (way.home().isEmpty() && round > 0)) {
                return Heard.accepted(shown);
            }
            for (String event : way.from(shown)) {
                if (!isHome() && !rules.forbid(event, shown)) {
                    send(event);
                    quiet();
                }
            }
            if (!way.within().isZero() && !hasMoved(way.within())) {
                late++;
            }
        }
        throw new LostException("the device could not be brought to " + way.home() + " by " + way + "; it is in "
                + shown + "; correct learn.reset, or bring it there by hand");
    }

    private boolean isHome() {
        return !way.home().isEmpty() && shown.equals(way.home());
    }

    /** Listens until the device is at home, or has come to any other state, from which the reset goes on. */
    private boolean hasMoved(Duration within) throws InterruptedException {
        String before = shown;
        long begin = clock.nanoTime();
        while (!isHome() && shown.equals(before) && clock.nanoTime() - begin < within.toNanos()) {
            quiet();
        }
        return isHome() || !shown.equals(before);
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
        if (outcome instanceof EventOutcome.Failed && !unknown) {
            // The device stays as it is, and its timers run on.
            return Reply.REFUSED;
        }
        since(clock.nanoTime());
        if (outcome.isHandled()) {
            return Reply.ACCEPTED;
        }
        if (outcome instanceof EventOutcome.Failed) {
            return Reply.UNANSWERED;
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
        own.add(event);
        CompletableFuture<EventOutcome> outcome = buttons.submit(event);
        // What ended before it is heard first, so that nothing of it is taken for a person's press later.
        while (!outcome.isDone() || own.contains(event)) {
            if (outcome.isDone() && outcome.join() instanceof EventOutcome.Refused) {
                hear();
                own.remove(event);
                break;
            }
            if (clock.nanoTime() - begin > PATIENCE.toNanos()) {
                throw new LostException("the device does not take " + event + " within " + PATIENCE.toSeconds()
                        + " s; switch it off and on");
            }
            clock.sleep(TICK);
            hear();
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
        hear();
        looking = true;
        try {
            submit(LookExecute.LOOK);
            submit(LookExecute.SEEN);
        } finally {
            looking = false;
        }
        long now = clock.nanoTime();
        String state = converter.status().states().original().name();
        if (!state.equals(shown)) {
            if (!dated) {
                // It has changed between two looks; nobody knows when.
                since = looked + (now - looked) / 2;
            }
            shown = state;
        }
        told = state;
        dated = false;
        looked = now;
    }

    private void since(long nanos) {
        since = nanos;
        dated = true;
    }

    /** What the device did by itself since this was called last. */
    private List<String> acts() {
        hear();
        String person = pressed;
        pressed = "";
        if (!person.isEmpty()) {
            done.clear();
            throw new DisturbedException("somebody pressed " + person);
        }
        List<String> acts = List.copyOf(done);
        done.clear();
        return acts;
    }

    /** Takes in what has ended. */
    private void hear() {
        for (News next = news.poll(); next != null; next = news.poll()) {
            if (next.entry().occurrence() instanceof Occurrence.Found found) {
                told(found);
            }
            if (!(next.entry().occurrence() instanceof Occurrence.Heard heard)) {
                continue;
            }
            String event = heard.event().name();
            if (heard.source() == Source.DEVICE) {
                done.add(event);
                since(next.nanos());
            } else if (heard.source() == Source.CONTROLLER && own.remove(event)) {
                unknown = next.unknown();
            } else {
                pressed = event;
            }
        }
    }

    private void told(Occurrence.Found found) {
        String state = found.state().name();
        if (!looking && !state.equals(told)) {
            since(found.observedNanos());
        }
        told = state;
    }

    private void requireNothingHappened() {
        List<String> acts = acts();
        if (!acts.isEmpty()) {
            throw new DisturbedException(
                    "the device did " + String.join(", ", acts) + " before the next event was sent");
        }
    }
}
