package org.evoloop.check;

import java.util.Locale;

/**
 * The rules; the identifier is the name in lower case with hyphens, such as {@code dead-transition}. Findings are in
 * this order.
 *
 * @since 0.1
 */
public enum Rule {
    /** An event of the device is missing in the new model (paper, Definition IV.1, Condition 1). */
    CONDITION_1(Severity.ERROR),
    /** A state of the device is missing in the new model (paper, Definition IV.1, Condition 2). */
    CONDITION_2(Severity.ERROR),
    /** The two machines start in different states. */
    INITIAL_DIFFERS(Severity.ERROR),
    /** A device state that the original model lacks, or that is given to a state that the device has itself. */
    DEVICE_STATE(Severity.ERROR),
    /** Two transitions of a state are enabled at the same time. */
    NONDETERMINISM(Severity.ERROR),
    /** No sequence of events leads to a state. */
    UNREACHABLE_STATE(Severity.WARNING),
    /** A transition can never be taken, since another one always takes precedence. */
    DEAD_TRANSITION(Severity.WARNING),
    /** A state that is entered and never left. */
    TRAP_STATE(Severity.WARNING),
    /** An event of the device that cannot be sent and is not declared spontaneous. */
    UNSENDABLE_EVENT(Severity.ERROR),
    /** A new state has no function. */
    NO_FUNCTION(Severity.ERROR),
    /** A decision needs a path through the device's states that does not exist or cannot be sent. */
    NO_PATH(Severity.ERROR),
    /** As {@link #NO_PATH}, but only after the device has done by itself what could have been sent to it. */
    HAZARD(Severity.NOTE),
    /** What a function is declared to send cannot be sent where the function runs, or leaves the device state. */
    DECLARED_SEND(Severity.ERROR),
    /** The converter sends events in a circle without an end, and nothing else can happen between them. */
    RESTLESS(Severity.ERROR),
    /** Something that the device does is no longer available anywhere. */
    DEGRADATION(Severity.WARNING),
    /** A time trigger that never comes. */
    TIMER_CANNOT_FIRE(Severity.WARNING),
    /** The new model waits for an event that is never raised. */
    UNRAISED_EVENT(Severity.WARNING),
    /** An unbound guard of the new model. */
    UNBOUND_GUARD(Severity.ERROR),
    /** An unbound effect of the new model that the device does not run itself. */
    UNBOUND_EFFECT(Severity.ERROR),
    /** Different guards of one trigger may hold at once; the one drawn first is taken. */
    GUARD_OVERLAP(Severity.NOTE),
    /** An event of the device that does nothing in a new state, though the device would act on it. */
    SWALLOWED_EVENT(Severity.NOTE),
    /** The device can leave the device state of a new state by itself, where the new model draws nothing for it. */
    DEVICE_LEAVES(Severity.NOTE),
    /** A timer of a new state leads elsewhere than an event that the device may raise there by itself. */
    TIMER_OR_DEVICE(Severity.NOTE),
    /** A path leads through a state of the device in which the device does something by itself. */
    PASSED_EFFECT(Severity.NOTE),
    /** A step of a plan may fail where the configured recovery, a way back or another path, does not exist. */
    NO_FALLBACK(Severity.WARNING),
    /** Something must happen before time can pass, but nothing that can happen lets it pass. */
    TIME_DEADLOCK(Severity.ERROR),
    /** Two timers are due in one instant. */
    TIMER_RACE(Severity.WARNING),
    /** A timer is due while a step of its own visit is still being sent. */
    STEP_OUTLIVES_VISIT(Severity.WARNING),
    /** A property of the pair does not hold. */
    PROPERTY(Severity.ERROR),
    /** Whether a property holds depends on what a function sends to the device. */
    UNKNOWN_PROPERTY(Severity.WARNING);

    private final Severity severity;

    Rule(Severity severity) {
        this.severity = severity;
    }

    /** The severity of a finding. */
    public enum Severity {
        /** A converter of this pair would be refused, or would fail. */
        ERROR,
        /** It would run, but probably not as intended. */
        WARNING,
        /** For information. */
        NOTE
    }

    /** The severity of a violation of this rule. */
    public Severity severity() {
        return severity;
    }

    /** The identifier that users read and write: {@code dead-transition}. */
    public String id() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
