package org.evoloop.roomba.simulator.eye;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.evoloop.roomba.simulator.eye.Face.Patch;
import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;

/** All upright surfaces of a room, as faces. A seed chooses their look where the room does not specify it. */
final class Scene {
    private static final double WALL_MM = 2_500;
    private static final double LOWEST_FURNITURE_MM = 300;
    private static final double HIGHEST_FURNITURE_MM = 1_000;
    private static final double DOCK_MM = 130;
    private static final double POST_HALF_MM = 15;

    private static final int WHITE = 0xF4F4F4;
    private static final int BLACK = 0x141414;
    private static final int CARDBOARD = 0xA98B62;
    private static final int CLOTH = 0x6F7C8A;
    private static final int POST = 0x4D4D4D;

    /** The main direction of the light. */
    private static final double LIGHT_RAD = Math.toRadians(60);

    private final List<Face> faces = new ArrayList<>();
    private final SplittableRandom random;

    private Scene(long seed) {
        this.random = new SplittableRandom(seed);
    }

    static List<Face> of(Room room, long seed) {
        Scene scene = new Scene(seed);
        for (Shape shape : room.shapes()) {
            // Each shape has its own random source, so that the look does not change when a shape is added at the end.
            Decor decor = new Decor(scene.random.split());
            if (shape.kind() == Shape.Kind.WALL) {
                scene.addWalls(shape, decor);
            } else if (shape.kind() == Shape.Kind.OBSTACLE) {
                scene.addFurniture(shape, decor, scene.random.split());
            }
        }
        room.dock().ifPresent(scene::addDock);
        room.marker().ifPresent(scene::addMarker);
        return scene.faces;
    }

    private void addWalls(Shape shape, Decor decor) {
        double heightMm = shape.finish().heightMm().orElse(WALL_MM);
        int rgb = shape.finish().rgb().orElseGet(decor::wallpaper);
        for (Face side : sides(shape, -1, heightMm, rgb, true)) {
            List<Patch> patches = new Decor(random.split()).wall(side.lengthMm(), heightMm, rgb);
            add(new Face(side.left(), side.right(), 0, heightMm, rgb, patches, true, false));
        }
    }

    private void addFurniture(Shape shape, Decor decor, SplittableRandom own) {
        double heightMm = shape.finish()
                .heightMm()
                .orElse(LOWEST_FURNITURE_MM + own.nextDouble() * (HIGHEST_FURNITURE_MM - LOWEST_FURNITURE_MM));
        int rgb = shape.finish().rgb().orElseGet(decor::vivid);
        int style = own.nextInt(Decor.styles());
        for (Face side : sides(shape, 1, heightMm, rgb, false)) {
            List<Patch> patches = new Decor(own.split()).furniture(side.lengthMm(), heightMm, rgb, style);
            add(new Face(side.left(), side.right(), 0, heightMm, rgb, patches, false, false));
        }
    }

    /** Undecorated faces; their fronts are outside if {@code outward} is 1, inside if it is -1. */
    private static List<Face> sides(Shape shape, int outward, double heightMm, int rgb, boolean bothSides) {
        List<Point> corners = shape.corners();
        double doubleArea = 0;
        for (int i = 0; i < corners.size(); i++) {
            Point next = corners.get((i + 1) % corners.size());
            doubleArea += corners.get(i).xMm() * next.yMm()
                    - next.xMm() * corners.get(i).yMm();
        }
        boolean forward = doubleArea * outward > 0;
        List<Face> sides = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            Point one = corners.get(i);
            Point other = corners.get((i + 1) % corners.size());
            sides.add(new Face(
                    forward ? one : other, forward ? other : one, 0, heightMm, rgb, List.of(), bothSides, false));
        }
        return sides;
    }

    private void addDock(Pose dock) {
        Point left = dock.ahead(Room.DOCK_DISTANCE_MM, Room.DOCK_HALF_WIDTH_MM);
        Point right = dock.ahead(Room.DOCK_DISTANCE_MM, -Room.DOCK_HALF_WIDTH_MM);
        List<Patch> label = List.of(new Patch(50, 90, 60, 100, WHITE, BLACK));
        faces.add(new Face(left, right, 0, DOCK_MM, BLACK, label, true, true));
    }

    private void addMarker(Marker marker) {
        double halfMm = marker.boardMm() / 2;
        double bottomMm = marker.heightMm() - halfMm;
        double topMm = marker.heightMm() + halfMm;
        // Seen from the front, the marker's right side is on the left.
        Point left = marker.pose().ahead(0, -halfMm);
        Point right = marker.pose().ahead(0, halfMm);
        if (bottomMm > 0) {
            Point postLeft = marker.pose().ahead(0, -POST_HALF_MM);
            Point postRight = marker.pose().ahead(0, POST_HALF_MM);
            faces.add(new Face(postLeft, postRight, 0, bottomMm, POST, List.of(), true, true));
        }
        if (marker.covered()) {
            faces.add(new Face(left, right, bottomMm, topMm, CLOTH, List.of(), true, true));
            return;
        }
        faces.add(new Face(left, right, bottomMm, topMm, WHITE, tag(marker, topMm), false, true));
        faces.add(new Face(right, left, bottomMm, topMm, CARDBOARD, List.of(), false, true));
    }

    private static List<Patch> tag(Marker marker, double topMm) {
        double cellMm = marker.cellMm();
        double sideMm = marker.sideMm();
        List<Patch> patches = new ArrayList<>();
        patches.add(new Patch(cellMm, cellMm + sideMm, topMm - cellMm - sideMm, topMm - cellMm, BLACK, WHITE));
        for (int row = 0; row < TagCode.CELLS; row++) {
            for (int column = 0; column < TagCode.CELLS; column++) {
                if (TagCode.isWhite(marker.id(), row, column)) {
                    double fromMm = (column + 2) * cellMm;
                    double highMm = topMm - (row + 2) * cellMm;
                    patches.add(new Patch(fromMm, fromMm + cellMm, highMm - cellMm, highMm, WHITE, BLACK));
                }
            }
        }
        return patches;
    }

    private void add(Face face) {
        double frontRad = Math.atan2(
                face.left().xMm() - face.right().xMm(),
                face.right().yMm() - face.left().yMm());
        faces.add(face.shaded(0.86 + 0.14 * Math.cos(frontRad - LIGHT_RAD)));
    }
}
