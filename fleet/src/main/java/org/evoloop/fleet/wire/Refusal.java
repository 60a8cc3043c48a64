package org.evoloop.fleet.wire;

/**
 * Why a record cannot be taken. It goes to the dead letters and is in nobody's way.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Refusal extends RuntimeException {
    private final Reason reason;

    /** The kinds of reasons; their names are what a dead letter says. */
    public enum Reason {
        /** The record is not what its topic is for. */
        MALFORMED,
        /** It is of a schema that this program does not know. */
        NEWER_SCHEMA,
        /** No device of this id was registered. */
        UNKNOWN_DEVICE,
        /** A device of this id has other models; a rollout changes them. */
        REGISTERED_ALREADY,
        /** No models of this version were published. */
        UNKNOWN_MODEL,
        /** It says that it happened in the future, or so long ago that the clock must have been wrong. */
        CLOCK,
        /** The models cannot be used. */
        UNUSABLE_MODEL,
        /** What is kept of the device does not fit its models. */
        UNUSABLE_STATE,
        /** The converter itself has failed; that is a defect of this program. */
        DEFECT
    }

    /** @param detail for people */
    public Refusal(Reason reason, String detail) {
        super(detail, null, false, false);
        this.reason = reason;
    }

    /** What kind of reason. */
    public Reason reason() {
        return reason;
    }

    /** What is wrong, for people. */
    public String detail() {
        return String.valueOf(getMessage());
    }
}
