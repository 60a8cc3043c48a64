package org.evoloop.roomba.simulator.eye;

/**
 * One column of a picture that is being painted, in lanes of 16 bits. Rows count downwards from the top. Edges are
 * antialiased by how much of a row is covered.
 */
final class Column {
    /** How much darker the floor is at the foot of an object. */
    private static final double SHADE = 0.35;

    private final long[] pixels;
    private final int height;
    private final double lensMm;
    private final double focalPx;
    private int start;

    Column(long[] pixels, int height, double lensMm, double focalPx) {
        this.pixels = pixels;
        this.height = height;
        this.lensMm = lensMm;
        this.focalPx = focalPx;
    }

    /** Moves to a column of the picture. */
    void moveTo(int column) {
        start = column * height;
    }

    /** The row of a point with this height and nearness. */
    double row(double heightMm, double nearness) {
        return height / 2.0 + focalPx * (lensMm - heightMm) * nearness;
    }

    void set(int row, long color) {
        pixels[start + row] = color;
    }

    /** Paints over the present content. */
    void cover(long color, int weight, double top, double bottom, int endRow) {
        int last = Math.min(endRow, (int) Math.ceil(Math.min(bottom, height)));
        long whole = color * Rgb.ONE;
        for (int row = (int) Math.max(0, top); row < last; row++) {
            int share = share(weight, top, bottom, row);
            int at = start + row;
            pixels[at] = share == Rgb.ONE ? whole : color * share + dimmed(pixels[at], Rgb.ONE - share);
        }
    }

    /** Adds the difference to the present content. */
    void add(long difference, int weight, double top, double bottom, int endRow) {
        int last = Math.min(endRow, (int) Math.ceil(Math.min(bottom, height)));
        for (int row = (int) Math.max(0, top); row < last; row++) {
            pixels[start + row] += difference * share(weight, top, bottom, row);
        }
    }

    private static int share(int weight, double top, double bottom, int row) {
        if (top <= row && bottom >= row + 1) {
            return weight;
        }
        double covered = Math.min(bottom, row + 1) - Math.max(top, row);
        return covered <= 0 ? 0 : (int) Math.round(weight * covered);
    }

    /** Darkens the floor in front of an object, starting at its foot. */
    void shade(double foot, double end) {
        int last = (int) Math.min(height, end);
        for (int row = (int) Math.max(0, foot); row < last; row++) {
            int share = (int) (Rgb.ONE * (1 - SHADE * (end - row) / (end - foot + 1)));
            int at = start + row;
            pixels[at] = dimmed(pixels[at], share);
        }
    }

    private static long dimmed(long pixel, int share) {
        return ((((pixel >>> 4) & Rgb.BITS_12) * share) >>> 4) & Rgb.BITS_16;
    }
}
