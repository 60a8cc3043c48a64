package org.evoloop.roomba.simulator.eye;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;

/**
 * A pinhole camera above the robot's centre that looks straight ahead and level. What is {@code a} mm ahead of the
 * robot's centre, {@code l} mm to its left and {@code h} mm above the floor is in the picture, counted from the outer
 * corner of its top left pixel, at
 *
 * <pre>
 *   x = widthPx / 2 - focalPx * l / a        y = heightPx / 2 + focalPx * (heightMm - h) / a
 * </pre>
 *
 * <p>Edges are exact to a small part of a pixel. Tops of furniture are never visible, shadows are only
 * approximate, and the robot itself is not in the picture.
 *
 * <p>Threading: used by one thread; its buffers are reused, and only the picture is new each time.
 *
 * @since 0.1
 */
public final class Eye {
    private static final int CEILING = 0xE9E7E2;
    private static final int ZENITH = 0x7FB2E5;
    private static final int HORIZON = 0xDCE9F2;

    /** How far the shadow in front of furniture reaches. */
    private static final double SHADOW_MM = 90;

    private final EyeOptions options;
    private final int width;
    private final int height;
    private final double focalPx;
    private final long[] pixels;
    private final Column column;
    private final Film film;
    private final Floor floor;
    private final double[] floorMm;
    private final int[] floorLevel;
    private final long[] sky;

    private Room room = Room.OPEN;
    private List<FaceView> faces = List.of();
    private Cliffs cliffs = new Cliffs(List.of());
    private boolean indoors;
    private FaceView[] seen = {};
    private FaceView[] nearestFirst = {};
    private double[] order = {};
    private double[] nearness = {};
    private int[] endRow = {};

    /** A camera with these options. */
    public Eye(EyeOptions options) {
        this.options = options;
        width = options.widthPx();
        height = options.heightPx();
        focalPx = options.focalPx();
        pixels = new long[width * height];
        column = new Column(pixels, height, options.heightMm(), focalPx);
        film = new Film(options);
        floor = new Floor(new SplittableRandom(options.seed()));
        floorMm = new double[height];
        floorLevel = new int[height];
        sky = new long[height];
        for (int row = 0; row < height; row++) {
            double below = row + 0.5 - height / 2.0;
            floorMm[row] = below > 0 ? options.heightMm() * focalPx / below : Double.POSITIVE_INFINITY;
            double acrossMm = floorMm[row] / focalPx;
            double alongMm = floorMm[row] * floorMm[row] / (focalPx * options.heightMm());
            floorLevel[row] = below > 0 ? floor.level(Math.sqrt(acrossMm * alongMm)) : 0;
            sky[row] = Rgb.of(Rgb.mixed(ZENITH, HORIZON, Math.min(1, 2.0 * row / height))) * Rgb.ONE;
        }
    }

    /**
     * Renders what the camera sees.
     *
     * @param turnRadPerS the robot's turning rate, for motion blur
     * @param frameNumber selects the noise
     */
    public CameraImage render(Room where, Pose pose, double turnRadPerS, long frameNumber) {
        enter(where);
        int count = 0;
        for (FaceView face : faces) {
            if (face.isSeen(pose, focalPx, width)) {
                seen[count++] = face;
            }
        }
        cliffs.lookFrom(pose);
        for (int x = 0; x < width; x++) {
            column.moveTo(x);
            paint(x, pose, count);
        }
        return new CameraImage(width, height, film.develop(pixels, turnRadPerS, frameNumber));
    }

    private void enter(Room where) {
        if (where == room) {
            return;
        }
        room = where;
        faces = new ArrayList<>();
        Scene.of(room, options.seed()).forEach(face -> faces.add(new FaceView(face)));
        cliffs = Cliffs.of(room);
        indoors = !room.isOpen();
        seen = new FaceView[faces.size()];
        nearestFirst = new FaceView[faces.size()];
        order = new double[faces.size()];
        nearness = new double[faces.size()];
        endRow = new int[faces.size()];
    }

    private void paint(int x, Pose pose, int seenCount) {
        int count = sort(x, seenCount);
        int skyEnd = height;
        double foot = height / 2.0;
        double footNearness = 0;
        int drawn = 0;
        for (int i = 0; i < count && skyEnd > 0; i++) {
            FaceView face = nearestFirst[i];
            double top = column.row(face.topMm(), nearness[i]);
            if (top < skyEnd) {
                nearestFirst[drawn] = face;
                nearness[drawn] = nearness[i];
                endRow[drawn++] = skyEnd;
            }
            if (face.hidesFloor(options.heightMm()) && face.weight(x) == Rgb.ONE) {
                skyEnd = Math.min(skyEnd, (int) Math.ceil(top));
                if (footNearness == 0) {
                    footNearness = nearness[i];
                    foot = column.row(0, footNearness);
                }
            }
        }
        paintSky(Math.min(skyEnd + 1, height / 2 + 1));
        double aside = (width / 2.0 - x - 0.5) / focalPx;
        paintFloor((int) foot, pose, aside);
        cliffs.paint(column, aside, height);
        if (footNearness > 0 && 1 / footNearness > 2 * SHADOW_MM) {
            column.shade(foot, column.row(0, 1 / (1 / footNearness - SHADOW_MM)));
        }
        for (int i = drawn - 1; i >= 0; i--) {
            nearestFirst[i].paint(column, x, nearness[i], endRow[i]);
        }
    }

    /** Collects the faces of a column, nearest first, and returns their number. */
    private int sort(int x, int seenCount) {
        int count = 0;
        for (int i = 0; i < seenCount; i++) {
            FaceView face = seen[i];
            if (!face.covers(x)) {
                continue;
            }
            double near = face.nearness(x);
            double key = face.drawnOver(near);
            int at = count++;
            for (; at > 0 && order[at - 1] < key; at--) {
                order[at] = order[at - 1];
                nearness[at] = nearness[at - 1];
                nearestFirst[at] = nearestFirst[at - 1];
            }
            order[at] = key;
            nearness[at] = near;
            nearestFirst[at] = face;
        }
        return count;
    }

    private void paintSky(int end) {
        long ceiling = Rgb.of(CEILING) * Rgb.ONE;
        for (int row = 0; row < Math.min(end, height); row++) {
            column.set(row, indoors ? ceiling : sky[row]);
        }
    }

    private void paintFloor(int from, Pose pose, double aside) {
        double cos = Math.cos(pose.headingRad());
        double sin = Math.sin(pose.headingRad());
        double perXMm = cos - aside * sin;
        double perYMm = sin + aside * cos;
        for (int row = Math.max(from, height / 2); row < height; row++) {
            double ahead = floorMm[row];
            column.set(
                    row,
                    ahead < Double.POSITIVE_INFINITY
                            ? floor.at(pose.xMm() + ahead * perXMm, pose.yMm() + ahead * perYMm, floorLevel[row])
                            : sky[row]);
        }
    }
}
