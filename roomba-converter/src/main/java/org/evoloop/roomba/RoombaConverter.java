package org.evoloop.roomba;

import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.journal.Journal;
import org.evoloop.link.Link;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.home.DayPlan;
import org.evoloop.roomba.move.Move;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;

/**
 * The assembled event converter of the cleaning robot.
 *
 * <p>Threading: as {@link SystemEventConverter}.
 *
 * @param session the robot
 * @param robot monitors the robot
 * @param controller the monitor of an external controller's buttons
 * @param converter built, not started
 * @param properties the properties of its models and of other models to which it may evolve
 * @param day when the robot cleans by itself
 */
public record RoombaConverter(
        RoombaSession session,
        EventMonitor robot,
        PushMonitor controller,
        SystemEventConverter converter,
        WrittenProperties properties,
        DayPlan day)
        implements AutoCloseable {

    /**
     * Builds a converter; the session may be opened before or after.
     *
     * @throws org.evoloop.statemachine.ModelException if the models are not an evolution that this robot can carry out
     * @throws org.evoloop.journal.JournalException if the journal cannot be continued
     */
    public static RoombaConverter build(LoopConfig config, RoombaSession session, RoombaOptions options) {
        Clock clock = config.clock();
        StateMachine original = options.models().pair().original();
        PushMonitor controller = new PushMonitor("Controller");
        SystemEventConverter converter = new SystemEventConverter(config);
        Resumption resumption = new Resumption();
        Function<RobotModels, KnowledgeState> knowing = models -> knowledge(models, session, options, resumption);
        AtomicBoolean mayMove = new AtomicBoolean();
        MonitorEvent robot = new MonitorEvent(
                session, original, event -> mayMove.get() && models(converter).restartsMove(current(converter), event));
        converter.addMonitor(robot);
        converter.addMonitor(controller);
        DayPlan day = day(options);
        day.timetable().ifPresent(converter::addMonitor);
        converter.addExecute(new ExecuteCommand(session, original, clock, resumption));
        converter.addKnowledge(knowing.apply(options.models()));
        WrittenProperties properties = new WrittenProperties();
        converter.addKnowledgeFactory(pair -> {
            properties.read(pair);
            return knowing.apply(RobotModels.of(pair));
        });
        properties.read(options.models().pair());
        converter.watch(properties);
        converter.addLink(session);
        converter.addSpare("ExecuteCommand2", () -> new ExecuteCommand(session, original, clock, resumption));
        Journal journal = options.journal();
        if (journal != null) {
            converter.journal(journal);
            // Even if Move was running when another process ended, the robot does not resume driving by itself.
            resumption.released();
        }
        converter.build();
        mayMove.set(true);
        if (journal != null) {
            session.assume(RobotEvents.activity(converter.status().states().original()));
        }
        return new RoombaConverter(session, robot, controller, converter, properties, day);
    }

    static KnowledgeState knowledge(
            RobotModels models, RoombaSession session, RoombaOptions options, Resumption resumption) {
        return new KnowledgeState(
                models,
                session,
                back -> new Move(session, options.startPoint(), options.move(), back),
                resumption,
                new SpotWait(options.spotWait()),
                options.quietHours().waiting(RobotEvents.QUIET_OVER));
    }

    /** Without times there is no timetable: then the robot has its own. */
    static DayPlan day(RoombaOptions options) {
        DayPlan day = new DayPlan(options.quietHours());
        return options.timetable().isEmpty() ? day : day.at(RobotEvents.SCHEDULE, "Clean at", options.timetable());
    }

    private static RobotModels models(SystemEventConverter converter) {
        return ((KnowledgeState) converter.knowledge()).robot();
    }

    private static State current(SystemEventConverter converter) {
        return converter.knowledge().getCurrentState();
    }

    /** The models that it has evolved to, or was built with. */
    RobotModels models() {
        return models(converter);
    }

    /**
     * Builds a converter for the robot at the other end of the cable. If the robot does not answer yet, the converter
     * keeps trying, as it does after the robot was unplugged.
     */
    static RoombaConverter connectPatiently(
            IntFunction<Link> cable, LoopConfig config, SessionOptions sessionOptions, RoombaOptions options)
            throws InterruptedException {
        RoombaSession session = new RoombaSession(cable, config.clock(), sessionOptions);
        RoombaConverter built = build(config, session, options);
        try {
            session.openPatiently(greeting(options));
            return built;
        } catch (RuntimeException | InterruptedException failure) {
            built.close();
            throw failure;
        }
    }

    /** The commands sent on connecting; the converter's timetable replaces the robot's own. */
    static List<Command> greeting(RoombaOptions options) {
        return options.timetable().isEmpty() ? List.of() : List.of(new Command.Schedule(Map.of()));
    }

    /** Builds a converter for the robot at the other end of the cable, and waits until the robot answers. */
    public static RoombaConverter connect(
            IntFunction<Link> cable, LoopConfig config, SessionOptions sessionOptions, RoombaOptions options)
            throws InterruptedException {
        RoombaSession session = new RoombaSession(cable, config.clock(), sessionOptions);
        // The models are checked before the robot is contacted.
        RoombaConverter built = build(config, session, options);
        try {
            session.open();
            session.awaitRobot();
            greeting(options).forEach(session::send);
            return built;
        } catch (RuntimeException | InterruptedException failure) {
            built.close();
            throw failure;
        }
    }

    /** One step of the monitors in a converter without threads. */
    void observe() throws InterruptedException {
        converter.observe(robot);
        converter.observe(controller);
    }

    /**
     * Closes the converter and releases the robot: a robot under control is stopped and left in Passive mode; one that
     * cleans by itself continues. Idempotent.
     */
    @Override
    public void close() {
        converter.close();
        session.close();
    }
}
