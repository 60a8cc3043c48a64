package org.evoloop.roomba.simulator.drawing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.jspecify.annotations.Nullable;

/**
 * Records a robot's path, and why it moved. It must receive the state of every tick. The oldest part of a long path is
 * dropped.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Trail implements Consumer<RobotState> {
    private static final double STEP_MM = 15;

    /** A longer distance in one tick means that the robot was carried. */
    private static final double CARRIED_MM = 12;

    /** Three kilometres, or a few hours of cleaning. */
    private static final int MOST_STEPS = 200_000;

    /** A part of the path with one cause. */
    record Piece(Cause cause, List<Point> points) {}

    private record Step(Point point, Cause cause, boolean joined) {}

    private final Deque<Step> steps = new ArrayDeque<>();
    private @Nullable Pose start;
    private @Nullable Pose last;
    private boolean carried;

    /** An empty trail. */
    public Trail() {}

    @Override
    public synchronized void accept(RobotState state) {
        Pose now = state.pose();
        Pose before = last;
        last = now;
        if (before == null) {
            start = now;
            add(now, Cause.of(state, Cause.CLIENT), false);
            return;
        }
        carried |= before.distanceMmTo(now.center()) > CARRIED_MM;
        Step latest = steps.getLast();
        Cause cause = Cause.of(state, latest.cause());
        boolean newCause = latest.cause() != cause && before.distanceMmTo(now.center()) > 0;
        if (carried || newCause || now.distanceMmTo(latest.point()) >= STEP_MM) {
            add(now, cause, !carried);
            carried = false;
        }
    }

    private void add(Pose pose, Cause cause, boolean joined) {
        steps.addLast(new Step(pose.center(), cause, joined));
        if (steps.size() > MOST_STEPS) {
            steps.removeFirst();
        }
    }

    /** Where the robot was first seen; null before that. */
    synchronized @Nullable Pose start() {
        return start;
    }

    /** The pieces of the path, oldest first. */
    synchronized List<Piece> pieces() {
        List<Piece> pieces = new ArrayList<>();
        Point before = null;
        for (Step step : steps) {
            Piece piece = pieces.isEmpty() ? null : pieces.get(pieces.size() - 1);
            if (piece == null || !step.joined() || piece.cause() != step.cause()) {
                piece = new Piece(step.cause(), new ArrayList<>());
                pieces.add(piece);
                if (before != null && step.joined()) {
                    piece.points().add(before);
                }
            }
            piece.points().add(step.point());
            before = step.point();
        }
        return pieces;
    }
}
