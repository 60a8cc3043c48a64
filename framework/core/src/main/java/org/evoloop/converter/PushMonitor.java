package org.evoloop.converter;

import java.util.Collection;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.loop.Intake.Admission;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A monitor whose events come from other threads: a console, a driver's callback, a web server.
 *
 * <p>Threading: {@link #push} and {@link #press} may be called from any thread and do not wait for events to be
 * converted. Once the loop has been built, they pass events to it directly, since the monitor's own thread would have
 * to be woken first; events pushed by one thread stay in order.
 *
 * @since 0.1
 */
public class PushMonitor extends EventMonitor {
    /** All of the converter logs under one name. */
    private static final Logger LOG = LoggerFactory.getLogger("org.evoloop.converter.SystemEventConverter");

    private static final int MOST_KEPT = 1024;
    private static final long LOOK_NANOS = 100_000;

    private final Set<String> ofController = ConcurrentHashMap.newKeySet();
    private final Set<String> ofDevice = ConcurrentHashMap.newKeySet();
    private final BlockingQueue<Occurrence> pushed = new LinkedBlockingQueue<>();

    /** How many occurrences the monitor's own thread still has to report; none may overtake them. */
    private final AtomicInteger behind = new AtomicInteger();

    private boolean handingOver;
    private boolean losing;

    /** A monitor named after its class. */
    public PushMonitor() {}

    /** @param name its name in the console, unique within a converter */
    public PushMonitor(String name) {
        super(name);
    }

    /**
     * A control of the controller was operated.
     *
     * @throws IllegalArgumentException if neither model knows the event, and then the message lists the most similar
     *     names, if it has no name, or if only the device can raise it
     * @throws IllegalStateException if, and only if, the event is lost: the converter is not running, has no room for it
     *     in its queue or cannot write its journal, or this monitor is not part of one
     */
    public final void press(String event) {
        press(event, Values.NONE);
    }

    /** As {@link #press(String)}, for an event with {@code values}. */
    public final void press(String event, Values values) {
        Occurrence pressed = pressed(event, values);
        Admission admission = reported(pressed);
        String so = ", so " + pressed.label() + (isFull(admission) ? " is dropped" : " is refused");
        String why = admission == null ? "" : whyNotTaken(admission, so);
        if (!why.isEmpty()) {
            throw new IllegalStateException(why);
        }
    }

    /** As {@link #submit(String, Values)}, for an event without values. */
    public final CompletableFuture<EventOutcome> submit(String event) {
        return submit(event, Values.NONE);
    }

    /**
     * As {@link #press(String, Values)}, for somebody who wants to know the outcome.
     *
     * @return completes when the record has moved, or it is certain that the event has no effect, also when the converter
     *     is closed; on a thread of the JDK's common pool or, in a converter without threads, by the step that ends the
     *     event
     * @throws IllegalArgumentException if neither model knows the event, if it has no name, or if only the device can
     *     raise it
     * @throws IllegalStateException if this monitor is not part of a converter that was built
     * @throws UnsupportedOperationException if the events of this monitor are decided elsewhere, as in a fleet
     */
    public final CompletableFuture<EventOutcome> submit(String event, Values values) {
        Occurrence pressed = pressed(event, values);
        Submission submission = new Submission();
        endings(pressed).await(pressed, submission::ended);
        Admission admission = reported(pressed);
        if (admission == null || admission == Admission.TAKEN) {
            submission.taken();
        } else {
            String why = whyNotTaken(admission, "");
            submission.notTaken(isFull(admission) ? new EventOutcome.Dropped(why) : new EventOutcome.Refused(why));
        }
        return submission.outcome;
    }

    private static boolean isFull(@Nullable Admission admission) {
        return admission == Admission.DROPPED || admission == Admission.FIRST_DROPPED;
    }

    /** Refuses an event that can never be taken. */
    private Occurrence pressed(String event, Values values) {
        if (Objects.requireNonNull(event, "the name of an event is null").isBlank()) {
            throw new IllegalArgumentException(
                    "the event that is pressed has no name; press one of the models' events");
        }
        Occurrence pressed = fromController(event, values);
        requirePressable(pressed);
        return pressed;
    }

    /** Null if it will be reported later. */
    private @Nullable Admission reported(Occurrence pressed) {
        Admission atOnce = answerAtOnce(pressed);
        Admission admission = atOnce == null ? pass(pressed) : atOnce;
        if (admission == null && hasLeft()) {
            IllegalStateException notPart = notPart(pressed);
            endings(pressed).refused(pressed, String.valueOf(notPart.getMessage()));
            throw notPart;
        }
        return admission;
    }

    /** Declares events that a controller raises through this monitor; before it is part of a converter. */
    protected final void controllerRaises(Collection<String> events) {
        ofController.addAll(events);
    }

    /** Declares events that the device takes by itself, as {@link #spontaneousEvents}; before it is part of a converter. */
    protected final void deviceRaises(Collection<String> events) {
        ofDevice.addAll(events);
    }

    /** Those that were declared. */
    @Override
    protected Set<String> controllerEvents() {
        return Set.copyOf(ofController);
    }

    /** Those that were declared. */
    @Override
    protected Set<String> spontaneousEvents() {
        return Set.copyOf(ofDevice);
    }

    /**
     * Reports an occurrence. While the converter is stopped, a controller's event is refused and counted by {@code
     * status}; what the device did by itself moves the record all the same, and waits for the start. Until the converter
     * is built, the last {@value #MOST_KEPT} are kept, and the loss of earlier ones is logged; after this monitor has
     * been removed from a converter, none is kept.
     */
    protected final void push(Occurrence occurrence) {
        pass(occurrence);
    }

    /** Null if the monitor's thread will report it. */
    private @Nullable Admission pass(Occurrence occurrence) {
        Objects.requireNonNull(occurrence, "the occurrence is null");
        while (behind.get() > 0 && isServed()) {
            // Occurrences pushed before the converter was built come first; the monitor's thread is reporting them.
            LockSupport.parkNanos(this, LOOK_NANOS);
        }
        if (!hasThread()) {
            reportKept();
        }
        Admission admission = behind.get() > 0 ? null : report(occurrence);
        if (admission == null) {
            keep(occurrence);
        }
        return admission;
    }

    private void keep(Occurrence occurrence) {
        synchronized (pushed) {
            if (hasLeft()) {
                refuseKept();
                return;
            }
            if (pushed.size() >= MOST_KEPT && pushed.poll() != null) {
                behind.decrementAndGet();
                if (!losing) {
                    losing = true;
                    LOG.warn(
                            "{} reports more than {} events before its converter is built; the oldest are lost",
                            name(),
                            MOST_KEPT);
                }
            }
            behind.incrementAndGet();
            pushed.add(occurrence);
        }
    }

    /** Reports what was pushed before a converter without threads was built, so that nothing overtakes it. */
    private void reportKept() {
        synchronized (pushed) {
            while (isBuilt() && !pushed.isEmpty()) {
                report(evaluated(pushed.remove()));
                behind.decrementAndGet();
            }
        }
    }

    /** This monitor's part in a converter is over. */
    private void refuseKept() {
        for (Occurrence left = pushed.poll(); left != null; left = pushed.poll()) {
            behind.decrementAndGet();
            endings(left).refused(left, String.valueOf(notPart(left).getMessage()));
        }
    }

    @Override
    protected final @Nullable Occurrence getEvent() throws InterruptedException {
        if (handingOver) {
            // A further call means that the last occurrence has been reported.
            handingOver = false;
            behind.decrementAndGet();
        }
        if (!hasThread()) {
            reportKept();
            return null;
        }
        try {
            Occurrence next = pushed.take();
            handingOver = true;
            return evaluated(next);
        } catch (InterruptedException end) {
            refuseKept();
            throw end;
        }
    }
}
