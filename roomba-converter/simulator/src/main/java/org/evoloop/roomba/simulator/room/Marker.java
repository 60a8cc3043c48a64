package org.evoloop.roomba.simulator.room;

/**
 * An ArUco tag of the dictionary 4x4_50, upright on a white board. It is thin, and unless it is solid in nobody's way:
 * it hangs on a wall, or where a robot can push it aside.
 *
 * @param pose the floor beneath its middle, and where it looks
 * @param id 0 to {@value #HIGHEST_ID}
 * @param sideMm of the tag without the white around it, {@value #SMALLEST_SIDE_MM} to {@value #LARGEST_SIDE_MM}
 * @param heightMm of its middle above the floor; the board does not reach below the floor
 * @param covered whether somebody has hung a cloth over it
 * @param solid whether the board stands on the floor like a wall, as wide as it is
 * @since 0.1
 */
public record Marker(Pose pose, int id, double sideMm, double heightMm, boolean covered, boolean solid) {
    /** The highest id of the marker's dictionary, ArUco 4x4_50. */
    public static final int HIGHEST_ID = 49;
    /** The side of a marker that says nothing else. */
    public static final double USUAL_SIDE_MM = 150;
    /** The height of a marker that says nothing else. */
    public static final double USUAL_HEIGHT_MM = 150;

    private static final double SMALLEST_SIDE_MM = 20;
    private static final double LARGEST_SIDE_MM = 1_000;
    private static final double HIGHEST_MM = 2_000;

    /** Four cells and the black around them; the white around that is one cell wide. */
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

    /** The usual marker, for all to see. */
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

    /** The pose this far before it, looking at it. */
    public Pose before(double distanceMm) {
        Point place = pose.ahead(distanceMm, 0);
        return new Pose(place.xMm(), place.yMm(), pose.headingRad() + Math.PI);
    }

    /** The same marker elsewhere. */
    public Marker movedTo(Pose place) {
        return new Marker(place, id, sideMm, heightMm, covered, solid);
    }

    /** The same marker with a cloth over it or without. */
    public Marker covered(boolean cloth) {
        return new Marker(pose, id, sideMm, heightMm, cloth, solid);
    }

    /** Where its board stands, from the left edge to the right. */
    Segment board() {
        return new Segment(pose.ahead(0, boardMm() / 2), pose.ahead(0, -boardMm() / 2));
    }
}
