package org.evoloop.fleet.wire;

/**
 * A record cannot be processed. It goes to the dead letters and blocks nothing.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Refusal extends RuntimeException {
    private final Reason reason;

    /** The reasons; dead letters contain their names. */
    public enum Reason {
        /** The record has the wrong form for its topic. */
        MALFORMED,
        /** It has a newer schema than this program supports. */
        NEWER_SCHEMA,
        /** What follows from it is larger than a record can be. */
        TOO_LARGE,
        /** No device of this id was registered. */
        UNKNOWN_DEVICE,
        /** A device of this id has other models; a rollout changes them. */
        REGISTERED_ALREADY,
        /** No models of this version were published. */
        UNKNOWN_MODEL,
        /** Its time is in the future, or so long ago that the clock must have been wrong. */
        CLOCK,
        /** The models cannot be used. */
        UNUSABLE_MODEL,
        /** The stored state of the device does not fit its models. */
        UNUSABLE_STATE,
        /** The converter itself failed; this is a defect of this program. */
        DEFECT
    }

    /** @param detail the problem, for people */
    public Refusal(Reason reason, String detail) {
        super(detail, null, false, false);
        this.reason = reason;
    }

    /** The reason. */
    public Reason reason() {
        return reason;
    }

    /** The problem, for people. */
    public String detail() {
        return String.valueOf(getMessage());
    }
}
