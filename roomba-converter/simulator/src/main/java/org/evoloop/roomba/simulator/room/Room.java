package org.evoloop.roomba.simulator.room;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * The robot's surroundings: lengths in mm, angles counterclockwise from the x axis.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Room {
    /** An endless plain without a dock; the robot starts at the origin. */
    public static final Room OPEN = new Room(List.of(), null, Pose.ORIGIN, null);

    /** The radius of the robot's body. */
    public static final double ROBOT_RADIUS_MM = 170;

    /** From the centre of a docked robot to the dock's upright part, almost touching the bumper. */
    public static final double DOCK_DISTANCE_MM = ROBOT_RADIUS_MM + 6;

    /** Half the width of the dock's upright part. */
    public static final double DOCK_HALF_WIDTH_MM = 70;

    /** The range of the dock's beams. */
    private static final double DOCK_RANGE_MM = 3_000;

    /** How far to either side of its front the dock's beams reach. */
    private static final double DOCK_BEAM_RAD = Math.toRadians(50);

    /** In a corner, a disc is pushed back and forth between two walls; this many times are enough. */
    private static final int MOST_PUSHES = 12;

    private static final double TOUCH_MM = 1e-6;

    private final List<Shape> shapes;
    private final @Nullable Pose dock;
    private final Pose start;
    private final @Nullable Marker marker;
    private final List<Shape> cliffs;
    private final List<Segment> walls;

    private Room(List<Shape> shapes, @Nullable Pose dock, Pose start, @Nullable Marker marker) {
        this.shapes = List.copyOf(shapes);
        this.dock = dock;
        this.start = start;
        this.marker = marker;
        this.cliffs = shapes.stream()
                .filter(shape -> shape.kind() == Shape.Kind.CLIFF)
                .toList();
        List<Segment> solid = new ArrayList<>();
        shapes.stream().filter(shape -> shape.kind() != Shape.Kind.CLIFF).forEach(shape -> solid.addAll(shape.sides()));
        if (dock != null) {
            solid.add(uprightOf(dock));
        }
        if (marker != null && marker.solid()) {
            solid.add(marker.board());
        }
        this.walls = List.copyOf(solid);
    }

    /**
     * A room.
     *
     * @param dock the pose of a docked robot, facing the dock; null for no dock
     * @param start where the robot starts
     * @throws IllegalArgumentException if the robot cannot stand at its start
     */
    public static Room of(List<Shape> shapes, @Nullable Pose dock, Pose start) {
        return of(shapes, dock, start, null);
    }

    /**
     * A room with a marker, as {@link #of(List, Pose, Pose)}.
     *
     * @param marker null for none
     */
    public static Room of(List<Shape> shapes, @Nullable Pose dock, Pose start, @Nullable Marker marker) {
        Room room = new Room(shapes, dock, start, marker);
        if (!room.isFree(start)) {
            throw new IllegalArgumentException("the robot cannot start at " + start.describe()
                    + ": something solid or a cliff is within " + (int) ROBOT_RADIUS_MM + " mm");
        }
        return room;
    }

    private static Segment uprightOf(Pose dock) {
        return new Segment(
                dock.ahead(DOCK_DISTANCE_MM, DOCK_HALF_WIDTH_MM), dock.ahead(DOCK_DISTANCE_MM, -DOCK_HALF_WIDTH_MM));
    }

    /** A copy with other shapes; the robot's start is not checked. */
    Room withShapes(List<Shape> others) {
        return new Room(others, dock, start, marker);
    }

    /** A copy with its only dock elsewhere. */
    public Room withDock(Pose place) {
        return new Room(shapes, place, start, marker);
    }

    /** A copy with this as its only marker; null for none. */
    public Room withMarker(@Nullable Marker other) {
        return new Room(shapes, dock, start, other);
    }

    /** The tag that marks the starting point for robots with a camera. */
    public Optional<Marker> marker() {
        return Optional.ofNullable(marker);
    }

    /** The shapes in it, in the order of its file. */
    public List<Shape> shapes() {
        return shapes;
    }

    /** The pose of a docked robot; empty if there is no dock. */
    public Optional<Pose> dock() {
        return Optional.ofNullable(dock);
    }

    /** Where the robot starts. */
    public Pose start() {
        return start;
    }

    /** Whether nothing can stop the robot when it drives straight on. */
    public boolean isOpen() {
        return shapes.isEmpty();
    }

    /** Whether there is no floor at this point. */
    public boolean isCliff(Point point) {
        return cliffs.stream().anyMatch(cliff -> cliff.contains(point));
    }

    /** Whether a robot can be placed here: it touches nothing, and there is floor under its centre. */
    public boolean isFree(Pose pose) {
        Point center = pose.center();
        boolean inside = shapes.stream().anyMatch(shape -> shape.kind() != Shape.Kind.WALL && shape.contains(center));
        return !inside && nearestWalls(center).allMatch(point -> pose.distanceMmTo(point) >= ROBOT_RADIUS_MM);
    }

    private Stream<Point> nearestWalls(Point center) {
        return walls.stream().map(wall -> wall.nearest(center));
    }

    /** The points of walls within this distance of the robot's body. */
    public List<Point> touched(Pose pose, double withinMm) {
        return nearestWalls(pose.center())
                .filter(point -> pose.distanceMmTo(point) <= ROBOT_RADIUS_MM + withinMm)
                .toList();
    }

    /**
     * Where a robot gets that tries to move from one pose to another near it: there, or as far as it can slide along
     * walls.
     */
    public Pose moved(Pose from, Pose to) {
        Pose pushed = to;
        for (int push = 0; push < MOST_PUSHES; push++) {
            Pose now = pushed;
            Point wall = nearestWalls(now.center())
                    .filter(point -> now.distanceMmTo(point) < ROBOT_RADIUS_MM - TOUCH_MM)
                    .findFirst()
                    .orElse(null);
            if (wall == null) {
                return now;
            }
            double distanceMm = Math.max(TOUCH_MM, now.distanceMmTo(wall));
            Point away = now.center().minus(wall);
            pushed = now.at(wall.plus(away, ROBOT_RADIUS_MM / distanceMm));
        }
        return to.at(from.center());
    }

    /** The distance from the robot's centre to the next wall in a direction; infinite if there is none. */
    public double freeMm(Pose pose, double bearingRad) {
        double directionRad = pose.headingRad() + bearingRad;
        Point direction = new Point(Math.cos(directionRad), Math.sin(directionRad));
        Point origin = pose.center();
        return walls.stream()
                .mapToDouble(wall -> wall.hitBy(origin, direction))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }

    /** Whether the dock's beams reach a robot: it is in front of the dock and nothing is in between. */
    public boolean seesDock(Pose pose) {
        if (dock == null) {
            return false;
        }
        Point upright = dock.ahead(DOCK_DISTANCE_MM, 0);
        double distanceMm = pose.distanceMmTo(upright);
        double asideRad = dock.bearingRadTo(pose.xMm(), pose.yMm());
        boolean inFront = pose.distanceMmTo(dock.center()) < ROBOT_RADIUS_MM
                || Math.abs(Math.abs(asideRad) - Math.PI) < DOCK_BEAM_RAD;
        return inFront
                && distanceMm < DOCK_RANGE_MM
                && freeMm(pose, pose.bearingRadTo(upright.xMm(), upright.yMm())) > distanceMm - 1;
    }
}
