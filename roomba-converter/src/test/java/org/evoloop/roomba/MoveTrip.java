package org.evoloop.roomba;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiFunction;
import org.evoloop.PaperPair;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.ModelPair;
import org.evoloop.roomba.camera.MarkerCamera;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/** A robot with a camera in a room, on its way to the marker; records its speed whenever it touches something. */
final class MoveTrip implements AutoCloseable {
    private static final Duration TICK = Duration.ofMillis(15);

    final SteppedRoomba stepped;
    private final MarkerCamera camera;
    private final @Nullable Pose marker;
    private boolean touching;
    private double fastestTouchMmPerS;

    MoveTrip(Room room, @Nullable Pose marker, ModelPair models, MoveOptions options, long seed) {
        this(room, marker, models, options, (robot, clock) -> new GeometricCamera(robot, room, clock, marker, seed));
    }

    MoveTrip(
            Room room,
            @Nullable Pose marker,
            ModelPair models,
            MoveOptions options,
            BiFunction<SimulatedRoomba, ManualClock, MarkerCamera> camera) {
        this.marker = marker;
        AtomicReference<MarkerCamera> made = new AtomicReference<>();
        this.stepped = new SteppedRoomba(
                RobotOptions.builder().room(room).spotDurationMillis(8_000).build(),
                models,
                options,
                (robot, clock) -> {
                    made.set(camera.apply(robot, clock));
                    return StartPointSensor.byCamera(made.get());
                });
        this.camera = made.get();
        stepped.robotPress(Button.CLEAN).robotPress(Button.SPOT);
    }

    static MoveTrip in(Room room, @Nullable Pose marker) {
        return new MoveTrip(room, marker, PaperPair.cleaningRobot(), MoveOptions.defaults(), 1);
    }

    /** The paper's models with a transition on {@code timeout} from Move to On. */
    static ModelPair withTimeout() {
        ModelPair paper = PaperPair.cleaningRobot();
        StateMachine evolved = paper.evolved();
        var builder =
                StateMachine.named("with timeout").initial(evolved.initial().name());
        evolved.transitions()
                .forEach(each -> builder.transition(
                        each.source().name(), each.event().name(), each.target().name()));
        return new ModelPair(
                paper.original(), builder.transition("Move", "timeout", "On").build());
    }

    static Pose pose(double xMm, double yMm, double headingDeg) {
        return new Pose(xMm, yMm, Math.toRadians(headingDeg));
    }

    static Shape box(Shape.Kind kind, double left, double bottom, double right, double top) {
        return new Shape(
                kind,
                List.of(
                        new Point(left, bottom),
                        new Point(right, bottom),
                        new Point(right, top),
                        new Point(left, top)));
    }

    /** A room of 4 by 3 m with this furniture; the origin is in a corner. */
    static Room room(Pose start, Shape... furniture) {
        List<Shape> shapes = new ArrayList<>(List.of(furniture));
        shapes.add(box(Shape.Kind.WALL, 0, 0, 4_000, 3_000));
        return Room.of(shapes, null, start);
    }

    /** The camera, if it is a geometric one. */
    GeometricCamera camera() {
        return (GeometricCamera) camera;
    }

    boolean isMoving() {
        return stepped.states().evolved().name().equals("Move");
    }

    RobotState truth() {
        return stepped.truth();
    }

    /** Waits until it drives, which it does once it has seen the marker. */
    void untilItDrives() {
        stepped.until(() -> Math.min(truth().leftMmPerS(), truth().rightMmPerS()) > 80, Duration.ofSeconds(10));
    }

    boolean stands() {
        return truth().leftMmPerS() == 0 && truth().rightMmPerS() == 0;
    }

    MoveTrip advance(Duration duration) {
        for (long left = duration.toNanos(); left > 0; left -= TICK.toNanos()) {
            double before = forward(truth());
            stepped.advance(TICK);
            boolean touches = !truth().surroundings().bumps().isEmpty();
            if (touches && !touching) {
                fastestTouchMmPerS = Math.max(fastestTouchMmPerS, Math.max(before, forward(truth())));
            }
            touching = touches;
        }
        return this;
    }

    private static double forward(RobotState state) {
        return Math.abs(state.leftMmPerS() + state.rightMmPerS()) / 2;
    }

    /**
     * Waits until Move has been left.
     *
     * @return whether that was in time
     */
    boolean ends(Duration limit) {
        for (long left = limit.toNanos(); left > 0 && isMoving(); left -= TICK.toNanos()) {
            advance(TICK);
        }
        return !isMoving();
    }

    double fastestTouchMmPerS() {
        return fastestTouchMmPerS;
    }

    /** The distance from the goal, 0.40 m in front of the marker. */
    double missMm() {
        return marker == null ? Double.NaN : Math.abs(truth().pose().distanceMmTo(marker.center()) - 400);
    }

    /** The angle by which the robot faces past the marker. */
    double missDeg() {
        return marker == null
                ? Double.NaN
                : Math.abs(Math.toDegrees(truth().pose().bearingRadTo(marker.xMm(), marker.yMm())));
    }

    List<String> history() {
        return stepped.roomba.converter().history().stream()
                .map(HistoryEntry::detail)
                .toList();
    }

    @Override
    public void close() {
        stepped.close();
    }
}
