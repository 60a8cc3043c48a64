package org.evoloop.function.visit;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Values;
import org.evoloop.function.Visit;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.SetClock;

/** Stands in for the converter of a visit and records what the visit reports to it. */
public final class VisitLog implements VisitHost {
    private static final int PATIENCE_SECONDS = 20;

    public final SetClock clock = new SetClock();
    public final BlockingQueue<String> events = new LinkedBlockingQueue<>();
    public final List<String> notices = new CopyOnWriteArrayList<>();
    public final BlockingQueue<Throwable> failures = new LinkedBlockingQueue<>();
    public final Set<String> accepted = new HashSet<>();

    /** Events with which the function must not end. */
    public final Set<String> unexpected = new HashSet<>();

    private final boolean threads;
    private long visits;

    public VisitLog(boolean threads) {
        this.threads = threads;
    }

    public HostedVisit visit() {
        return new HostedVisit(new State("Move"), Visit.Beginning.NEW, ++visits, Values.NONE, this);
    }

    @Override
    public State device() {
        return new State("Off");
    }

    @Override
    public SetClock clock() {
        return clock;
    }

    @Override
    public boolean threads() {
        return threads;
    }

    @Override
    public boolean accepts(Visit visit, Event event) {
        return accepted.contains(event.name());
    }

    @Override
    public void ask(Visit visit, Event event, Values values, Consumer<EventOutcome> then) {
        throw new UnsupportedOperationException("nobody is asked here");
    }

    @Override
    public void send(Visit visit, Event event, Values values) {
        throw new AssertionError(visit + " asks for " + event);
    }

    @Override
    public void requireKnown(Event event) {
        // Every event is known here.
    }

    @Override
    public String unexpected(Visit finishing, Event event) {
        return unexpected.contains(event.name()) ? finishing.state() + " does not know " + event : "";
    }

    @Override
    public void requireNotDeferred(Visit visit, Event event) {}

    @Override
    public void raise(Visit visit, Event event, Values values) throws InterruptedException {
        events.put("raised " + event);
    }

    @Override
    public void finish(Visit visit, Event event, Values values) {
        events.add("finished " + event);
    }

    @Override
    public void notice(String line) {
        notices.add(line);
    }

    @Override
    public void failed(Visit visit, Throwable cause) {
        failures.add(cause);
    }

    public static <T> T take(BlockingQueue<T> queue) throws InterruptedException {
        T taken = queue.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
        if (taken == null) {
            throw new AssertionError("nothing came");
        }
        return taken;
    }
}
