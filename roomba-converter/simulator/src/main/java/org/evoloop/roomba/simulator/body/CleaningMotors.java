package org.evoloop.roomba.simulator.body;

/**
 * The power of the cleaning motors, each as a fraction of full power.
 *
 * @param mainBrush -1 to 1
 * @param sideBrush -1 to 1
 * @param vacuum 0 to 1
 * @since 0.1
 */
public record CleaningMotors(double mainBrush, double sideBrush, double vacuum) {
    /** All motors are off. */
    public static final CleaningMotors OFF = new CleaningMotors(0, 0, 0);
    /** All motors at full power. */
    public static final CleaningMotors ON = new CleaningMotors(1, 1, 1);

    private static final double MAIN_BRUSH_FULL_MILLI_AMPS = 400;
    private static final double SIDE_BRUSH_FULL_MILLI_AMPS = 100;
    private static final double VACUUM_FULL_MILLI_AMPS = 150;

    /** What the main brush draws. */
    public int mainBrushMilliAmps() {
        return (int) (MAIN_BRUSH_FULL_MILLI_AMPS * Math.abs(mainBrush));
    }

    /** What the side brush draws. */
    public int sideBrushMilliAmps() {
        return (int) (SIDE_BRUSH_FULL_MILLI_AMPS * Math.abs(sideBrush));
    }

    /** What the vacuum draws; no sensor packet reports it. */
    public int vacuumMilliAmps() {
        return (int) (VACUUM_FULL_MILLI_AMPS * vacuum);
    }
}
