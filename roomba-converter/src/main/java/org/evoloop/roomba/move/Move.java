package org.evoloop.roomba.move;

import org.evoloop.function.ControlLoopFunction;
import org.evoloop.function.Visit;
import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Plan;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.Telemetry;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Drives the robot to the starting point and raises {@code arriveSpot} there.
 *
 * <p>The robot must be under control (Safe mode); if it is no longer, the function stops without an event. The wheels
 * stop whenever the function ends, however it ends.
 */
public final class Move extends ControlLoopFunction<Telemetry, Course, Maneuver> {
    /** The event that tells of the arrival. */
    public static final String ARRIVED = "arriveSpot";

    private static final Logger LOG = LoggerFactory.getLogger(Move.class);
    private static final DriveDirect STANDSTILL = new DriveDirect(0, 0);

    /** A robot that was just told to enter Safe mode shows it within a few frames. */
    private static final long CONTROL_FRAMES = 34;

    private final RoombaSession session;
    private final StartPointSensor sensor;

    public Move(RoombaSession session, StartPointSensor sensor) {
        this.session = session;
        this.sensor = sensor;
    }

    @Override
    protected void assemble(MapeLoop<Telemetry, Course, Maneuver> loop, Visit visit) {
        MonitorFrames monitor = new MonitorFrames(loop, visit.threads());
        loop.addMonitor(monitor);
        loop.addAnalyze(new AnalyzeCourse());
        loop.addPlan(new PlanManeuver());
        loop.addExecute(new ExecuteManeuver(visit));
        visit.onEnd(this::stopWheels);
        visit.onEnd(() -> session.removeListener(monitor));
        session.addListener(monitor);
    }

    private void stopWheels() {
        if (session.isUnderControl()) {
            try {
                session.send(STANDSTILL);
            } catch (LinkException gone) {
                LOG.warn("the wheels could not be stopped: {}", gone.getMessage());
            }
        }
    }

    private final class AnalyzeCourse extends Analyze<Telemetry, Course> {
        private long frames;

        @Override
        protected Course analyze(Telemetry telemetry) {
            frames++;
            if (!telemetry.isUnderControl()) {
                return frames < CONTROL_FRAMES ? new Course.Lost() : new Course.OutOfControl();
            }
            return sensor.look(telemetry).map(Course::to).orElseGet(Course.Lost::new);
        }
    }

    private static final class PlanManeuver extends Plan<Course, Maneuver> {
        @Override
        protected Maneuver plan(Course course) {
            return Maneuver.on(course);
        }
    }

    private final class ExecuteManeuver extends Execute<Maneuver> {
        private final Visit visit;
        private DriveDirect driving = STANDSTILL;
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
            } else if (maneuver instanceof Maneuver.Arrive) {
                over = true;
                drive(STANDSTILL);
                visit.say("Arrive at target point");
                visit.finish(ARRIVED);
            } else if (maneuver instanceof Maneuver.GiveUp giveUp) {
                over = true;
                LOG.warn("Move has ended before the starting point: {}", giveUp.reason());
            }
        }

        private void drive(DriveDirect wheels) {
            if (!wheels.equals(driving)) {
                session.send(wheels);
                driving = wheels;
            }
        }
    }
}
