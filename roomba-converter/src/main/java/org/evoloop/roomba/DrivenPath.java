package org.evoloop.roomba;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.page.Picture;
import org.evoloop.roomba.session.OdometryPose;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.svg.Svg;
import org.jspecify.annotations.Nullable;

/**
 * The path that a real robot has driven, from its wheel encoders (dead reckoning): seen from above, with the robot's
 * heading at the start of the session pointing up. A long path is stored with fewer points, but in full length.
 *
 * <p>Threading: thread-safe.
 */
final class DrivenPath implements SessionListener {
    private static final int MOST_POINTS = 4_000;
    private static final double FIRST_STEP_MM = 20;
    private static final double SIDE_PIXELS = 600;
    private static final double SMALLEST_SIDE_MM = 1_500;
    private static final double RADIUS_MM = 170;
    private static final double MARGIN_MM = RADIUS_MM + 80;
    private static final double BAR_MM = 500;
    private static final double FONT_PIXELS = 14;
    private static final String STYLE = """
            .way { fill: none; stroke: #1971c2; stroke-width: 3; stroke-linejoin: round }
            .robot { fill: #d0ebff; stroke: #0b3a66; stroke-width: 2 }
            .bar { fill: none; stroke: #212529; stroke-width: 2 }
            .start { fill: #2f9e44 }
            .small { fill: #212529 }
            """;

    private final List<OdometryPose> points = new ArrayList<>();
    private double stepMm = FIRST_STEP_MM;
    private @Nullable OdometryPose now;

    /** The path of a robot that has not reported yet. */
    DrivenPath() {}

    /** The path of this session's robot from now on, as a picture for the web page. */
    static Picture of(RoombaSession session) {
        DrivenPath way = new DrivenPath();
        session.addListener(way);
        return new Picture(
                "Path",
                "The robot's path and position from above, by its wheels' odometry; errors add up with the distance",
                "image/svg+xml",
                () -> Picture.View.of(way.svg(session.isUp()).getBytes(StandardCharsets.UTF_8)));
    }

    @Override
    public synchronized void received(Telemetry telemetry) {
        OdometryPose pose = telemetry.pose();
        now = pose;
        OdometryPose last = points.isEmpty() ? null : points.get(points.size() - 1);
        if (last != null && last.distanceTo(pose.xMm(), pose.yMm()) < stepMm) {
            return;
        }
        points.add(pose);
        if (points.size() > MOST_POINTS) {
            stepMm *= 2;
            List<OdometryPose> fewer = new ArrayList<>();
            for (int index = 0; index < points.size(); index += 2) {
                fewer.add(points.get(index));
            }
            points.clear();
            points.addAll(fewer);
        }
    }

    /** The current picture; empty before the robot has reported. */
    synchronized String svg(boolean reachable) {
        OdometryPose robot = now;
        return robot == null ? "" : new Sheet(robot).draw(reachable);
    }

    /** Maps the robot's millimetres to the picture's pixels. */
    private final class Sheet {
        private final OdometryPose robot;
        private final double leftMm;
        private final double topMm;
        private final double widthMm;
        private final double heightMm;
        private final double scale;

        Sheet(OdometryPose robot) {
            this.robot = robot;
            List<OdometryPose> all = new ArrayList<>(points);
            all.add(robot);
            double right = all.stream().mapToDouble(OdometryPose::yMm).min().orElse(0) - MARGIN_MM;
            double bottom = all.stream().mapToDouble(OdometryPose::xMm).min().orElse(0) - MARGIN_MM;
            leftMm = Math.max(
                    all.stream().mapToDouble(OdometryPose::yMm).max().orElse(0) + MARGIN_MM, right + SMALLEST_SIDE_MM);
            topMm = Math.max(
                    all.stream().mapToDouble(OdometryPose::xMm).max().orElse(0) + MARGIN_MM, bottom + SMALLEST_SIDE_MM);
            widthMm = leftMm - right;
            heightMm = topMm - bottom;
            scale = SIDE_PIXELS / Math.max(widthMm, heightMm);
        }

        private double across(double yMm) {
            return (leftMm - yMm) * scale;
        }

        private double down(double xMm) {
            return (topMm - xMm) * scale;
        }

        private String draw(boolean reachable) {
            double height = heightMm * scale;
            Svg svg = new Svg("The way driven", widthMm * scale, height + 2 * FONT_PIXELS, FONT_PIXELS, STYLE, "");
            StringBuilder way = new StringBuilder("M");
            for (OdometryPose point : points) {
                way.append(way.length() > 1 ? " L" : "").append(Svg.pair(across(point.yMm()), down(point.xMm())));
            }
            way.append(" L").append(Svg.pair(across(robot.yMm()), down(robot.xMm())));
            svg.path("way", way.toString());
            svg.circle("start", across(points.get(0).yMm()), down(points.get(0).xMm()), FONT_PIXELS / 3);
            OdometryPose nose = robot.beyond(RADIUS_MM, 0);
            svg.circle("robot", across(robot.yMm()), down(robot.xMm()), RADIUS_MM * scale);
            svg.line("bar", across(robot.yMm()), down(robot.xMm()), across(nose.yMm()), down(nose.xMm()));
            svg.path("bar", "M" + Svg.pair(FONT_PIXELS, height) + " h" + Math.round(BAR_MM * scale));
            svg.text("small", FONT_PIXELS, height + FONT_PIXELS, "0.5 m");
            if (!reachable) {
                svg.text("small", FONT_PIXELS, FONT_PIXELS * 1.5, "out of reach: where it was last");
            }
            return svg.toString();
        }
    }
}
