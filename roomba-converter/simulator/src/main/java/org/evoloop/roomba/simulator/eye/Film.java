package org.evoloop.roomba.simulator.eye;

import java.util.SplittableRandom;

/** Turns the light through the lens into a picture: blurs, dims and adds noise. */
final class Film {
    /** Where the Gaussian is cut off, in standard deviations. */
    private static final double REACH = 2.6;

    /** How many points of a motion blur are added up. */
    private static final int SMEAR_POINTS = 64;

    /** Hides the gaps between the points of a motion blur. */
    private static final double SMALLEST_BLUR_PX = 0.3;

    /** A power of two. */
    private static final int NOISE_VALUES = 1 << 16;

    /** The fraction bits of pixels and noise. */
    private static final int FRACTION_BITS = 4;

    private static final int HALF = 1 << (FRACTION_BITS - 1);

    private final int width;
    private final int height;
    private final double focalPx;
    private final long seed;
    private final Effects effects;
    private final int[] blur;
    private final int[] light;
    private final short[] noise = new short[NOISE_VALUES];
    private final long[] column;

    Film(EyeOptions options) {
        width = options.widthPx();
        height = options.heightPx();
        focalPx = options.focalPx();
        seed = options.seed();
        effects = options.effects();
        blur = kernel(effects.blurPx(), 0);
        column = new long[height + 2 * blur.length];
        light = new int[width];
        for (int x = 0; x < width; x++) {
            double share = (x + 0.5) / width;
            light[x] = (int) Math.round(Rgb.ONE * (effects.lightLeft() * (1 - share) + effects.lightRight() * share));
        }
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < NOISE_VALUES; i++) {
            noise[i] = (short) Math.round(random.nextGaussian() * effects.noiseLevels() * (1 << FRACTION_BITS));
        }
    }

    /**
     * Weights of the centre, its neighbours, their neighbours and so on; with both sides they add up to {@link
     * Rgb#ONE}.
     */
    private static int[] kernel(double blurPx, double smearPx) {
        if (blurPx == 0 && smearPx == 0) {
            return new int[] {Rgb.ONE};
        }
        double sigma = Math.max(blurPx, SMALLEST_BLUR_PX);
        double[] weights = new double[(int) Math.ceil(REACH * sigma + smearPx / 2) + 1];
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            for (int point = 0; point < SMEAR_POINTS; point++) {
                double at = i - smearPx * ((point + 0.5) / SMEAR_POINTS - 0.5);
                weights[i] += Math.exp(-at * at / (2 * sigma * sigma));
            }
            sum += i == 0 ? weights[0] : 2 * weights[i];
        }
        int[] kernel = new int[weights.length];
        kernel[0] = Rgb.ONE;
        for (int i = 1; i < kernel.length; i++) {
            kernel[i] = (int) Math.round(weights[i] / sum * Rgb.ONE);
            kernel[0] -= 2 * kernel[i];
        }
        return kernel;
    }

    /**
     * The bytes of a picture.
     *
     * @param pixels column by column, in lanes of 16 bits; reduced to 12 bits in place
     */
    byte[] develop(long[] pixels, double turnRadPerS, long frameNumber) {
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = (pixels[i] >>> (8 - FRACTION_BITS)) & Rgb.BITS_12;
        }
        double turnedPx = Math.abs(turnRadPerS) * effects.exposureMillis() / 1000 * focalPx;
        double smearPx = effects.motionPx() + Math.min(Effects.LONGEST_SMEAR_PX, turnedPx);
        int[] across = smearPx == 0 ? blur : kernel(effects.blurPx(), smearPx);
        SplittableRandom random = new SplittableRandom(seed * 31 + frameNumber);
        byte[] bgr = new byte[width * height * 3];
        for (int x = 0; x < width; x++) {
            blurAcross(pixels, x, across);
            expose(bgr, x, random.nextInt());
        }
        return bgr;
    }

    /** Blurs a column with its neighbour columns, and repeats its end pixels as a margin. */
    private void blurAcross(long[] pixels, int x, int[] kernel) {
        int margin = blur.length;
        System.arraycopy(pixels, x * height, column, margin, height);
        if (kernel.length > 1) {
            for (int y = 0; y < height; y++) {
                column[margin + y] *= kernel[0];
            }
            for (int i = 1; i < kernel.length; i++) {
                int left = Math.max(0, x - i) * height;
                int right = Math.min(width - 1, x + i) * height;
                int weight = kernel[i];
                for (int y = 0; y < height; y++) {
                    column[margin + y] += (pixels[left + y] + pixels[right + y]) * weight;
                }
            }
            for (int y = 0; y < height; y++) {
                column[margin + y] = (column[margin + y] >>> 8) & Rgb.BITS_12;
            }
        }
        for (int i = 0; i < margin; i++) {
            column[i] = column[margin];
            column[margin + height + i] = column[margin + height - 1];
        }
    }

    /** Blurs a column vertically, and writes the sensor's values. */
    private void expose(byte[] bgr, int x, int noiseStart) {
        int margin = blur.length;
        int bright = light[x];
        for (int y = 0; y < height; y++) {
            int middle = margin + y;
            long pixel = column[middle] * blur[0];
            for (int i = 1; i < blur.length; i++) {
                pixel += (column[middle - i] + column[middle + i]) * blur[i];
            }
            pixel = (pixel >>> 8) & Rgb.BITS_12;
            int at = (y * width + x) * 3;
            int random = noiseStart + 3 * y;
            bgr[at] = level((int) pixel & 0xFFF, bright, random);
            bgr[at + 1] = level((int) (pixel >>> Rgb.LANE_BITS) & 0xFFF, bright, random + 1);
            bgr[at + 2] = level((int) (pixel >>> (2 * Rgb.LANE_BITS)) & 0xFFF, bright, random + 2);
        }
    }

    private byte level(int value, int bright, int random) {
        int level = (value * bright) / Rgb.ONE + noise[random & (NOISE_VALUES - 1)] + HALF;
        return (byte) Math.max(0, Math.min(255, level >> FRACTION_BITS));
    }
}
