package org.evoloop.roomba.simulator.body;

/**
 * How the cleaning motors are powered, each as a part of full power.
 *
 * @param mainBrush -1 to 1
 * @param sideBrush -1 to 1
 * @param vacuum 0 to 1
 */
public record CleaningMotors(double mainBrush, double sideBrush, double vacuum) {
    public static final CleaningMotors OFF = new CleaningMotors(0, 0, 0);
    public static final CleaningMotors ON = new CleaningMotors(1, 1, 1);

    private static final double MAIN_BRUSH_FULL_MILLI_AMPS = 400;
    private static final double SIDE_BRUSH_FULL_MILLI_AMPS = 100;
    private static final double VACUUM_FULL_MILLI_AMPS = 150;

    public int mainBrushMilliAmps() {
        return (int) (MAIN_BRUSH_FULL_MILLI_AMPS * Math.abs(mainBrush));
    }

    public int sideBrushMilliAmps() {
        return (int) (SIDE_BRUSH_FULL_MILLI_AMPS * Math.abs(sideBrush));
    }

    /** The only one that no sensor packet tells. */
    public int vacuumMilliAmps() {
        return (int) (VACUUM_FULL_MILLI_AMPS * vacuum);
    }
}
