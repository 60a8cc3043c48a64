package org.evoloop.roomba.camera;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** The sets of square markers that OpenCV knows. */
public enum MarkerDictionary {
    ARUCO_4X4_50(0, 4, 50),
    ARUCO_4X4_100(1, 4, 100),
    ARUCO_4X4_250(2, 4, 250),
    ARUCO_4X4_1000(3, 4, 1000),
    ARUCO_5X5_50(4, 5, 50),
    ARUCO_5X5_100(5, 5, 100),
    ARUCO_5X5_250(6, 5, 250),
    ARUCO_5X5_1000(7, 5, 1000),
    ARUCO_6X6_50(8, 6, 50),
    ARUCO_6X6_100(9, 6, 100),
    ARUCO_6X6_250(10, 6, 250),
    ARUCO_6X6_1000(11, 6, 1000),
    ARUCO_7X7_50(12, 7, 50),
    ARUCO_7X7_100(13, 7, 100),
    ARUCO_7X7_250(14, 7, 250),
    ARUCO_7X7_1000(15, 7, 1000),
    ARUCO_ORIGINAL(16, 5, 1024),
    APRILTAG_16H5(17, 4, 30),
    APRILTAG_25H9(18, 5, 35),
    APRILTAG_36H10(19, 6, 2320),
    APRILTAG_36H11(20, 6, 587);

    private final int number;
    private final int cells;
    private final int size;

    MarkerDictionary(int number, int cells, int size) {
        this.number = number;
        this.cells = cells;
        this.size = size;
    }

    /** OpenCV's number for it. */
    public int number() {
        return number;
    }

    /** How many cells a marker has along its side, without the black border of one cell. */
    public int cells() {
        return cells;
    }

    /** How many markers there are; ids count from 0. */
    public int size() {
        return size;
    }

    /** As users write it: 4x4_50, original, 36h11. */
    public String label() {
        return name().substring(name().indexOf('_') + 1).toLowerCase(Locale.ROOT);
    }

    /**
     * The dictionary of that label, in any case, with or without OpenCV's prefix {@code DICT_}.
     *
     * @throws CameraException if there is none
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
