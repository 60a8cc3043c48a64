package org.evoloop.roomba;

import java.time.Duration;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.journal.Journal;
import org.evoloop.loop.LoopConfig;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.move.Move;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The cleaning robot's event converter, put together.
 *
 * <p>Threading: as {@link SystemEventConverter}.
 *
 * @param session the robot
 * @param robot monitors the robot
 * @param controller where an external controller's buttons are pressed
 * @param converter built, not started
 */
public record RoombaConverter(
        RoombaSession session, EventMonitor robot, PushMonitor controller, SystemEventConverter converter)
        implements AutoCloseable {

    /**
     * What can be chosen.
     *
     * @param models the robot's, with the functions of their new states
     * @param startPoint opens what senses where Move has to go
     * @param move how patient Move is
     * @param spotWait how long SpotWait waits for a second press
     * @param journal where the converter keeps what it is told; null if it keeps nothing
     */
    public record Options(
            RobotModels models,
            Function<Clock, StartPointSensor> startPoint,
            MoveOptions move,
            Duration spotWait,
            @Nullable Journal journal) {

        /** Without a journal. */
        public Options(
                RobotModels models, Function<Clock, StartPointSensor> startPoint, MoveOptions move, Duration spotWait) {
            this(models, startPoint, move, spotWait, null);
        }
    }

    /**
     * Builds a converter; the session may be opened before or after.
     *
     * @throws org.evoloop.statemachine.ModelException if the models are no evolution that this robot can take part in
     * @throws org.evoloop.journal.JournalException if the journal cannot be gone on with
     */
    public static RoombaConverter build(LoopConfig config, RoombaSession session, Options options) {
        Clock clock = config.clock();
        PushMonitor controller = new PushMonitor("Controller");
        SystemEventConverter converter = new SystemEventConverter(config);
        Resumption resumption = new Resumption();
        KnowledgeState knowledge = new KnowledgeState(
                options.models(),
                back -> new Move(session, options.startPoint(), options.move(), back),
                resumption,
                new SpotWait(options.spotWait()));
        MonitorEvent robot =
                new MonitorEvent(session, event -> options.models().restartsMove(knowledge.getCurrentState(), event));
        converter.addMonitor(robot);
        converter.addMonitor(controller);
        converter.addExecute(new ExecuteCommand(session, clock, resumption));
        converter.addKnowledge(knowledge);
        converter.addLink(session);
        converter.addSpare("ExecuteCommand2", () -> new ExecuteCommand(session, clock, resumption));
        Journal journal = options.journal();
        if (journal != null) {
            converter.journal(journal);
            // Whatever moved before another process ended: the robot does not drive on by itself.
            resumption.released();
        }
        converter.build();
        if (journal != null) {
            session.assume(RobotEvents.activity(converter.status().states().original()));
        }
        return new RoombaConverter(session, robot, controller, converter);
    }

    /** Builds a converter for the robot at the cable's other end, and waits for the robot to answer. */
    public static RoombaConverter connect(
            IntFunction<Link> cable, LoopConfig config, SessionOptions sessionOptions, Options options)
            throws InterruptedException {
        RoombaSession session = new RoombaSession(cable, config.clock(), sessionOptions);
        // The models come first: if they are wrong, no robot is touched.
        RoombaConverter built = build(config, session, options);
        try {
            session.open();
            session.awaitRobot();
            return built;
        } catch (RuntimeException | InterruptedException failure) {
            built.close();
            throw failure;
        }
    }

    /** The step of the monitors in a converter without threads. */
    void observe() throws InterruptedException {
        converter.observe(robot);
        converter.observe(controller);
    }

    /**
     * Ends the converter and lets go of the robot: one under control is stopped and left in Passive mode, one that cleans by
     * itself goes on. Idempotent.
     */
    @Override
    public void close() {
        converter.close();
        session.close();
    }
}
