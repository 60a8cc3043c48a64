package org.evoloop.roomba.move;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.evoloop.function.ControlLoopFunction;
import org.evoloop.function.Reading;
import org.evoloop.function.Visit;
import org.evoloop.link.LinkException;
import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Plan;
import org.evoloop.roomba.move.phase.Ending;
import org.evoloop.roomba.move.phase.Maneuver;
import org.evoloop.roomba.move.phase.Memory;
import org.evoloop.roomba.move.phase.Phase;
import org.evoloop.roomba.move.phase.Situation;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Searches for the starting point, drives the robot there, and raises {@code arriveSpot}.
 *
 * <p>The robot must be under control (Safe mode). If it does not obey for long, or has not arrived within the limit,
 * the function ends: it says why and raises {@code timeout} if the new model has a transition for it, else the event
 * named by {@link Back}. A person at the robot has priority: if one of its buttons is pressed or it is lifted, the
 * function ends at once with the event named by {@link Back}. The wheels stop whenever the function ends, for whatever
 * reason.
 */
public final class Move extends ControlLoopFunction<Percept, Situation, Maneuver> {
    /** The event raised on arrival. */
    public static final String ARRIVED = "arriveSpot";

    /** The event raised when the robot has not arrived. */
    public static final String TIMEOUT = "timeout";

    private static final Logger LOG = LoggerFactory.getLogger(Move.class);

    private static final String DISOBEYING =
            "do not turn as commanded: no command reaches the robot, or it is held, pushed or stuck";

    /** Names the event that leaves Move when the robot has not arrived. */
    @FunctionalInterface
    public interface Back {
        /**
         * The event.
         *
         * @param work what the robot does by itself after somebody has used its buttons; empty if it is at rest
         */
        String event(Optional<EstimatedActivity> work);
    }

    private final RoombaSession session;
    private final Function<Clock, StartPointSensor> startPoint;
    private final MoveOptions options;
    private final Back back;

    /**
     * A function that drives to the starting point.
     *
     * @param startPoint opens a new sensor each time the state is entered; it is closed when the state is left
     * @param back names the event to raise when the robot has not arrived
     */
    public Move(RoombaSession session, Function<Clock, StartPointSensor> startPoint, MoveOptions options, Back back) {
        this.back = back;
        this.session = session;
        this.startPoint = startPoint;
        this.options = options;
    }

    @Override
    protected void assemble(MapeLoop<Percept, Situation, Maneuver> loop, Visit visit) {
        StartPointSensor sensor = startPoint.apply(visit.clock());
        visit.onEnd(sensor::close);
        MonitorSenses monitor = new MonitorSenses(loop, sensor, session::isUndocking, options.frameLimit(), visit);
        visit.onEnd(monitor::close);
        loop.addMonitor(monitor);
        ObeyWatch obeyWatch = new ObeyWatch(options.frameLimit().toNanos());
        loop.addAnalyze(new AnalyzeSituation(options, obeyWatch, visit));
        loop.addPlan(new PlanManeuver(new Memory(sensor.target(), options.frameLimit(), options.settle()), visit));
        loop.addExecute(new ExecuteManeuver(visit, obeyWatch));
        visit.onEnd(this::stopWheels);
        visit.onEnd(() -> session.removeListener(monitor));
        session.addListener(monitor);
    }

    /** A failed loop would fail again, and the wheels would keep turning; so this stops them and ends Move. */
    @Override
    protected void failed(Visit visit, Throwable cause) {
        stopWheels();
        end(visit, Ending.because("its program has failed: " + cause));
    }

    /** Ends a visit in which the robot must not drive; it raises the event named by {@link Back}. */
    public void giveUp(Visit visit, String reason) {
        end(visit, Ending.byPerson(reason, Optional.empty()));
    }

    private void end(Visit visit, Ending ending) {
        if (ending.byPerson()) {
            LOG.warn("Move has ended before the starting point: {}", ending.reason());
        } else {
            visit.failed("ended before the starting point: " + ending.reason());
        }
        visit.say("Stop before target point: " + ending.reason());
        Stream.of(ending.byPerson() ? "" : TIMEOUT, back.event(ending.work()), back.event(Optional.empty()))
                .filter(event -> !event.isEmpty() && visit.accepts(event))
                .findFirst()
                .ifPresent(visit::finish);
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
        private final ObeyWatch obeyWatch;
        private final Visit visit;
        private final MoveOptions options;
        private final long beganNanos;
        private @Nullable Situation last;

        AnalyzeSituation(MoveOptions options, ObeyWatch obeyWatch, Visit visit) {
            this.options = options;
            this.goalWatch = new GoalWatch(options.frameLimit().toNanos());
            this.obeyWatch = obeyWatch;
            this.visit = visit;
            this.beganNanos = visit.clock().nanoTime();
        }

        @Override
        protected Situation analyze(Percept percept) {
            Situation before = last;
            Situation now = before != null && !percept.heard() ? before.unheard(percept.nanos()) : heard(percept);
            last = now;
            return now;
        }

        private Situation heard(Percept percept) {
            Telemetry now = percept.telemetry();
            if (obeyWatch.update(now.values(), now.isUnderControl(), percept.nanos())) {
                visit.failed("the wheels " + DISOBEYING);
                visit.say("The wheels " + DISOBEYING);
            }
            return Situation.of(percept.nanos(), percept.telemetry(), goalWatch.update(percept), ending(percept));
        }

        private Ending ending(Percept percept) {
            Ending held = holdWatch.update(percept.telemetry(), percept.nanos());
            Ending end = percept.person().isDue() ? percept.person() : held;
            if (end.isDue()) {
                return end;
            }
            if (percept.nanos() - beganNanos <= options.limit().toNanos()) {
                return Ending.NONE;
            }
            String reason = percept.look().health().reason();
            return Ending.because(
                    "not found within " + options.limit().toSeconds() + " s" + (reason.isEmpty() ? "" : "; " + reason));
        }
    }

    private final class PlanManeuver extends Plan<Situation, Maneuver> {
        private final Memory memory;
        private final Visit visit;
        private final long beganNanos;
        private @Nullable Phase phase;

        PlanManeuver(Memory memory, Visit visit) {
            this.memory = memory;
            this.visit = visit;
            this.beganNanos = visit.clock().nanoTime();
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
            report(step.phase(), now);
            return step.maneuver();
        }

        /** Reports the distance to the starting point in m, whether it is in sight, and the time left in s. */
        private void report(Phase about, Situation now) {
            List<Reading> readings = new ArrayList<>();
            now.sight().goal().ifPresent(goal -> {
                double leftMm = now.pose().distanceTo(goal.xMm(), goal.yMm())
                        - memory.target().distanceMm();
                readings.add(Reading.of("distance", Math.max(0, leftMm) / 1000, "m"));
            });
            boolean inSight = now.sight()
                    .goalSince(now.nanos() - options.frameLimit().toNanos())
                    .isPresent();
            readings.add(Reading.of("inSight", inSight));
            Duration left = options.limit().minusNanos(now.nanos() - beganNanos);
            readings.add(Reading.of("timeLeft", Math.max(0, left.toSeconds()), "s"));
            visit.progress(now.obeys() ? about.describe() : "waiting for the robot to obey", readings);
        }
    }

    private final class ExecuteManeuver extends Execute<Maneuver> {
        private final Visit visit;
        private final ObeyWatch obeyWatch;
        private @Nullable DriveDirect driving;
        private boolean over;

        ExecuteManeuver(Visit visit, ObeyWatch obeyWatch) {
            this.visit = visit;
            this.obeyWatch = obeyWatch;
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
                end(visit, giveUp.ending());
            } else {
                visit.say("Arrive at target point");
                visit.finish(ARRIVED);
            }
        }

        private void drive(DriveDirect wheels) {
            if (!wheels.equals(driving)) {
                driving = null;
                obeyWatch.commanded(wheels, visit.clock().nanoTime());
                try {
                    session.send(wheels);
                    driving = wheels;
                } catch (LinkException | RobotException gone) {
                    // Sent again with the next frame; no frames arrive until the robot is back.
                    LOG.debug("the wheel command {} was not sent: {}", wheels, gone.getMessage());
                }
            }
        }
    }
}
