package org.evoloop.roomba.move;

import java.util.function.Function;
import org.evoloop.function.ControlLoopFunction;
import org.evoloop.function.Visit;
import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Plan;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.move.phase.Maneuver;
import org.evoloop.roomba.move.phase.Memory;
import org.evoloop.roomba.move.phase.Phase;
import org.evoloop.roomba.move.phase.Situation;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Searches the starting point, drives the robot there, and raises {@code arriveSpot}.
 *
 * <p>The robot must be under control (Safe mode). If it is lifted, does not obey for long, or has not arrived when the limit
 * is over, the function ends: it says why and raises {@code timeout} if the new model has a transition for it; if not, the
 * system stays in its state and the robot stands. The wheels stop whenever the function ends, however it ends.
 */
public final class Move extends ControlLoopFunction<Percept, Situation, Maneuver> {
    /** The event that tells of the arrival. */
    public static final String ARRIVED = "arriveSpot";

    /** The event that tells that there was none. */
    public static final String TIMEOUT = "timeout";

    private static final Logger LOG = LoggerFactory.getLogger(Move.class);

    private final RoombaSession session;
    private final Function<Clock, StartPointSensor> startPoint;
    private final MoveOptions options;

    /** @param startPoint opens the sensor anew each time the state is entered, which closes it when it is left */
    public Move(RoombaSession session, Function<Clock, StartPointSensor> startPoint, MoveOptions options) {
        this.session = session;
        this.startPoint = startPoint;
        this.options = options;
    }

    @Override
    protected void assemble(MapeLoop<Percept, Situation, Maneuver> loop, Visit visit) {
        StartPointSensor sensor = startPoint.apply(visit.clock());
        visit.onEnd(sensor::close);
        MonitorSenses monitor = new MonitorSenses(loop, sensor, visit.clock(), visit.threads());
        loop.addMonitor(monitor);
        loop.addAnalyze(new AnalyzeSituation(options, visit.clock().nanoTime()));
        loop.addPlan(new PlanManeuver(new Memory(sensor.target(), options.frameLimit(), options.settle())));
        loop.addExecute(new ExecuteManeuver(visit));
        visit.onEnd(this::stopWheels);
        visit.onEnd(() -> session.removeListener(monitor));
        session.addListener(monitor);
    }

    /** What failed once will fail again, and until then the wheels turn as they were told. */
    @Override
    protected void failed(Visit visit, Throwable cause) {
        stopWheels();
        end(visit, "its program has failed: " + cause);
    }

    private void end(Visit visit, String reason) {
        LOG.warn("Move has ended before the starting point: {}", reason);
        visit.say("Stop before target point: " + reason);
        if (visit.accepts(TIMEOUT)) {
            visit.finish(TIMEOUT);
        }
    }

    private void stopWheels() {
        if (session.isUnderControl()) {
            try {
                session.send(Maneuver.STAND.wheels());
            } catch (LinkException | RobotException gone) {
                LOG.warn("the wheels could not be stopped: {}", gone.getMessage());
            }
        }
    }

    private static final class AnalyzeSituation extends Analyze<Percept, Situation> {
        private final GoalWatch goalWatch;
        private final HoldWatch holdWatch = new HoldWatch();
        private final MoveOptions options;
        private final long beganNanos;

        AnalyzeSituation(MoveOptions options, long nowNanos) {
            this.options = options;
            this.goalWatch = new GoalWatch(options.frameLimit().toNanos());
            this.beganNanos = nowNanos;
        }

        @Override
        protected Situation analyze(Percept percept) {
            String end = holdWatch.update(percept.telemetry(), percept.nanos());
            if (end.isEmpty() && percept.nanos() - beganNanos > options.limit().toNanos()) {
                String reason = percept.look().health().reason();
                end = "not found within " + options.limit().toSeconds() + " s"
                        + (reason.isEmpty() ? "" : "; " + reason);
            }
            return Situation.of(percept.nanos(), percept.telemetry(), goalWatch.update(percept), end);
        }
    }

    private static final class PlanManeuver extends Plan<Situation, Maneuver> {
        private final Memory memory;
        private @Nullable Phase phase;

        PlanManeuver(Memory memory) {
            this.memory = memory;
        }

        @Override
        protected Maneuver plan(Situation now) {
            Phase present = phase;
            Phase.Step step = Phase.inAny(present == null ? Phase.first(memory) : present, now);
            phase = step.phase();
            if (present == null || present.getClass() != step.phase().getClass()) {
                LOG.debug(
                        "{} at {}, goal {}",
                        step.phase().getClass().getSimpleName(),
                        now.pose(),
                        now.sight().goal());
            }
            return step.maneuver();
        }
    }

    private final class ExecuteManeuver extends Execute<Maneuver> {
        private final Visit visit;
        private @Nullable DriveDirect driving;
        private boolean over;

        ExecuteManeuver(Visit visit) {
            this.visit = visit;
        }

        @Override
        protected void execute(Maneuver maneuver) {
            if (over || !visit.isActive()) {
                return;
            }
            if (maneuver instanceof Maneuver.Drive drive) {
                drive(drive.wheels());
                return;
            }
            over = true;
            drive(Maneuver.STAND.wheels());
            if (maneuver instanceof Maneuver.GiveUp giveUp) {
                end(visit, giveUp.reason());
            } else {
                visit.say("Arrive at target point");
                visit.finish(ARRIVED);
            }
        }

        private void drive(DriveDirect wheels) {
            if (!wheels.equals(driving)) {
                driving = null;
                try {
                    session.send(wheels);
                    driving = wheels;
                } catch (LinkException | RobotException gone) {
                    // Sent again with the next frame, which there is none of before the robot is back.
                    LOG.debug("the wheels were not told {}: {}", wheels, gone.getMessage());
                }
            }
        }
    }
}
