package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Whether the robot is at work, from its wheels and currents: no packet tells it. The thresholds are those that other
 * programs for Roombas use.
 *
 * <p>Threading: not thread-safe.
 */
final class Motion {
    /** Less flows into the battery, in mA, while motors run; at rest it is about -200. */
    static final int MOVING_CURRENT_MILLI_AMPS = -300;

    /** More flows through a brush motor, in mA, while it turns. */
    static final int BRUSH_CURRENT_MILLI_AMPS = 20;

    private int restFrames = Integer.MAX_VALUE / 2;
    private int activeFrames;
    private int poweredFrames;
    private int brushlessFrames;
    private boolean brushed;
    private @Nullable SensorValues last;

    /** Takes the next frame. */
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

    /** How many frames nothing has moved or drawn current. */
    int restFrames() {
        return restFrames;
    }

    /** How many frames in a row something has. */
    int activeFrames() {
        return activeFrames;
    }

    /** How many frames in a row a motor has drawn current; a robot that is pushed only turns its wheels. */
    int poweredFrames() {
        return poweredFrames;
    }

    /** How many frames in a row it has driven with brushes at rest that turned before; 0 if it may have none. */
    int brushlessFrames() {
        return brushed ? brushlessFrames : 0;
    }

    /** The robot was out of sight; what was seen before says nothing about now. */
    void forget() {
        last = null;
        activeFrames = 0;
        poweredFrames = 0;
        brushlessFrames = 0;
        brushed = false;
        restFrames = 0;
    }
}
