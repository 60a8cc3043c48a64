package org.evoloop.roomba.simulator.eye;

import java.util.SplittableRandom;

/** The floor's pattern: a repeating square, stored with finer and coarser detail for near and far. */
final class Floor {
    private static final double FINEST_MM = 5;
    private static final int FINEST_SIZE = 512;

    /** Far more than the room is wide, so that texel numbers are never negative. */
    private static final double OFFSET_TEXELS = 1 << 24;

    private static final int PLANK_TEXELS = 32;
    private static final int TILE_TEXELS = 64;
    private static final int[] WOODS = {0xB98A5A, 0x9C6B3F, 0xC9A877, 0x8A7058};
    private static final int[] TILES = {0xD8D2C4, 0x9AA5AD, 0xB5651D, 0xE6E6E0};
    private static final int[] CARPETS = {0x7B8FA1, 0xA39171, 0x6B7F5E, 0x935D5D};

    private final long[][] levels;

    /** A floor of wood, tiles or carpet. */
    Floor(SplittableRandom random) {
        int[] finest = new int[FINEST_SIZE * FINEST_SIZE];
        switch (random.nextInt(3)) {
            case 0 -> layPlanks(finest, random);
            case 1 -> layTiles(finest, random);
            default -> layCarpet(finest, random);
        }
        int count = Integer.numberOfTrailingZeros(FINEST_SIZE) + 1;
        levels = new long[count][];
        for (int level = 0; level < count; level++) {
            levels[level] = new long[finest.length];
            for (int i = 0; i < finest.length; i++) {
                levels[level][i] = Rgb.of(finest[i]) * Rgb.ONE;
            }
            finest = halved(finest);
        }
    }

    private static void layPlanks(int[] texels, SplittableRandom random) {
        int wood = WOODS[random.nextInt(WOODS.length)];
        for (int row = 0; row < FINEST_SIZE / PLANK_TEXELS; row++) {
            int joint = random.nextInt(FINEST_SIZE);
            double tone = 0.85 + random.nextDouble() * 0.25;
            for (int y = row * PLANK_TEXELS; y < (row + 1) * PLANK_TEXELS; y++) {
                double grain = 0.96 + random.nextDouble() * 0.08;
                for (int x = 0; x < FINEST_SIZE; x++) {
                    boolean gap = y == row * PLANK_TEXELS || x == joint;
                    texels[y * FINEST_SIZE + x] = Rgb.shaded(wood, gap ? 0.5 : tone * grain);
                }
            }
        }
    }

    private static void layTiles(int[] texels, SplittableRandom random) {
        int one = TILES[random.nextInt(TILES.length)];
        int other = random.nextBoolean() ? one : TILES[random.nextInt(TILES.length)];
        for (int i = 0; i < texels.length; i++) {
            int x = i % FINEST_SIZE;
            int y = i / FINEST_SIZE;
            boolean gap = x % TILE_TEXELS < 2 || y % TILE_TEXELS < 2;
            int tile = (x / TILE_TEXELS + y / TILE_TEXELS) % 2 == 0 ? one : other;
            texels[i] = Rgb.shaded(tile, gap ? 0.6 : 0.97 + random.nextDouble() * 0.03);
        }
    }

    private static void layCarpet(int[] texels, SplittableRandom random) {
        int carpet = CARPETS[random.nextInt(CARPETS.length)];
        for (int i = 0; i < texels.length; i++) {
            texels[i] = Rgb.shaded(carpet, 0.8 + random.nextDouble() * 0.3);
        }
    }

    private static int[] halved(int[] texels) {
        int size = (int) Math.round(Math.sqrt(texels.length)) / 2;
        int[] halved = new int[size * size];
        for (int i = 0; i < halved.length; i++) {
            int at = i / size * 2 * size * 2 + i % size * 2;
            int upper = Rgb.mixed(texels[at], texels[at + 1], 0.5);
            halved[i] = Rgb.mixed(upper, Rgb.mixed(texels[at + 2 * size], texels[at + 2 * size + 1], 0.5), 0.5);
        }
        return halved;
    }

    /** The level of detail to use where a pixel covers this much of the floor; 0 is the finest. */
    int level(double pixelMm) {
        int level = (int) Math.ceil(Math.log(pixelMm / FINEST_MM) / Math.log(2));
        return Math.max(0, Math.min(levels.length - 1, level));
    }

    /** The colour at a point, in lanes of 16 bits. */
    long at(double xMm, double yMm, int level) {
        int bits = levels.length - 1 - level;
        double perMm = 1 / (FINEST_MM * (1 << level));
        int mask = (1 << bits) - 1;
        int x = (int) (xMm * perMm + OFFSET_TEXELS) & mask;
        int y = (int) (yMm * perMm + OFFSET_TEXELS) & mask;
        return levels[level][(y << bits) + x];
    }
}
