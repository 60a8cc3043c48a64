package org.evoloop.roomba.oi;

import java.util.Optional;

/** What the charger does (specification, packet 21). */
public enum ChargingState {
    NOT_CHARGING(0),
    RECONDITIONING(1),
    FULL_CHARGING(2),
    TRICKLE_CHARGING(3),
    WAITING(4),
    FAULT(5);

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
        for (ChargingState state : values()) {
            if (state.code == code) {
                return Optional.of(state);
            }
        }
        return Optional.empty();
    }
}
