package org.evoloop.roomba.oi;

import java.util.Optional;

/**
 * The four operating modes (specification, "Open Interface Modes"), ordered by how much control they give.
 *
 * @since 0.1
 */
public enum OiMode {
    /** The robot only listens for {@link Command.Start} and {@link Command.Reset}. */
    OFF(0),
    /** Sensors can be read; the robot cleans and charges by itself and obeys its own buttons. */
    PASSIVE(1),
    /** Full control, but the robot drops to {@link #PASSIVE} at a cliff, a wheel drop or a live charger. */
    SAFE(2),
    /** Full control without any protection. */
    FULL(3);

    /** By code. Read several times a frame; {@link #values()} makes a copy at each call. */
    private static final OiMode[] BY_CODE = values();

    private final int code;

    OiMode(int code) {
        this.code = code;
    }

    /** The value of {@link Packet#OI_MODE}. */
    public int code() {
        return code;
    }

    /** The mode with this code; empty for others, since some robots report codes that the specification lacks. */
    public static Optional<OiMode> of(int code) {
        return code >= 0 && code < BY_CODE.length ? Optional.of(BY_CODE[code]) : Optional.empty();
    }
}
