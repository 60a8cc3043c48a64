package org.evoloop.roomba.session.inference;

import java.time.Duration;
import org.evoloop.roomba.oi.ChargingState;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.SensorValues;

/**
 * Tracks the robot's circumstances: wheel drops and overcurrents (packets 7 and 14) are trouble, the home base among
 * the charging sources (34) is the dock, and the charging state (21) shows whether the dock fills the battery. Sleep is
 * inferred: the robot has been idle in Passive mode for the time that the specification states, and is silent. On its
 * dock it may fall asleep at any time: it was idle before anybody listened, and its firmware has its own rules there.
 *
 * <p>Time is counted in frames of the stream, one every 15 ms.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class CircumstanceWatch {
    /**
     * A robot that was idle in Passive mode for five minutes sleeps (specification, "Passive Mode"). This part of them
     * must have been received in frames: on a noisy line one in four is lost.
     */
    static final Duration DROWSY = Duration.ofSeconds(200);

    private static final int DROWSY_FRAMES = (int) (DROWSY.toMillis() / 15);

    private Circumstances now = Circumstances.USUAL;
    private Circumstances seen = Circumstances.USUAL;
    private int seenFrames;
    private int busyFrames;
    private int idleFrames;

    /** Before any frame. */
    public CircumstanceWatch() {}

    /** The circumstances after the frames so far. */
    public Circumstances now() {
        return now;
    }

    /**
     * Handles the next frame.
     *
     * @param atWork whether the robot is estimated to be working by itself
     * @return whether they have changed
     */
    public boolean update(SensorValues values, boolean atWork) {
        boolean passive = values.mode().filter(mode -> mode == OiMode.PASSIVE).isPresent();
        busyFrames = passive && !atWork && values.buttons().isEmpty() ? 0 : busyFrames + 1;
        idleFrames = busyFrames < SpotWatch.SURE_FRAMES ? idleFrames + 1 : 0;
        Circumstances shown = shown(values);
        seenFrames = shown.equals(seen) ? seenFrames + 1 : 1;
        seen = shown;
        // A single frame may be corrupt.
        return isSure() && become(shown);
    }

    private static Circumstances shown(SensorValues values) {
        boolean filling = values.chargingState()
                .filter(state -> state == ChargingState.FULL_CHARGING || state == ChargingState.RECONDITIONING)
                .isPresent();
        return new Circumstances(
                false,
                values.anyWheelDrop() || values.anyOvercurrent(),
                values.onHomeBase(),
                values.onHomeBase() && filling);
    }

    /** Whether enough frames were received since the robot was unreachable. */
    public boolean isSure() {
        return seenFrames >= SpotWatch.SURE_FRAMES;
    }

    /** Forgets earlier frames, since the robot was unreachable. */
    public void forget() {
        seenFrames = 0;
    }

    /** The wake line was pulsed, which restarts the robot's idle time. */
    public void keptAwake() {
        idleFrames = 0;
    }

    /** Whether a robot that falls silent now has fallen asleep. */
    public boolean isDrowsy() {
        return idleFrames >= (now.docked() ? SpotWatch.SURE_FRAMES : DROWSY_FRAMES);
    }

    /** It has fallen asleep; returns whether that is a change. */
    public boolean fellAsleep() {
        idleFrames = 0;
        seenFrames = 0;
        return become(Circumstances.ASLEEP);
    }

    private boolean become(Circumstances next) {
        boolean news = !next.equals(now);
        now = next;
        return news;
    }
}
