package org.evoloop.roomba.simulator.drawing;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;

/**
 * Draws a room seen from above, x to the right and y upwards: walls, obstacles, cliffs, the dock, the marker, the
 * robot's path coloured by cause, where it started, where it is and what its camera sees.
 *
 * <p>Threading: used by one thread.
 *
 * @since 0.1
 */
public final class RoomDrawing {
    private static final double LEGEND_LINES_PER_SIDE = 34;
    private static final double SMALLEST_SIDE_MM = 1_500;
    private static final double MARGIN_MM = Room.ROBOT_RADIUS_MM + 80;
    private static final double DOCK_DEPTH_MM = 90;
    private static final double SCALE_BAR_MM = 1_000;

    private static final double MARKER_DEPTH_MM = 60;

    /** The longest line of sight that is drawn; in an open room a camera sees farther. */
    private static final double SIGHT_MM = 4_000;

    private static final int SIGHT_RAYS = 120;

    private final RobotState state;
    private final Trail trail;
    private final double fieldOfViewDeg;
    private final Room room;
    private final StringBuilder text = new StringBuilder();

    private RoomDrawing(RobotState state, Trail trail, double fieldOfViewDeg) {
        this.state = state;
        this.trail = trail;
        this.fieldOfViewDeg = fieldOfViewDeg;
        this.room = state.surroundings().room();
    }

    /**
     * The drawing as an SVG document.
     *
     * @param state the robot's current state
     * @param trail the robot's path so far
     */
    public static String svg(RobotState state, Trail trail) {
        return svg(state, trail, 0);
    }

    /**
     * The drawing of a robot with a camera.
     *
     * @param fieldOfViewDeg the camera's field of view; 0 for no camera
     */
    public static String svg(RobotState state, Trail trail, double fieldOfViewDeg) {
        return new RoomDrawing(state, trail, fieldOfViewDeg).draw();
    }

    private String draw() {
        List<Trail.Piece> pieces = trail.pieces();
        List<Point> extent = new ArrayList<>();
        Stream.concat(
                        room.shapes().stream().flatMap(shape -> shape.corners().stream()),
                        pieces.stream().flatMap(piece -> piece.points().stream()))
                .forEach(extent::add);
        extent.add(state.pose().center());
        room.dock().ifPresent(dock -> extent.add(dock.ahead(Room.DOCK_DISTANCE_MM, 0)));
        room.marker().ifPresent(marker -> extent.add(marker.pose().center()));
        double left = extent.stream().mapToDouble(Point::xMm).min().orElse(0) - MARGIN_MM;
        double right =
                Math.max(extent.stream().mapToDouble(Point::xMm).max().orElse(0) + MARGIN_MM, left + SMALLEST_SIDE_MM);
        double bottom = extent.stream().mapToDouble(Point::yMm).min().orElse(0) - MARGIN_MM;
        double top = Math.max(
                extent.stream().mapToDouble(Point::yMm).max().orElse(0) + MARGIN_MM, bottom + SMALLEST_SIDE_MM);
        double letterMm = Math.max(right - left, top - bottom) / LEGEND_LINES_PER_SIDE;

        List<Cause> causes = pieces.stream()
                .filter(piece -> piece.points().size() > 1)
                .map(Trail.Piece::cause)
                .distinct()
                .sorted()
                .toList();
        double legendMm = letterMm * 1.6 * (causes.size() + 2.5);
        add(
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='%.0f %.0f %.0f %.0f' width='1000'"
                        + " font-family='sans-serif' font-size='%.0f' stroke-linejoin='round' stroke-linecap='round'>",
                left, -top, right - left, top - bottom + legendMm, letterMm);
        add("<rect x='%.0f' y='%.0f' width='100%%' height='100%%' fill='white'/>", left, -top);
        // SVG's y axis points down, the room's points up.
        add("<g transform='scale(1,-1)'>");
        drawSight();
        room.shapes().forEach(this::draw);
        room.dock().ifPresent(this::drawDock);
        room.marker().ifPresent(this::drawMarker);
        double lineMm = letterMm / 5;
        pieces.forEach(piece -> draw(piece, lineMm));
        drawStart(lineMm);
        drawRobot(state.pose(), lineMm);
        add("</g>");
        // The scale has a line of its own: the legend is as wide as the room, or wider.
        drawLegend(causes, left + letterMm, -bottom + letterMm * 3.2, letterMm);
        drawScaleBar(right - letterMm, -bottom + letterMm * 1.6, letterMm);
        add("</svg>");
        return text.toString();
    }

    private void draw(Shape shape) {
        String style = switch (shape.kind()) {
            case WALL -> "fill='none' stroke='#212529' stroke-width='24'";
            case OBSTACLE -> "fill='#adb5bd' stroke='#212529' stroke-width='12'";
            case CLIFF -> "fill='#ffe3e3' stroke='#e03131' stroke-width='10' stroke-dasharray='40 30'";
        };
        add("<polygon points='%s' %s/>", points(shape.corners()), style);
    }

    private void drawDock(Pose dock) {
        double nearMm = Room.DOCK_DISTANCE_MM;
        double widthMm = Room.DOCK_HALF_WIDTH_MM;
        add(
                "<polygon points='%s' fill='#1971c2' stroke='#0b3a66' stroke-width='10'/>",
                points(List.of(
                        dock.ahead(nearMm, widthMm),
                        dock.ahead(nearMm, -widthMm),
                        dock.ahead(nearMm + DOCK_DEPTH_MM, -widthMm),
                        dock.ahead(nearMm + DOCK_DEPTH_MM, widthMm))));
    }

    /** Draws a board, with an arrow in the direction it faces. */
    private void drawMarker(Marker marker) {
        Pose pose = marker.pose();
        double halfMm = marker.boardMm() / 2;
        add(
                "<polygon points='%s' fill='%s' stroke='#212529' stroke-width='10'/>",
                points(List.of(
                        pose.ahead(0, halfMm),
                        pose.ahead(0, -halfMm),
                        pose.ahead(MARKER_DEPTH_MM / 2, -halfMm),
                        pose.ahead(MARKER_DEPTH_MM * 2, 0),
                        pose.ahead(MARKER_DEPTH_MM / 2, halfMm))),
                marker.covered() ? "#868e96" : "#d6336c");
    }

    /** Draws the part of the floor that the camera sees, up to the walls. */
    private void drawSight() {
        if (fieldOfViewDeg == 0) {
            return;
        }
        Pose pose = state.pose();
        List<Point> outline = new ArrayList<>(List.of(pose.center()));
        for (int ray = 0; ray <= SIGHT_RAYS; ray++) {
            double bearingRad = Math.toRadians(fieldOfViewDeg) * ((double) ray / SIGHT_RAYS - 0.5);
            double lengthMm = Math.min(SIGHT_MM, room.freeMm(pose, bearingRad));
            outline.add(pose.ahead(lengthMm * Math.cos(bearingRad), lengthMm * Math.sin(bearingRad)));
        }
        add("<polygon class='sight' points='%s' fill='#74c0fc' fill-opacity='0.3'/>", points(outline));
    }

    private void draw(Trail.Piece piece, double lineMm) {
        add(
                "<polyline points='%s' fill='none' stroke='%s' stroke-width='%.0f' stroke-opacity='0.75'/>",
                points(piece.points()), piece.cause().color(), lineMm);
    }

    private void drawStart(double lineMm) {
        Pose start = trail.start();
        if (start != null) {
            add(
                    "<circle cx='%.0f' cy='%.0f' r='%.0f' fill='white' stroke='#212529' stroke-width='%.0f'/>",
                    start.xMm(), start.yMm(), lineMm * 2.5, lineMm);
        }
    }

    private void drawRobot(Pose pose, double lineMm) {
        Point front = pose.ahead(Room.ROBOT_RADIUS_MM, 0);
        add(
                "<circle cx='%.0f' cy='%.0f' r='%.0f' fill='#ffd43b' fill-opacity='0.55' stroke='#212529'"
                        + " stroke-width='%.0f'/>",
                pose.xMm(), pose.yMm(), Room.ROBOT_RADIUS_MM, lineMm);
        add(
                "<path d='M %.0f %.0f L %.0f %.0f' stroke='#212529' stroke-width='%.0f'/>",
                pose.xMm(), pose.yMm(), front.xMm(), front.yMm(), lineMm);
    }

    private void drawLegend(List<Cause> causes, double xMm, double yMm, double letterMm) {
        double lineMm = yMm;
        for (Cause cause : causes) {
            add(
                    "<path d='M %.0f %.0f h %.0f' stroke='%s' stroke-width='%.0f'/>",
                    xMm, lineMm - letterMm / 3, letterMm * 2, cause.color(), letterMm / 3);
            add("<text x='%.0f' y='%.0f'>%s</text>", xMm + letterMm * 2.8, lineMm, cause.label());
            lineMm += letterMm * 1.6;
        }
        add(
                "<text x='%.0f' y='%.0f'>white ring: start; yellow: the robot after %.0f s, battery %d %%</text>",
                xMm, lineMm, state.timeMillis() / 1000.0, state.batteryPercent());
    }

    private void drawScaleBar(double rightMm, double yMm, double letterMm) {
        add(
                "<path d='M %.0f %.0f h %.0f' stroke='#212529' stroke-width='%.0f'/>",
                rightMm - SCALE_BAR_MM, yMm, SCALE_BAR_MM, letterMm / 6);
        add("<text x='%.0f' y='%.0f' text-anchor='end'>1 m</text>", rightMm, yMm - letterMm / 3);
    }

    private static String points(List<Point> points) {
        return points.stream()
                .map(point -> String.format(Locale.ROOT, "%.0f,%.0f", point.xMm(), point.yMm()))
                .collect(Collectors.joining(" "));
    }

    private void add(String format, Object... values) {
        text.append(String.format(Locale.ROOT, format, values)).append('\n');
    }
}
