package org.evoloop.roomba.simulator.room;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Random rooms: 4 to 6 m wide and long, with 3 to 8 pieces of furniture in many colours, a robot at a random pose, and
 * a marker on a wall or a stand. The same seed gives the same room.
 *
 * <p>Threading: used by one thread.
 *
 * @since 0.1
 */
public final class RandomRooms {
    /** How far in front of the marker the robot should stop. */
    public static final double GOAL_MM = 400;

    /** The least distance from the marker at which the robot starts. */
    public static final double NEAREST_MARKER_MM = 500;
    /** The greatest distance from the marker at which the robot starts. */
    public static final double FARTHEST_MARKER_MM = 3_500;

    private static final int[] COLORS = {
        0xC92A2A, 0x1971C2, 0x2F9E44, 0xE8590C, 0x9C36B5, 0x0C8599, 0xF2C037, 0xD6336C, 0x3B3B45, 0x8A5A33, 0xD9D5CC
    };

    /** The least distance between the robot at its goal and anything else. */
    private static final double GOAL_CLEARANCE_MM = 60;

    /** The least distance between the robot on its way and anything else. */
    private static final double WAY_CLEARANCE_MM = 40;

    /** Seen from further to the side than this, a marker is too narrow at a distance. */
    private static final double MOST_ASIDE_RAD = Math.toRadians(50);

    /**
     * The least distance of furniture from the lines between the start and the board's edges: the camera turns about
     * the robot's centre.
     */
    private static final double SIGHT_CLEARANCE_MM = 100;

    /** The free space around a stand. */
    private static final double STAND_CLEARANCE_MM = 250;

    private static final double GRID_MM = 100;
    private static final double TOUCH_MM = 1;
    private static final int TRIES = 60;

    private record Cell(int x, int y) {}

    private final SplittableRandom random;
    private final double widthMm;
    private final double lengthMm;

    private RandomRooms(SplittableRandom random) {
        this.random = random;
        widthMm = between(4_000, 6_000);
        lengthMm = between(4_000, 6_000);
    }

    /** A room with a marker {@value #NEAREST_MARKER_MM} to {@value #FARTHEST_MARKER_MM} mm from the robot. */
    public static Room withMarker(long seed) {
        return withMarker(seed, NEAREST_MARKER_MM, FARTHEST_MARKER_MM);
    }

    /**
     * A room with a marker at such a distance from the robot that is visible from the start: no furniture is in
     * between, and the start is at most 50 degrees off the marker's axis. The robot's heading is random, so it may have
     * to turn first. {@value #GOAL_MM} mm in front of the marker, on the way from the start and straight in front of
     * it, there is room for the robot, and it can get there; but furniture may be close to the way.
     */
    public static Room withMarker(long seed, double nearestMm, double farthestMm) {
        if (!(nearestMm >= NEAREST_MARKER_MM && nearestMm < farthestMm && farthestMm <= FARTHEST_MARKER_MM)) {
            throw new IllegalArgumentException("the marker is " + nearestMm + " to " + farthestMm
                    + " mm away; allowed is " + NEAREST_MARKER_MM + " to " + FARTHEST_MARKER_MM);
        }
        SplittableRandom random = new SplittableRandom(seed);
        while (true) {
            RandomRooms rooms = new RandomRooms(random.split());
            Room room = rooms.withRobot(rooms.furnished());
            Room marked = room == null ? null : rooms.marked(room, nearestMm, farthestMm);
            if (marked != null) {
                return marked;
            }
        }
    }

    /** A room without a marker. */
    public static Room withoutMarker(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        while (true) {
            RandomRooms rooms = new RandomRooms(random.split());
            Room room = rooms.withRobot(rooms.furnished());
            if (room != null) {
                return room;
            }
        }
    }

    private double between(double least, double most) {
        return least + random.nextDouble() * (most - least);
    }

    private double anyHeadingRad() {
        return between(-Math.PI, Math.PI);
    }

    private List<Shape> furnished() {
        List<Shape> shapes = new ArrayList<>();
        shapes.add(new Shape(Shape.Kind.WALL, Shape.rectangle(new Point(0, 0), new Point(widthMm, lengthMm))));
        int pieces = random.nextInt(3, 9);
        for (int tries = 0; shapes.size() <= pieces && tries < TRIES; tries++) {
            Shape piece = piece();
            if (shapes.stream().skip(1).noneMatch(other -> overlap(piece, other))) {
                shapes.add(piece);
            }
        }
        return shapes;
    }

    /** A piece of furniture along a wall, or anywhere at any angle. */
    private Shape piece() {
        double halfWidthMm = between(150, 600);
        double halfDepthMm = between(120, 300);
        boolean free = random.nextInt(3) == 0;
        Pose middle = switch (free ? 4 : random.nextInt(4)) {
            case 0 -> new Pose(between(halfWidthMm, widthMm - halfWidthMm), halfDepthMm, Math.PI / 2);
            case 1 -> new Pose(between(halfWidthMm, widthMm - halfWidthMm), lengthMm - halfDepthMm, -Math.PI / 2);
            case 2 -> new Pose(halfDepthMm, between(halfWidthMm, lengthMm - halfWidthMm), 0);
            case 3 -> new Pose(widthMm - halfDepthMm, between(halfWidthMm, lengthMm - halfWidthMm), Math.PI);
            default -> new Pose(between(900, widthMm - 900), between(900, lengthMm - 900), anyHeadingRad());
        };
        Finish finish = new Finish(
                OptionalInt.of(COLORS[random.nextInt(COLORS.length)]),
                OptionalDouble.of(Math.rint(between(300, 1_000))));
        return new Shape(
                Shape.Kind.OBSTACLE,
                List.of(
                        middle.ahead(halfDepthMm, halfWidthMm),
                        middle.ahead(-halfDepthMm, halfWidthMm),
                        middle.ahead(-halfDepthMm, -halfWidthMm),
                        middle.ahead(halfDepthMm, -halfWidthMm)),
                finish);
    }

    private static boolean overlap(Shape one, Shape other) {
        return one.sides().stream().anyMatch(side -> other.sides().stream().anyMatch(side::crosses))
                || other.contains(one.corners().get(0))
                || one.contains(other.corners().get(0));
    }

    /** The room with a robot in it; null if no place was found. */
    private @Nullable Room withRobot(List<Shape> shapes) {
        Room furnished = Room.OPEN.withShapes(shapes);
        for (int tries = 0; tries < TRIES; tries++) {
            Pose start = new Pose(between(0, widthMm), between(0, lengthMm), anyHeadingRad());
            if (hasSpace(furnished, start, WAY_CLEARANCE_MM)) {
                return Room.of(shapes, null, start);
            }
        }
        return null;
    }

    private boolean hasSpace(Room room, Pose pose, double clearanceMm) {
        boolean inside = pose.xMm() > 0 && pose.xMm() < widthMm && pose.yMm() > 0 && pose.yMm() < lengthMm;
        return inside && room.touched(pose, clearanceMm).isEmpty() && room.isFree(pose);
    }

    private @Nullable Room marked(Room room, double nearestMm, double farthestMm) {
        Set<Cell> reached = reached(room);
        for (int tries = 0; tries < TRIES; tries++) {
            Marker marker = Marker.at(random.nextBoolean() ? onWall() : onStand());
            double awayMm = room.start().distanceMmTo(marker.pose().center());
            if (awayMm >= nearestMm
                    && awayMm <= farthestMm
                    && isOpenAround(room, marker)
                    && isSeen(room, marker)
                    && Stream.of(marker.before(GOAL_MM), onTheWay(room, marker))
                            .allMatch(goal -> isGoal(room, goal) && reached.contains(cell(room, goal)))) {
                return room.withMarker(marker);
            }
        }
        return null;
    }

    /** Whether the robot can see the marker from its start after turning towards it. */
    private static boolean isSeen(Room room, Marker marker) {
        Point start = room.start().center();
        double halfMm = marker.boardMm() / 2 + SIGHT_CLEARANCE_MM;
        Shape sight = new Shape(
                Shape.Kind.OBSTACLE,
                List.of(
                        start,
                        marker.pose().ahead(TOUCH_MM, halfMm),
                        marker.pose().ahead(TOUCH_MM, -halfMm)));
        return Math.abs(marker.pose().bearingRadTo(start.xMm(), start.yMm())) <= MOST_ASIDE_RAD
                && room.shapes().stream()
                        .filter(shape -> shape.kind() == Shape.Kind.OBSTACLE)
                        .noneMatch(piece -> overlap(sight, piece));
    }

    /** Where the robot stops when it drives straight from the start to the marker. */
    private static Pose onTheWay(Room room, Marker marker) {
        Pose place = marker.pose();
        double bearingRad = place.bearingRadTo(room.start().xMm(), room.start().yMm());
        return marker.movedTo(new Pose(place.xMm(), place.yMm(), place.headingRad() + bearingRad))
                .before(GOAL_MM);
    }

    private boolean isGoal(Room room, Pose goal) {
        return hasSpace(room, goal, GOAL_CLEARANCE_MM) && room.freeMm(goal, 0) > GOAL_MM - TOUCH_MM;
    }

    private Pose onWall() {
        return switch (random.nextInt(4)) {
            case 0 -> new Pose(between(0, widthMm), 0, Math.PI / 2);
            case 1 -> new Pose(between(0, widthMm), lengthMm, -Math.PI / 2);
            case 2 -> new Pose(0, between(0, lengthMm), 0);
            default -> new Pose(widthMm, between(0, lengthMm), Math.PI);
        };
    }

    private Pose onStand() {
        return new Pose(between(0, widthMm), between(0, lengthMm), anyHeadingRad());
    }

    /** A stand needs free space; on a wall, the board must not be behind furniture. */
    private static boolean isOpenAround(Room room, Marker marker) {
        Pose front = marker.before(TOUCH_MM);
        double halfMm = marker.boardMm() / 2;
        boolean edgesFree = room.freeMm(front, Math.PI / 2) > halfMm && room.freeMm(front, -Math.PI / 2) > halfMm;
        boolean onWall = room.freeMm(front, 0) <= 2 * TOUCH_MM;
        return edgesFree
                && (onWall
                        || (room.isFree(front)
                                && room.touched(front, STAND_CLEARANCE_MM).isEmpty()));
    }

    /** The cells of the floor that the robot can reach from its start. */
    private Set<Cell> reached(Room room) {
        Set<Cell> reached = new HashSet<>(Set.of(new Cell(0, 0)));
        Deque<Cell> next = new ArrayDeque<>(reached);
        while (!next.isEmpty()) {
            Cell at = next.remove();
            for (Cell beside : List.of(
                    new Cell(at.x + 1, at.y),
                    new Cell(at.x - 1, at.y),
                    new Cell(at.x, at.y + 1),
                    new Cell(at.x, at.y - 1))) {
                Point middle = new Point(
                        room.start().xMm() + beside.x * GRID_MM, room.start().yMm() + beside.y * GRID_MM);
                if (!reached.contains(beside) && hasSpace(room, room.start().at(middle), WAY_CLEARANCE_MM)) {
                    reached.add(beside);
                    next.add(beside);
                }
            }
        }
        return reached;
    }

    private static Cell cell(Room room, Pose pose) {
        return new Cell((int) Math.rint((pose.xMm() - room.start().xMm()) / GRID_MM), (int)
                Math.rint((pose.yMm() - room.start().yMm()) / GRID_MM));
    }
}
