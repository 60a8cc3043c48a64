package org.evoloop.roomba.camera;

/**
 * The marker at the starting point.
 *
 * @param id the marker's id in its dictionary
 * @param sideMm the side of the black square, in mm, 10 to 2000
 * @since 0.1
 */
public record MarkerSpec(MarkerDictionary dictionary, int id, double sideMm) {
    /** ArUco 4x4_50, id 0, 15 cm. */
    public static final MarkerSpec DEFAULT = new MarkerSpec(MarkerDictionary.ARUCO_4X4_50, 0, 150);

    /** @throws CameraException if id or side are out of range */
    public MarkerSpec {
        if (id < 0 || id >= dictionary.size()) {
            throw new CameraException("marker id " + id + " is not in " + dictionary.label() + "; allowed is 0 to "
                    + (dictionary.size() - 1));
        }
        if (!(sideMm >= 10 && sideMm <= 2000)) {
            throw new CameraException("the marker's side is " + sideMm + " mm, allowed is 10 to 2000");
        }
    }
}
