package org.evoloop.roomba.session.inference;

import java.util.OptionalInt;
import org.evoloop.roomba.oi.OiMode;

/**
 * Finds out what a robot adds to the OI mode that it reports: 1 on some 600 models with Wi-Fi, else 0. The command
 * Start leads to Passive mode from everywhere (specification, "Start"), so a robot that goes on showing the mode above
 * it, however often Start is sent, reports its mode one too high.
 *
 * <p>Time is counted in frames of the stream, one every 15 ms.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class ModeOffset {
    /**
     * So long Start must have been sent in vain: 0.5 s. A robot that is in Safe mode obeys sooner, if it hears at all.
     */
    static final int SURE_FRAMES = 33;

    /** So often Start is sent meanwhile: every 0.12 s. */
    static final int ASK_FRAMES = 8;

    /** What a robot in Full mode shows if it adds 1. */
    private static final int HIGHEST = OiMode.FULL.code() + 1;

    private OptionalInt offset;
    private int frames;
    private int impossible;

    /** @param given what is known of the robot, empty if it is to be found out */
    public ModeOffset(OptionalInt given) {
        this.offset = given;
    }

    /** Whether the offset is known, so that modes can be read. */
    public boolean isKnown() {
        return offset.isPresent();
    }

    /** What the robot adds; 0 as long as that is not known. */
    public int value() {
        return offset.orElse(0);
    }

    /**
     * Takes the mode of the next frame, as the robot reports it after it was sent a Start.
     *
     * @return whether Start must be sent again to find out more
     */
    public boolean update(int reported) {
        if (isKnown()) {
            correct(reported);
            return false;
        }
        if (reported <= OiMode.PASSIVE.code()) {
            offset = OptionalInt.of(0);
        } else if (reported <= HIGHEST && ++frames >= SURE_FRAMES) {
            offset = OptionalInt.of(reported == OiMode.FULL.code() ? 0 : 1);
        }
        return !isKnown() && frames % ASK_FRAMES == 1;
    }

    /** A mode that the offset rules out, twice in a row, proves it wrong. */
    private void correct(int reported) {
        boolean ruledOut = reported == (value() == 0 ? HIGHEST : OiMode.OFF.code());
        impossible = ruledOut ? impossible + 1 : 0;
        if (impossible == 2) {
            offset = OptionalInt.of(1 - value());
            impossible = 0;
        }
    }
}
