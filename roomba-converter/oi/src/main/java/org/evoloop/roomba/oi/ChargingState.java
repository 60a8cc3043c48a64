package org.evoloop.roomba.oi;

import java.util.Optional;

/**
 * What the charger does (specification, packet 21).
 *
 * @since 0.1
 */
public enum ChargingState {
    /** No current flows into the battery. */
    NOT_CHARGING(0),
    /** Charges a battery that was empty for a long time, which takes hours. */
    RECONDITIONING(1),
    /** Charges as fast as it can. */
    FULL_CHARGING(2),
    /** Keeps a full battery full. */
    TRICKLE_CHARGING(3),
    /** Pauses, for example until the battery has cooled. */
    WAITING(4),
    /** Cannot charge. */
    FAULT(5);

    /** By code. Read in each frame; {@link #values()} makes a copy at each call. */
    private static final ChargingState[] BY_CODE = values();

    private final int code;

    ChargingState(int code) {
        this.code = code;
    }

    /** The value of {@link Packet#CHARGING_STATE}. */
    public int code() {
        return code;
    }

    /** The state with this code; empty for codes that the specification does not name. */
    public static Optional<ChargingState> of(int code) {
        return code >= 0 && code < BY_CODE.length ? Optional.of(BY_CODE[code]) : Optional.empty();
    }
}
