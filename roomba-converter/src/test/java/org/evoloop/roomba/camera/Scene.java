package org.evoloop.roomba.camera;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import javax.imageio.ImageIO;
import org.evoloop.roomba.camera.CameraModel.Intrinsics;
import org.evoloop.roomba.camera.vision.OpenCv;

/** Pictures of a wall with the usual marker upright before it, by perspective, with noise. */
public final class Scene {
    public static final int WIDTH = 640;
    public static final int HEIGHT = 480;

    private static final double NOISE = 6;
    private static final int SAMPLES = 3;
    private static final double HEIGHT_DIFFERENCE_MM = 30;

    private Scene() {}

    /** How it looks to the default camera; the marker's middle is a little lower than the lens. */
    public static BufferedImage of(Sighting marker, long seed) {
        return of(marker, OpenCv.vision().markerCells(MarkerDictionary.ARUCO_4X4_50, 0), seed);
    }

    /** A wall alone. */
    public static BufferedImage empty(long seed) {
        return of(new Sighting(2000, 0), new boolean[0][], seed);
    }

    private static BufferedImage of(Sighting marker, boolean[][] cells, long seed) {
        Random random = new Random(seed);
        Intrinsics camera = CameraModel.DEFAULT.forSize(WIDTH, HEIGHT);
        double right = -marker.distanceMm() * Math.sin(marker.bearingRad());
        double ahead = marker.distanceMm() * Math.cos(marker.bearingRad());
        BufferedImage picture = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_3BYTE_BGR);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                double light = 0;
                for (int sample = 0; sample < SAMPLES * SAMPLES; sample++) {
                    double dx = (sample % SAMPLES + 0.5) / SAMPLES - 0.5;
                    double dy = (Math.floorDiv(sample, SAMPLES) + 0.5) / SAMPLES - 0.5;
                    double wallX = (x + dx - camera.centerX()) / camera.focalX() * ahead - right;
                    double wallY = (y + dy - camera.centerY()) / camera.focalY() * ahead - HEIGHT_DIFFERENCE_MM;
                    light += brightness(cells, wallX, wallY);
                }
                light = light / (SAMPLES * SAMPLES) + NOISE * random.nextGaussian();
                int gray = (int) Math.max(0, Math.min(255, light));
                picture.setRGB(x, y, gray << 16 | gray << 8 | gray);
            }
        }
        return picture;
    }

    private static double brightness(boolean[][] cells, double x, double y) {
        double cell = MarkerSpec.DEFAULT.sideMm() / 6;
        int column = (int) Math.floor(x / cell + 3);
        int row = (int) Math.floor(y / cell + 3);
        if (cells.length == 0 || column < -1 || row < -1 || column > 6 || row > 6) {
            return 110 + 20 * Math.sin(x / 90) + 20 * Math.cos(y / 130);
        }
        boolean border = column < 0 || row < 0 || column > 5 || row > 5;
        return border || cells[row][column] ? 210 : 30;
    }

    /** Blue, green, red, row by row. */
    public static byte[] pixels(BufferedImage picture) {
        return ((DataBufferByte) picture.getRaster().getDataBuffer()).getData();
    }

    public static byte[] jpeg(BufferedImage picture) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        try {
            ImageIO.write(picture, "jpg", file);
        } catch (IOException impossible) {
            throw new AssertionError(impossible);
        }
        return file.toByteArray();
    }

    /** Writes pictures of that name, numbered from 0. */
    public static void write(Path folder, String pattern, BufferedImage... pictures) throws IOException {
        for (int i = 0; i < pictures.length; i++) {
            String name = String.format(pattern, i);
            try (var out = Files.newOutputStream(folder.resolve(name))) {
                ImageIO.write(pictures[i], name.substring(name.lastIndexOf('.') + 1), out);
            }
        }
    }
}
