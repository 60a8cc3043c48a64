package org.evoloop.roomba.camera;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * The sets of square markers that OpenCV supports.
 *
 * @since 0.1
 */
public enum MarkerDictionary {
    /** ArUco: 4 by 4 cells, 50 markers. */
    ARUCO_4X4_50(0, 4, 50),
    /** ArUco: 4 by 4 cells, 100 markers. */
    ARUCO_4X4_100(1, 4, 100),
    /** ArUco: 4 by 4 cells, 250 markers. */
    ARUCO_4X4_250(2, 4, 250),
    /** ArUco: 4 by 4 cells, 1000 markers. */
    ARUCO_4X4_1000(3, 4, 1000),
    /** ArUco: 5 by 5 cells, 50 markers. */
    ARUCO_5X5_50(4, 5, 50),
    /** ArUco: 5 by 5 cells, 100 markers. */
    ARUCO_5X5_100(5, 5, 100),
    /** ArUco: 5 by 5 cells, 250 markers. */
    ARUCO_5X5_250(6, 5, 250),
    /** ArUco: 5 by 5 cells, 1000 markers. */
    ARUCO_5X5_1000(7, 5, 1000),
    /** ArUco: 6 by 6 cells, 50 markers. */
    ARUCO_6X6_50(8, 6, 50),
    /** ArUco: 6 by 6 cells, 100 markers. */
    ARUCO_6X6_100(9, 6, 100),
    /** ArUco: 6 by 6 cells, 250 markers. */
    ARUCO_6X6_250(10, 6, 250),
    /** ArUco: 6 by 6 cells, 1000 markers. */
    ARUCO_6X6_1000(11, 6, 1000),
    /** ArUco: 7 by 7 cells, 50 markers. */
    ARUCO_7X7_50(12, 7, 50),
    /** ArUco: 7 by 7 cells, 100 markers. */
    ARUCO_7X7_100(13, 7, 100),
    /** ArUco: 7 by 7 cells, 250 markers. */
    ARUCO_7X7_250(14, 7, 250),
    /** ArUco: 7 by 7 cells, 1000 markers. */
    ARUCO_7X7_1000(15, 7, 1000),
    /** ArUco, the original set: 5 by 5 cells, 1024 markers. */
    ARUCO_ORIGINAL(16, 5, 1024),
    /** AprilTag 16h5: 4 by 4 cells, 30 markers. */
    APRILTAG_16H5(17, 4, 30),
    /** AprilTag 25h9: 5 by 5 cells, 35 markers. */
    APRILTAG_25H9(18, 5, 35),
    /** AprilTag 36h10: 6 by 6 cells, 2320 markers. */
    APRILTAG_36H10(19, 6, 2320),
    /** AprilTag 36h11: 6 by 6 cells, 587 markers. */
    APRILTAG_36H11(20, 6, 587);

    private final int number;
    private final int cells;
    private final int size;

    MarkerDictionary(int number, int cells, int size) {
        this.number = number;
        this.cells = cells;
        this.size = size;
    }

    /** OpenCV's number of this dictionary. */
    public int number() {
        return number;
    }

    /** The number of cells along a marker's side, without the black border of one cell. */
    public int cells() {
        return cells;
    }

    /** The number of markers; ids count from 0. */
    public int size() {
        return size;
    }

    /** The label as users write it: 4x4_50, original, 36h11. */
    public String label() {
        return name().substring(name().indexOf('_') + 1).toLowerCase(Locale.ROOT);
    }

    /**
     * The dictionary with this label, in upper or lower case, with or without OpenCV's prefix {@code DICT_}.
     *
     * @throws CameraException if there is no such dictionary
     */
    public static MarkerDictionary parse(String text) {
        String wanted = text.toLowerCase(Locale.ROOT).replaceFirst("^dict_", "").replaceFirst("^(aruco|apriltag)_", "");
        return Arrays.stream(values())
                .filter(dictionary -> dictionary.label().equals(wanted))
                .findFirst()
                .orElseThrow(() -> new CameraException("there is no marker dictionary " + text + "; there are "
                        + Arrays.stream(values()).map(MarkerDictionary::label).collect(Collectors.joining(", "))));
    }
}
