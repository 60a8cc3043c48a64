package org.evoloop.roomba.simulator.eye;

import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;

/** A face's position in the picture. Computed for one pose after another, reusing memory. */
final class FaceView {
    /** No object is nearer to the lens than this. */
    private static final double NEAREST_MM = 20;

    /** How much nearer a thin face is assumed to be than it is. */
    private static final double THIN_MM = 15;

    private static final double SMALLEST_PX = 1e-6;

    private final Face face;
    private final double lengthMm;
    private final long color;
    private final long[] differences;
    private final double[] patchLeftPx;
    private final double[] patchRightPx;

    private double leftAheadMm;
    private double leftAsideMm;
    private double alongAheadMm;
    private double alongAsideMm;
    private double leftPx;
    private double rightPx;
    private double nearnessAtLeft;
    private double nearnessPerPx;

    FaceView(Face face) {
        this.face = face;
        this.lengthMm = face.lengthMm();
        this.color = Rgb.of(face.rgb());
        int count = face.patches().size();
        differences = new long[count];
        patchLeftPx = new double[count];
        patchRightPx = new double[count];
        for (int i = 0; i < count; i++) {
            Face.Patch patch = face.patches().get(i);
            differences[i] = Rgb.of(patch.rgb()) - Rgb.of(patch.underRgb());
        }
    }

    /** Sets the pose; returns whether the face is visible from it. */
    boolean isSeen(Pose pose, double focalPx, int widthPx) {
        Point left = pose.seen(face.left());
        Point right = pose.seen(face.right());
        leftAheadMm = left.xMm();
        leftAsideMm = left.yMm();
        alongAheadMm = right.xMm() - left.xMm();
        alongAsideMm = right.yMm() - left.yMm();
        if (Math.max(leftAheadMm, right.xMm()) <= NEAREST_MM) {
            return false;
        }
        double nearEnd = (NEAREST_MM - leftAheadMm) / alongAheadMm;
        double from = leftAheadMm < NEAREST_MM ? nearEnd : 0;
        double to = right.xMm() < NEAREST_MM ? nearEnd : 1;
        double onePx = columnPx(from, focalPx, widthPx);
        double otherPx = columnPx(to, focalPx, widthPx);
        boolean mirrored = onePx > otherPx;
        leftPx = Math.min(onePx, otherPx);
        rightPx = Math.max(onePx, otherPx);
        if ((mirrored && !face.bothSides()) || rightPx - leftPx < SMALLEST_PX || rightPx <= 0 || leftPx >= widthPx) {
            return false;
        }
        nearnessAtLeft = 1 / aheadMm(mirrored ? to : from);
        nearnessPerPx = (1 / aheadMm(mirrored ? from : to) - nearnessAtLeft) / (rightPx - leftPx);
        for (int i = 0; i < differences.length; i++) {
            Face.Patch patch = face.patches().get(i);
            double begin = columnPx(clamp(patch.fromMm() / lengthMm, from, to), focalPx, widthPx);
            double end = columnPx(clamp(patch.toMm() / lengthMm, from, to), focalPx, widthPx);
            patchLeftPx[i] = Math.min(begin, end);
            patchRightPx[i] = Math.max(begin, end);
        }
        return true;
    }

    private static double clamp(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }

    private double aheadMm(double share) {
        return leftAheadMm + share * alongAheadMm;
    }

    /** The picture column of a point between the face's left (0) and right (1) end, by the pinhole formula. */
    private double columnPx(double share, double focalPx, int widthPx) {
        return widthPx / 2.0 - focalPx * (leftAsideMm + share * alongAsideMm) / aheadMm(share);
    }

    boolean covers(int column) {
        return leftPx < column + 1 && rightPx > column;
    }

    /** How much of a column's width the face covers, in parts of {@link Rgb#ONE}. */
    int weight(int column) {
        return weight(leftPx, rightPx, column);
    }

    private static int weight(double leftPx, double rightPx, int column) {
        double share = Math.min(rightPx, column + 1) - Math.max(leftPx, column);
        return share <= 0 ? 0 : (int) Math.round(share * Rgb.ONE);
    }

    /** The reciprocal of the distance ahead of the lens, at the centre of a column. */
    double nearness(int column) {
        return nearnessAtLeft + (clamp(column + 0.5, leftPx, rightPx) - leftPx) * nearnessPerPx;
    }

    /** Nearer faces are drawn over farther ones. */
    double drawnOver(double nearness) {
        return face.thin() ? nearness / (1 - Math.min(0.5, THIN_MM * nearness)) : nearness;
    }

    /** Whether nothing behind it is visible below its top. */
    boolean hidesFloor(double lensMm) {
        return face.bottomMm() <= 0 && face.topMm() >= lensMm && !face.thin();
    }

    double topMm() {
        return face.topMm();
    }

    void paint(Column target, int column, double nearness, int endRow) {
        target.cover(
                color,
                weight(column),
                target.row(face.topMm(), nearness),
                target.row(face.bottomMm(), nearness),
                endRow);
        for (int i = 0; i < differences.length; i++) {
            int weight = weight(patchLeftPx[i], patchRightPx[i], column);
            if (weight > 0) {
                Face.Patch patch = face.patches().get(i);
                target.add(
                        differences[i],
                        weight,
                        target.row(patch.topMm(), nearness),
                        target.row(patch.bottomMm(), nearness),
                        endRow);
            }
        }
    }
}
