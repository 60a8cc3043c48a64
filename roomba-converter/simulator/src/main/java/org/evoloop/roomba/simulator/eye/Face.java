package org.evoloop.roomba.simulator.eye;

import java.util.List;
import org.evoloop.roomba.simulator.room.Point;

/**
 * A flat upright surface in the room, from {@code left} to {@code right} as seen from its front.
 *
 * @param rgb the colour outside the patches
 * @param patches what is painted on it; they do not overlap
 * @param bothSides whether it is also visible from behind, mirrored
 * @param thin whether it is mounted on other faces, and drawn in front of those at the same distance
 */
record Face(
        Point left,
        Point right,
        double bottomMm,
        double topMm,
        int rgb,
        List<Patch> patches,
        boolean bothSides,
        boolean thin) {

    /**
     * A rectangle on a face.
     *
     * @param fromMm its left edge, from the face's left edge
     * @param toMm its right edge, from the face's left edge
     * @param bottomMm its height above the floor at the bottom
     * @param topMm its height above the floor at the top
     * @param underRgb the colour it covers
     */
    record Patch(double fromMm, double toMm, double bottomMm, double topMm, int rgb, int underRgb) {}

    Face {
        patches = List.copyOf(patches);
    }

    double lengthMm() {
        return Math.hypot(right.xMm() - left.xMm(), right.yMm() - left.yMm());
    }

    /** The same face in different light. */
    Face shaded(double factor) {
        List<Patch> shaded = patches.stream()
                .map(patch -> new Patch(
                        patch.fromMm(),
                        patch.toMm(),
                        patch.bottomMm(),
                        patch.topMm(),
                        Rgb.shaded(patch.rgb(), factor),
                        Rgb.shaded(patch.underRgb(), factor)))
                .toList();
        return new Face(left, right, bottomMm, topMm, Rgb.shaded(rgb, factor), shaded, bothSides, thin);
    }
}
