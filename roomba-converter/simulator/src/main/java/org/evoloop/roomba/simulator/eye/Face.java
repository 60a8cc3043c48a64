package org.evoloop.roomba.simulator.eye;

import java.util.List;
import org.evoloop.roomba.simulator.room.Point;

/**
 * Something flat and upright in the room, from {@code left} to {@code right} as those see it who look at its front.
 *
 * @param rgb what is not covered by patches
 * @param patches what is painted on it; none reaches into another
 * @param bothSides whether it is seen from behind as well, mirrored
 * @param thin whether it lies on other faces, and is in front of those that are as far away
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
     * @param fromMm from the face's left end to its own
     * @param toMm from the face's left end to its own right end
     * @param bottomMm above the floor
     * @param topMm above the floor
     * @param underRgb what it hides
     */
    record Patch(double fromMm, double toMm, double bottomMm, double topMm, int rgb, int underRgb) {}

    Face {
        patches = List.copyOf(patches);
    }

    double lengthMm() {
        return Math.hypot(right.xMm() - left.xMm(), right.yMm() - left.yMm());
    }

    /** The same face in other light. */
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
