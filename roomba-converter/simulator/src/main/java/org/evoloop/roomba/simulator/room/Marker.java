package org.evoloop.roomba.simulator.room;

/**
 * An ArUco tag of the dictionary 4x4_50, upright on a white board. It is thin and, unless it is solid, not an obstacle:
 * it hangs on a wall, or where a robot can push it aside.
 *
 * @param pose the point on the floor below its centre, and the direction it faces
 * @param id 0 to {@value #HIGHEST_ID}
 * @param sideMm the side of the tag without the white border, {@value #SMALLEST_SIDE_MM} to {@value #LARGEST_SIDE_MM}
 * @param heightMm the height of its centre above the floor; the board must not reach below the floor
 * @param covered whether it is covered with a cloth
 * @param solid whether the board stands on the floor like a wall of the same width
 * @since 0.1
 */
public record Marker(Pose pose, int id, double sideMm, double heightMm, boolean covered, boolean solid) {
    /** The highest id of the marker's dictionary, ArUco 4x4_50. */
    public static final int HIGHEST_ID = 49;
    /** The default side of a marker. */
    public static final double USUAL_SIDE_MM = 150;
    /** The default height of a marker. */
    public static final double USUAL_HEIGHT_MM = 150;

    private static final double SMALLEST_SIDE_MM = 20;
    private static final double LARGEST_SIDE_MM = 1_000;
    private static final double HIGHEST_MM = 2_000;

    /** Four cells and the black border; the white border around that is one cell wide. */
    private static final double CELLS_PER_SIDE = 6;

    public Marker {
        if (id < 0 || id > HIGHEST_ID) {
            throw new IllegalArgumentException("the marker's id is " + id + "; allowed is 0 to " + HIGHEST_ID);
        }
        if (!(sideMm >= SMALLEST_SIDE_MM && sideMm <= LARGEST_SIDE_MM)) {
            throw new IllegalArgumentException("the marker's side is " + sideMm + " mm; allowed is "
                    + (int) SMALLEST_SIDE_MM + " to " + (int) LARGEST_SIDE_MM);
        }
        double lowestMm = boardMm(sideMm) / 2;
        if (!(heightMm >= lowestMm && heightMm <= HIGHEST_MM)) {
            throw new IllegalArgumentException("the marker's middle is " + heightMm + " mm high; allowed is "
                    + (int) Math.ceil(lowestMm) + " to " + (int) HIGHEST_MM);
        }
    }

    /** The default marker, uncovered. */
    public static Marker at(Pose pose) {
        return new Marker(pose, 0, USUAL_SIDE_MM, USUAL_HEIGHT_MM, false, false);
    }

    private static double boardMm(double sideMm) {
        return sideMm * (CELLS_PER_SIDE + 2) / CELLS_PER_SIDE;
    }

    /** The side of the white board. */
    public double boardMm() {
        return boardMm(sideMm);
    }

    /** The side of one of the tag's squares. */
    public double cellMm() {
        return sideMm / CELLS_PER_SIDE;
    }

    /** The pose at this distance in front of the marker, facing it. */
    public Pose before(double distanceMm) {
        Point place = pose.ahead(distanceMm, 0);
        return new Pose(place.xMm(), place.yMm(), pose.headingRad() + Math.PI);
    }

    /** A copy at another pose. */
    public Marker movedTo(Pose place) {
        return new Marker(place, id, sideMm, heightMm, covered, solid);
    }

    /** A copy that is covered with a cloth, or not. */
    public Marker covered(boolean cloth) {
        return new Marker(pose, id, sideMm, heightMm, cloth, solid);
    }

    /** The board's line on the floor, from the left edge to the right. */
    Segment board() {
        return new Segment(pose.ahead(0, boardMm() / 2), pose.ahead(0, -boardMm() / 2));
    }
}
