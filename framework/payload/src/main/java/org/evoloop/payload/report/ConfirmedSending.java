package org.evoloop.payload.report;

import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.Set;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.Step;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.report.Confirmations.Sent;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Sends commands to a device, and waits until it reports the state to which each leads. Where it does not, it is asked, and
 * its {@link Aftermath} says which reports count.
 *
 * <p>Lifecycle: configure it before the connection is opened.
 *
 * <p>Threading: for one thread at a time.
 *
 * @since 0.1
 */
public final class ConfirmedSending {
    private final ReportingDevice device;
    private final Confirmations confirmations;
    private final Confirmations answers;
    private final Set<Aftermath> aftermaths = new LinkedHashSet<>();
    private @Nullable Duration limit;

    /** The state to which the last step leads, if it was not confirmed; else empty. */
    private volatile String awaited = "";

    /** Until when it may still have its effect. */
    private volatile long untilNanos;

    /** To this device. */
    public ConfirmedSending(ReportingDevice device) {
        this.device = device;
        this.confirmations = new Confirmations(device);
        this.answers = new Confirmations(device);
    }

    /**
     * Declares that a source reports the state to which a step leads.
     *
     * @param within the time limit from sending to the report
     */
    public void confirmedBy(String source, Meanings states, Duration within) {
        aftermaths.add(device.aftermath(source));
        confirmations.subscribe(source, states);
        limit = Clock.requireDelay(within);
    }

    /** Declares that a source reports the answer to {@link #ask}. */
    public void answeredBy(String source, Meanings states) {
        aftermaths.add(device.aftermath(source));
        answers.subscribe(source, states);
    }

    /**
     * Requires that the device can be reached.
     *
     * @param what would be sent, for the message
     * @throws IllegalStateException if it cannot
     */
    public void requireUp(String what) {
        if (!device.isUp()) {
            throw new IllegalStateException(device.describe() + "; so " + what + " was not sent");
        }
    }

    /** Whether the device reports its state. */
    public boolean isConfirmed() {
        return limit != null;
    }

    /** Whether the device reports what becomes of this step; it reports nothing if the state stays as it is. */
    public boolean isConfirmed(Step step) {
        return isConfirmed() && !step.source().equals(step.target());
    }

    /**
     * Sends a step.
     *
     * @param what is sent, for messages
     * @param tookEffect run when it is confirmed, before anybody else hears of the report
     * @throws UnknownEffectException if it is not confirmed within the limit, or the device is lost meanwhile
     * @throws IllegalStateException if it was {@linkplain Pending#refuse refused}, or nothing confirms it
     * @throws Exception as {@code sending}
     */
    public void send(Step step, String what, Transmission sending, Runnable tookEffect) throws Exception {
        Duration within = limit;
        if (within == null) {
            throw new IllegalStateException("nothing confirms " + what);
        }
        awaited = step.target().name();
        aftermaths.forEach(each -> each.sends(step.source().name(), awaited));
        try {
            confirmations.await(new Sent(what, sending), awaited, within, () -> {
                settle();
                tookEffect.run();
            });
        } catch (UnknownEffectException | InterruptedException unknown) {
            isUnknown(within);
            throw unknown;
        } catch (Exception unsent) {
            settle();
            throw unsent;
        }
    }

    /** It is unknown in which state the device is: until it can be known, only what confirms the last step counts. */
    public void isUnknown(Duration within) {
        untilNanos = device.clock().nanoTime() + within.toNanos();
        aftermaths.forEach(each -> each.isUnknown(awaited, device.clock(), within));
    }

    /**
     * Asks for the state. After a step that was not confirmed, another state than the one to which it leads is the answer
     * when it is too late for its effect.
     *
     * @param what is asked, for messages
     * @param within the time limit for the answer
     * @throws UnknownEffectException if there is none within the limit, or the device is lost meanwhile
     * @throws Exception as {@code asking}
     */
    public String ask(String what, Transmission asking, Duration within) throws Exception {
        long left =
                awaited.isEmpty() ? 0 : Math.max(0, untilNanos - device.clock().nanoTime());
        return answers.ask(new Sent(what, asking), awaited, Duration.ofNanos(left), within, this::settle);
    }

    private void settle() {
        awaited = "";
        aftermaths.forEach(Aftermath::settled);
    }
}
