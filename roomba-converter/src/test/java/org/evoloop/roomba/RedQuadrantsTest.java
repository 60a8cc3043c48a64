package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.LongStream;
import org.evoloop.roomba.simulator.eye.CameraImage;
import org.evoloop.roomba.simulator.eye.Effects;
import org.evoloop.roomba.simulator.eye.Eye;
import org.evoloop.roomba.simulator.eye.EyeOptions;
import org.evoloop.roomba.simulator.room.Finish;
import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.RandomRooms;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * The paper's method of finding the starting point, for comparison: count the red pixels in the picture's quadrants,
 * turn to the side with more, drive forward when both are about equal, stop when there are enough. A red board of the
 * marker's size replaces the marker; its pixels always count as red. The wheels are ideal, furniture stops the robot
 * without damage, and there is no other obstacle handling.
 */
class RedQuadrantsTest {
    private static final double GOAL_MM = RandomRooms.GOAL_MM;
    private static final int ROOMS = 50;

    /** The share of the picture that a board of 200 mm covers from the goal: 139 by 139 of 320 by 240 pixels. */
    private static final double ENOUGH = 0.25;

    private static final double LIMIT_S = 180;
    private static final double FRAME_S = 0.1;
    private static final double SPEED_MM_PER_S = 85;
    private static final double TURN_RAD_PER_S = 0.3;

    /** Less red than this share of the picture is noise; the board covers twice as much from the farthest start. */
    private static final double LEAST_SHARE = 0.001;

    /** The sides are balanced when they differ by less than this share of all red. */
    private static final double BALANCE = 0.2;

    private static final int BLUE = 0x1971C2;

    /** A difference this large between two pictures with the same noise is not due to rounding. */
    private static final int DIFFERENT_LEVELS = 8;

    /** The red share of a picture's left and right half. */
    private record Red(double left, double right) {
        double share() {
            return left + right;
        }

        /** @param without the same picture without the board; the two differ where the board is */
        static Red in(CameraImage picture, CameraImage without) {
            int[] count = new int[2];
            byte[] bgr = without.bgr();
            for (int i = 0; i < bgr.length; i += 3) {
                if (isRed(bgr[i] & 0xFF, bgr[i + 1] & 0xFF, bgr[i + 2] & 0xFF)
                        || Math.abs((bgr[i] & 0xFF) - (picture.bgr()[i] & 0xFF)) > DIFFERENT_LEVELS) {
                    count[2 * (i / 3 % picture.widthPx()) / picture.widthPx()]++;
                }
            }
            double all = bgr.length / 3.0;
            return new Red(count[0] / all, count[1] / all);
        }

        private static boolean isRed(int blue, int green, int red) {
            return red >= 50 && red > 2 * Math.max(blue, green);
        }
    }

    private record Stop(long seed, boolean stopped, double missMm, double missDeg) {
        boolean isArrival() {
            return stopped && missMm < 50 && missDeg < 3;
        }

        boolean isNear() {
            return stopped && missMm < 300;
        }

        boolean isFalse() {
            return stopped && !isNear();
        }
    }

    private static Shape painted(Shape shape, int rgb) {
        return new Shape(
                shape.kind(),
                shape.corners(),
                new Finish(OptionalInt.of(rgb), shape.finish().heightMm()));
    }

    /** The same room without red and orange furniture; objects on the walls may still be red. */
    private static Room withoutRed(Room room) {
        List<Shape> shapes = room.shapes().stream()
                .map(shape -> shape.finish().rgb().stream().anyMatch(RedQuadrantsTest::isReddish)
                        ? painted(shape, BLUE)
                        : shape)
                .toList();
        return Room.of(shapes, null, room.start()).withMarker(room.marker().orElseThrow());
    }

    private static boolean isReddish(int rgb) {
        return Red.isRed(rgb & 0xFF, rgb >> 8 & 0xFF, rgb >> 16);
    }

    private static Eye eye(long seed) {
        return new Eye(EyeOptions.defaults().withSize(320, 240).withSeed(seed).withEffects(Effects.TYPICAL));
    }

    private static Stop drive(long seed, Room marked) {
        Pose target = marked.marker().orElseThrow().pose();
        Room bare = marked.withMarker(null);
        Room room = marked.withMarker(Marker.at(target).covered(true));
        Eye with = eye(seed);
        Eye without = eye(seed);
        Pose pose = room.start();
        boolean stopped = false;
        for (long frame = 1; frame <= LIMIT_S / FRAME_S && !stopped; frame++) {
            Red red = Red.in(with.render(room, pose, 0, frame), without.render(bare, pose, 0, frame));
            stopped = red.share() >= ENOUGH;
            if (!stopped) {
                pose = room.moved(pose, next(pose, red));
            }
        }
        return new Stop(
                seed,
                stopped,
                Math.abs(pose.distanceMmTo(target.center()) - GOAL_MM),
                Math.abs(Math.toDegrees(pose.bearingRadTo(target.xMm(), target.yMm()))));
    }

    private static Pose next(Pose pose, Red red) {
        double difference = red.left() - red.right();
        boolean ahead = red.share() >= LEAST_SHARE && Math.abs(difference) < BALANCE * red.share();
        if (ahead) {
            return pose.rolled(SPEED_MM_PER_S * FRAME_S, SPEED_MM_PER_S * FRAME_S);
        }
        double direction = red.share() < LEAST_SHARE || difference > 0 ? 1 : -1;
        double wheelMm = direction * TURN_RAD_PER_S * FRAME_S * Pose.WHEEL_BASE_MM / 2;
        return pose.rolled(-wheelMm, wheelMm);
    }

    private static long count(List<Stop> stops, Predicate<Stop> which) {
        return stops.stream().filter(which).count();
    }

    private static List<Stop> driveInRooms(String name, UnaryOperator<Room> change) {
        List<Stop> stops = LongStream.rangeClosed(1, ROOMS)
                .parallel()
                .mapToObj(seed -> drive(seed, change.apply(RandomRooms.withMarker(seed))))
                .toList();
        System.out.printf(
                Locale.ROOT,
                "%s: seeds 1 to %d, within 5 cm and 3 degrees %d, within 30 cm %d, stopped elsewhere %d, never %d%n",
                name,
                ROOMS,
                count(stops, Stop::isArrival),
                count(stops, Stop::isNear),
                count(stops, Stop::isFalse),
                count(stops, stop -> !stop.stopped()));
        return stops;
    }

    @Test
    void stopsNearARedBoardStraightAheadInAnEmptyRoom() {
        Room room =
                MoveTrip.room(MoveTrip.pose(1_000, 1_500, 30)).withMarker(Marker.at(MoveTrip.pose(2_500, 1_500, 180)));
        assertThat(drive(1, room)).matches(Stop::isNear);
    }

    @Test
    @Tag("slow")
    void missesMostGoalsInRandomRooms() {
        List<Stop> stops = driveInRooms("red quadrants", room -> room);
        assertThat(count(stops, Stop::isArrival)).isLessThan(ROOMS / 2);
    }

    @Test
    @Tag("slow")
    void missesMostGoalsWhereNoFurnitureIsRed() {
        List<Stop> stops = driveInRooms("red quadrants, no red furniture", RedQuadrantsTest::withoutRed);
        assertThat(count(stops, Stop::isArrival)).isLessThan(ROOMS / 2);
    }
}
