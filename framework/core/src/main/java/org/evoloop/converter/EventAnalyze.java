package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.util.function.Predicate;
import org.evoloop.converter.attachment.DecisionHost;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Analyze;
import org.jspecify.annotations.Nullable;

/**
 * Decides what an occurrence means in the current states: not acceptable, an existing function, or a new function. A
 * converter has one by default. Extend it to observe decisions, to refine them, or to refuse events by a rule of your
 * own: a child lock, say, refuses the controller's events at night.
 *
 * <pre>{@code
 * protected Analysis analyze(Occurrence occurrence) {
 *     return isNight() && occurrence.source().isButton()
 *             ? refuse(occurrence, "child lock")
 *             : super.analyze(occurrence);
 * }
 * }</pre>
 *
 * <p>For one rule, {@link #refuseWhen} does the same without a class.
 *
 * <p>A refined decision takes transitions that the models draw, and its steps and its transition lead to the states that
 * it names; with any other, the event fails.
 *
 * <p>A fact, on which the device has already acted, can be refused too; the record of the device follows it all the
 * same.
 *
 * @since 0.1
 */
public class EventAnalyze extends Analyze<Occurrence, Analysis> {
    static {
        Friends.ANALYZE.give(analyze -> ((EventAnalyze) analyze)::attach);
    }

    private volatile @Nullable DecisionHost host;

    /** A component named after its class. */
    public EventAnalyze() {}

    /** @param name its name in the console, unique within a converter */
    public EventAnalyze(String name) {
        super(name);
    }

    /**
     * A component that refuses what {@code when} is true for, such as all buttons at night.
     *
     * @param reason for people; the history shows it
     */
    public static EventAnalyze refuseWhen(Predicate<Occurrence> when, String reason) {
        requireNonNull(when, "when something is refused is null");
        requireNonNull(reason, "the reason why something is refused is null");
        return new EventAnalyze() {
            @Override
            protected @Nullable Analysis analyze(Occurrence occurrence) {
                return when.test(occurrence) ? refuse(occurrence, reason) : super.analyze(occurrence);
            }
        };
    }

    private void attach(DecisionHost joined) {
        host = joined;
    }

    /**
     * The analysis; null for an occurrence that is no longer in the loop, since this component did not return in time. An
     * override may return null to dismiss an occurrence, which {@link #refuse} does with a reason, except for those that
     * cannot be refused.
     */
    @Override
    protected @Nullable Analysis analyze(Occurrence occurrence) {
        return decided(occurrence);
    }

    private @Nullable Analysis decided(Occurrence occurrence) {
        DecisionHost attached = host;
        Decision decision = attached == null ? null : attached.decide(occurrence);
        return decision == null ? null : new Analysis(occurrence, decision);
    }

    /**
     * The states of device and evolved system.
     *
     * @throws IllegalStateException if this is not part of a converter
     */
    protected final Configuration configuration() {
        DecisionHost attached = host;
        if (attached == null) {
            throw new IllegalStateException(name() + " is not part of a converter");
        }
        return attached.configuration();
    }

    /**
     * An analysis that dismisses {@code occurrence}; the history shows the reason. What keeps the record right cannot be
     * refused, and is analyzed as usual: a question to a device whose state is in doubt, what has to be sent after
     * other models have taken over, and the way back, or the other way, after a step of the event's plan has failed.
     */
    protected final Analysis refuse(Occurrence occurrence, String reason) {
        Analysis usual = unlessDismissed(occurrence);
        return usual == null ? new Analysis(occurrence, new Decision.Refused(configuration(), reason)) : usual;
    }

    /** The usual analysis of what keeps the record right; null for any other occurrence. */
    @Override
    protected final @Nullable Analysis unlessDismissed(Occurrence occurrence) {
        DecisionHost attached = host;
        return attached != null && attached.keepsRecord(occurrence) ? decided(occurrence) : null;
    }
}
