package org.evoloop.roomba.session;

import java.time.Duration;
import java.util.OptionalInt;

/**
 * The options of a session. The defaults suit every robot that follows the specification.
 *
 * <p>Distance and angle (packets 19 and 20), which old firmware reports wrong, and stasis (58), whose values differ
 * between models, are not used at all.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class SessionOptions {
    private final boolean mayWait;
    private final OptionalInt modeOffset;
    private final Duration silenceLimit;

    private SessionOptions(boolean mayWait, OptionalInt modeOffset, Duration silenceLimit) {
        modeOffset.ifPresent(offset -> {
            if (offset != 0 && offset != 1) {
                throw new IllegalArgumentException("modeOffset is " + offset + ", allowed is 0 or 1");
            }
        });
        if (silenceLimit.compareTo(Duration.ofMillis(100)) < 0) {
            throw new IllegalArgumentException("silenceLimit is " + silenceLimit + ", allowed is at least 100 ms");
        }
        this.mayWait = mayWait;
        this.modeOffset = modeOffset;
        this.silenceLimit = silenceLimit;
    }

    /** The defaults: a robot counts as unreachable after 1.7 s of silence, which is noticed within 2 s. */
    public static SessionOptions defaults() {
        return new SessionOptions(true, OptionalInt.empty(), Duration.ofMillis(1_700));
    }

    /** A copy for a caller that controls the time. */
    public SessionOptions withoutWaiting() {
        return new SessionOptions(false, modeOffset, silenceLimit);
    }

    /** A copy for a robot with a known mode offset. */
    public SessionOptions withModeOffset(int offset) {
        return new SessionOptions(mayWait, OptionalInt.of(offset), silenceLimit);
    }

    /** A copy with another limit for silence. */
    public SessionOptions withSilenceLimit(Duration limit) {
        return new SessionOptions(mayWait, modeOffset, limit);
    }

    /** False if the caller controls the time: then nothing waits, and no thread is created. */
    public boolean mayWait() {
        return mayWait;
    }

    /**
     * The offset of the OI mode that the robot reports: 1 for some 600 models with Wi-Fi, else 0; empty if the session
     * is to detect it, see {@link org.evoloop.roomba.session.inference.ModeOffset}.
     */
    public OptionalInt modeOffset() {
        return modeOffset;
    }

    /** The time without a frame after which the robot counts as unreachable, in the clock's time. */
    public Duration silenceLimit() {
        return silenceLimit;
    }
}
