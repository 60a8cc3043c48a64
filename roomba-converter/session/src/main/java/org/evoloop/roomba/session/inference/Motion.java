package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Whether the robot is at work, inferred from its wheels and currents, since no packet shows it. The thresholds are
 * those of other programs for Roombas.
 *
 * <p>Threading: not thread-safe.
 */
final class Motion {
    /** Below this battery current, in mA, motors run; at rest it is about -200. */
    static final int MOVING_CURRENT_MILLI_AMPS = -300;

    /** Above this current of a brush motor, in mA, it turns. */
    static final int BRUSH_CURRENT_MILLI_AMPS = 20;

    private int restFrames = Integer.MAX_VALUE / 2;
    private int activeFrames;
    private int poweredFrames;
    private int brushlessFrames;
    private boolean brushed;
    private @Nullable SensorValues last;

    /** Handles the next frame. */
    void update(SensorValues values) {
        boolean brushing = Math.abs(values.mainBrushMilliAmps()) > BRUSH_CURRENT_MILLI_AMPS
                || Math.abs(values.sideBrushMilliAmps()) > BRUSH_CURRENT_MILLI_AMPS;
        boolean powered = brushing || values.currentMilliAmps() < MOVING_CURRENT_MILLI_AMPS;
        boolean active = powered || hasTurned(values);
        last = values;
        restFrames = active ? 0 : restFrames + 1;
        activeFrames = active ? activeFrames + 1 : 0;
        poweredFrames = powered ? poweredFrames + 1 : 0;
        brushed |= brushing;
        brushlessFrames = powered && !brushing ? brushlessFrames + 1 : 0;
    }

    private boolean hasTurned(SensorValues values) {
        SensorValues earlier = last;
        return earlier != null
                && (earlier.leftEncoderCounts() != values.leftEncoderCounts()
                        || earlier.rightEncoderCounts() != values.rightEncoderCounts());
    }

    /** The number of frames in a row in which nothing moved or drew current. */
    int restFrames() {
        return restFrames;
    }

    /** The number of frames in a row in which something moved or drew current. */
    int activeFrames() {
        return activeFrames;
    }

    /** The number of frames in a row in which a motor drew current; if the robot is pushed, only its wheels turn. */
    int poweredFrames() {
        return poweredFrames;
    }

    /** The number of frames in a row of driving with brushes at rest that turned before; 0 if it may have none. */
    int brushlessFrames() {
        return brushed ? brushlessFrames : 0;
    }

    /** Forgets earlier frames, since the robot was unreachable. */
    void forget() {
        last = null;
        activeFrames = 0;
        poweredFrames = 0;
        brushlessFrames = 0;
        brushed = false;
        restFrames = 0;
    }
}
