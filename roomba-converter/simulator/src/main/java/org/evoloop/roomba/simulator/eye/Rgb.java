package org.evoloop.roomba.simulator.eye;

/**
 * A colour in one long, so that one operation processes red, green and blue: a lane of 21 bits each. The lanes are wide
 * enough to multiply a value by two weights in parts of 256 without overflow.
 */
final class Rgb {
    static final int LANE_BITS = 21;

    /** A weight of one. */
    static final int ONE = 256;

    private static final long EACH = (1L << (2 * LANE_BITS)) | (1L << LANE_BITS) | 1;

    /** The lower 8, 12 and 16 bits of every lane. */
    static final long BITS_8 = EACH * 0xFF;

    static final long BITS_12 = EACH * 0xFFF;
    static final long BITS_16 = EACH * 0xFFFF;

    private static final int DARKEST = 4;
    private static final int BRIGHTEST = 250;

    private Rgb() {}

    /** From 0xRRGGBB; black and white are slightly clipped, so that rounded sums of differences stay in their lanes. */
    static long of(int rgb) {
        return (lane(rgb >> 16) << (2 * LANE_BITS)) | (lane(rgb >> 8) << LANE_BITS) | lane(rgb);
    }

    private static long lane(int value) {
        return Math.max(DARKEST, Math.min(BRIGHTEST, value & 0xFF));
    }

    /** A colour of 0xRRGGBB that is lighter or darker by a factor. */
    static int shaded(int rgb, double factor) {
        return (brighter(rgb >> 16, factor) << 16) | (brighter(rgb >> 8, factor) << 8) | brighter(rgb, factor);
    }

    private static int brighter(int value, double factor) {
        return (int) Math.min(255, Math.round((value & 0xFF) * factor));
    }

    /** A mix of two colours; the first if {@code share} is 0. */
    static int mixed(int rgb, int other, double share) {
        int mixed = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            double value = ((rgb >> shift) & 0xFF) * (1 - share) + ((other >> shift) & 0xFF) * share;
            mixed |= (int) Math.round(value) << shift;
        }
        return mixed;
    }
}
