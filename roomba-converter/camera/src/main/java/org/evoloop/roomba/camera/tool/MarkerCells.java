package org.evoloop.roomba.camera.tool;

import org.evoloop.roomba.camera.MarkerDictionary;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.vision.OpenCv;

/**
 * The black and white cells of markers. The most common markers are built in, so that printing them needs no OpenCV.
 */
final class MarkerCells {
    private static final int CELLS = 4;

    /** ArUco's 4x4_50: a marker in 16 bits, from the upper left, row by row; 1 is white. */
    private static final String USUAL = "b532 0f9a 332d 9946 549e 79cd 9e2e c4f2 feda cf56 "
            + "f991 11a7 0eb7 2a0f 24b1 263e 4665 6600 6c5e 76af "
            + "868b b02b ccd5 dd82 fe47 9471 ace4 a554 2123 346f "
            + "4415 57b2 9ecf f0cb 08ae 0929 1875 04ff 0df6 1c5a "
            + "1718 2a28 328c 38b2 24e8 2eeb 2d3f 4b64 502e 5013";

    private MarkerCells() {}

    /** Rows of cells, the black border of one cell included; true is white. */
    static boolean[][] of(MarkerSpec marker) {
        return marker.dictionary() == MarkerDictionary.ARUCO_4X4_50
                ? usual(marker.id())
                : OpenCv.vision().markerCells(marker.dictionary(), marker.id());
    }

    private static boolean[][] usual(int id) {
        int bits = Integer.parseInt(USUAL.substring(5 * id, 5 * id + 4), 16);
        boolean[][] cells = new boolean[CELLS + 2][CELLS + 2];
        for (int i = 0; i < CELLS * CELLS; i++) {
            cells[1 + i / CELLS][1 + i % CELLS] = (bits >> (CELLS * CELLS - 1 - i) & 1) == 1;
        }
        return cells;
    }
}
