package org.evoloop.roomba.session.inference;

import java.util.OptionalInt;
import org.evoloop.roomba.oi.OiMode;

/**
 * Detects the offset of the OI mode that a robot reports: 1 on some 600 models with Wi-Fi, else 0. The command Start
 * leads to Passive mode from every mode (specification, "Start"), so a robot that keeps showing the next higher mode
 * although Start is sent repeatedly reports its mode one too high.
 *
 * <p>Time is counted in frames of the stream, one every 15 ms.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class ModeOffset {
    /**
     * How long Start must have had no effect: 0.5 s. A robot in Safe mode that receives it obeys sooner.
     */
    static final int SURE_FRAMES = 33;

    /** The interval at which Start is sent in the meantime: 0.12 s. */
    static final int ASK_FRAMES = 8;

    /** The mode reported by a robot in Full mode with offset 1. */
    private static final int HIGHEST = OiMode.FULL.code() + 1;

    private OptionalInt offset;
    private int frames;
    private int impossible;

    /** @param given the robot's offset; empty if it is to be detected */
    public ModeOffset(OptionalInt given) {
        this.offset = given;
    }

    /** Whether the offset is known, so that modes can be read. */
    public boolean isKnown() {
        return offset.isPresent();
    }

    /** The offset; 0 while it is unknown. */
    public int value() {
        return offset.orElse(0);
    }

    /**
     * Handles the mode of the next frame, as the robot reports it after a Start.
     *
     * @return whether Start must be sent again
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

    /** A mode that is impossible with the offset, twice in a row, proves the offset wrong. */
    private void correct(int reported) {
        boolean ruledOut = reported == (value() == 0 ? HIGHEST : OiMode.OFF.code());
        impossible = ruledOut ? impossible + 1 : 0;
        if (impossible == 2) {
            offset = OptionalInt.of(1 - value());
            impossible = 0;
        }
    }
}
