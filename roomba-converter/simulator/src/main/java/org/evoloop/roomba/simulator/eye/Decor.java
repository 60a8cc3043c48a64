package org.evoloop.roomba.simulator.eye;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.evoloop.roomba.simulator.eye.Face.Patch;

/** Paints furniture fronts and wall decoration: many squares with high contrast, as in real rooms. */
final class Decor {
    private static final int[] VIVID = {
        0xC92A2A, 0x1971C2, 0x2F9E44, 0xE8590C, 0x9C36B5, 0x0C8599, 0xF2C037, 0x5C940D, 0x862E9C, 0xD6336C, 0x3B3B45,
        0x8A5A33, 0xD9D5CC, 0x4A6FA5
    };
    private static final int[] WALLPAPERS = {0xE6E0D2, 0xD4DCE2, 0xDDE3CF, 0xE8D3C4, 0xCFC8DC};
    private static final int WHITE = 0xF0EEE8;
    private static final int DARK = 0x2B2725;
    private static final double SKIRTING_MM = 80;

    private final SplittableRandom random;
    private final List<Patch> patches = new ArrayList<>();

    Decor(SplittableRandom random) {
        this.random = random;
    }

    int vivid() {
        return VIVID[random.nextInt(VIVID.length)];
    }

    int wallpaper() {
        return WALLPAPERS[random.nextInt(WALLPAPERS.length)];
    }

    private double between(double least, double most) {
        return least + random.nextDouble() * (most - least);
    }

    private void add(double fromMm, double toMm, double bottomMm, double topMm, int rgb, int underRgb) {
        patches.add(new Patch(fromMm, toMm, bottomMm, topMm, rgb, underRgb));
    }

    /** The decoration of a wall. */
    List<Patch> wall(double lengthMm, double heightMm, int rgb) {
        add(0, lengthMm, 0, SKIRTING_MM, WHITE, rgb);
        double atMm = between(100, 500);
        while (atMm < lengthMm - 100) {
            double widthMm = Math.min(between(300, 1_300), lengthMm - 60 - atMm);
            double topMm = heightMm - 60;
            switch (random.nextInt(6)) {
                case 0 -> door(atMm, Math.min(widthMm, 900), Math.min(2_000, topMm), rgb);
                case 1 -> radiator(atMm, atMm + widthMm, Math.min(700, topMm), rgb);
                case 2 -> poster(atMm, atMm + Math.min(widthMm, 700), between(250, 1_000), topMm, rgb);
                case 3 -> window(atMm, atMm + widthMm, topMm, rgb);
                case 4 -> stripes(atMm, atMm + widthMm, SKIRTING_MM + 10, Math.min(2_200, topMm), vivid(), rgb);
                default -> add(atMm, atMm + Math.min(widthMm, 80), 250, 330, WHITE, rgb);
            }
            atMm += widthMm + between(100, 900);
        }
        return patches;
    }

    private void door(double fromMm, double widthMm, double topMm, int under) {
        int leaf = random.nextBoolean() ? WHITE : 0x8A5A33;
        int inset = Rgb.shaded(leaf, 0.85);
        double bottomMm = SKIRTING_MM + 5;
        add(fromMm, fromMm + widthMm, bottomMm, topMm, leaf, under);
        add(fromMm + widthMm * 0.15, fromMm + widthMm * 0.85, bottomMm + 100, topMm * 0.45, inset, leaf);
        add(fromMm + widthMm * 0.15, fromMm + widthMm * 0.85, topMm * 0.52, topMm - 120, inset, leaf);
    }

    private void radiator(double fromMm, double toMm, double topMm, int under) {
        add(fromMm, toMm, 120, topMm, WHITE, under);
        for (double atMm = fromMm + 20; atMm < toMm - 25; atMm += 55) {
            add(atMm, atMm + 15, 140, topMm - 30, Rgb.shaded(WHITE, 0.72), WHITE);
        }
    }

    private void poster(double fromMm, double toMm, double bottomMm, double mostMm, int under) {
        int rows = 2 + random.nextInt(4);
        int columns = 2 + random.nextInt(4);
        double topMm = Math.min(bottomMm + (toMm - fromMm) * rows / columns, mostMm);
        if (topMm < bottomMm + 100) {
            return;
        }
        int paper = random.nextBoolean() ? WHITE : DARK;
        add(fromMm, toMm, bottomMm, topMm, paper, under);
        double marginMm = (toMm - fromMm) * 0.08;
        double cellMm = (toMm - fromMm - 2 * marginMm) / columns;
        double cellHeightMm = (topMm - bottomMm - 2 * marginMm) / rows;
        for (int i = 0; i < rows * columns; i++) {
            if (random.nextInt(3) > 0) {
                double leftMm = fromMm + marginMm + i % columns * cellMm;
                int row = i / columns;
                double lowMm = bottomMm + marginMm + row * cellHeightMm;
                int color = random.nextBoolean() ? vivid() : paper == DARK ? WHITE : DARK;
                add(leftMm, leftMm + cellMm, lowMm, lowMm + cellHeightMm, color, paper);
            }
        }
    }

    private void window(double fromMm, double toMm, double mostMm, int under) {
        double topMm = Math.min(2_100, mostMm);
        if (topMm < 1_100) {
            return;
        }
        add(fromMm, toMm, 900, topMm, WHITE, under);
        double middleMm = (fromMm + toMm) / 2;
        add(fromMm + 50, middleMm - 25, 950, topMm - 50, 0xCFE8F5, WHITE);
        add(middleMm + 25, toMm - 50, 950, topMm - 50, 0xCFE8F5, WHITE);
    }

    private void stripes(double fromMm, double toMm, double bottomMm, double topMm, int rgb, int under) {
        add(fromMm, toMm, bottomMm, topMm, rgb, under);
        double stepMm = between(40, 120);
        int other = Rgb.mixed(rgb, random.nextBoolean() ? 0xFFFFFF : 0x000000, 0.45);
        for (double atMm = fromMm + stepMm / 2; atMm + stepMm / 2 < toMm; atMm += stepMm) {
            add(atMm, atMm + stepMm / 2, bottomMm, topMm, other, rgb);
        }
    }

    /**
     * One side of a piece of furniture.
     *
     * @param style any number; the same for all sides of a piece
     */
    List<Patch> furniture(double lengthMm, double heightMm, int rgb, int style) {
        if (lengthMm < 60) {
            return patches;
        }
        add(0, lengthMm, 0, 30, DARK, rgb);
        switch (style) {
            case 0 -> doors(lengthMm, heightMm, rgb);
            case 1 -> drawers(lengthMm, heightMm, rgb);
            case 2 -> books(lengthMm, heightMm, rgb);
            case 3 -> cushions(lengthMm, heightMm, rgb);
            case 4 -> stripes(20, lengthMm - 20, 60, heightMm - 30, vivid(), rgb);
            default -> checks(lengthMm, heightMm, rgb);
        }
        return patches;
    }

    private void doors(double lengthMm, double heightMm, int rgb) {
        int count = (int) Math.max(1, Math.round(lengthMm / 420));
        double widthMm = lengthMm / count;
        int panel = Rgb.mixed(rgb, 0xFFFFFF, 0.18);
        for (int i = 0; i < count; i++) {
            double fromMm = i * widthMm;
            add(fromMm + 20, fromMm + widthMm - 20, 60, heightMm - 25, panel, rgb);
            double knobMm = i % 2 == 0 ? fromMm + widthMm - 55 : fromMm + 35;
            add(knobMm, knobMm + 20, heightMm * 0.6, heightMm * 0.6 + 50, DARK, panel);
        }
    }

    private void drawers(double lengthMm, double heightMm, int rgb) {
        int count = (int) Math.max(2, Math.round(heightMm / 190));
        double stepMm = (heightMm - 60) / count;
        int panel = Rgb.mixed(rgb, 0xFFFFFF, 0.14);
        for (int i = 0; i < count; i++) {
            double bottomMm = 45 + i * stepMm;
            add(15, lengthMm - 15, bottomMm, bottomMm + stepMm - 14, panel, rgb);
            double middleMm = bottomMm + stepMm / 2 - 15;
            add(lengthMm * 0.42, lengthMm * 0.58, middleMm, middleMm + 16, 0xC9C9C9, panel);
        }
    }

    private void books(double lengthMm, double heightMm, int rgb) {
        int count = (int) Math.max(1, Math.round(heightMm / 300));
        double stepMm = (heightMm - 50) / count;
        for (int i = 0; i < count; i++) {
            double bottomMm = 45 + i * stepMm;
            add(20, lengthMm - 20, bottomMm, bottomMm + stepMm - 22, DARK, rgb);
            double atMm = 24;
            while (atMm < lengthMm - 80) {
                double widthMm = between(14, 48);
                if (random.nextInt(9) > 0) {
                    double topMm = bottomMm + (stepMm - 22) * between(0.6, 0.95);
                    add(atMm, atMm + widthMm, bottomMm, topMm, vivid(), DARK);
                }
                atMm += widthMm + 2;
            }
        }
    }

    private void cushions(double lengthMm, double heightMm, int rgb) {
        int count = (int) Math.max(1, Math.round(lengthMm / 600));
        double widthMm = lengthMm / count;
        for (int i = 0; i < count; i++) {
            int soft = Rgb.mixed(rgb, 0xFFFFFF, between(0.05, 0.2));
            add(i * widthMm + 10, (i + 1) * widthMm - 10, 90, heightMm * 0.5, soft, rgb);
            add(i * widthMm + 10, (i + 1) * widthMm - 10, heightMm * 0.53, heightMm - 15, soft, rgb);
        }
    }

    private void checks(double lengthMm, double heightMm, int rgb) {
        double cellMm = between(50, 130);
        int other = random.nextBoolean() ? WHITE : DARK;
        for (int row = 0; 40 + (row + 1) * cellMm < heightMm - 5; row++) {
            for (int column = row % 2; (column + 1) * cellMm < lengthMm; column += 2) {
                double bottomMm = 40 + row * cellMm;
                add(column * cellMm, (column + 1) * cellMm, bottomMm, bottomMm + cellMm, other, rgb);
            }
        }
    }

    /** The number of furniture styles. */
    static int styles() {
        return 6;
    }
}
