package org.evoloop.roomba;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.Connection;
import org.evoloop.device.FileModels;
import org.evoloop.device.Parts;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.link.Link;
import org.evoloop.roomba.move.Move;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.simulator.WorldCommands;
import org.evoloop.roomba.simulator.room.RoomFile;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/** A Roomba of a device file, made of a {@link MonitorEvent} and an {@link ExecuteCommand}. */
final class RoombaFileConnection extends Connection {
    /** The functions that a file can name; those that only wait, it says itself. */
    private static final List<String> FUNCTIONS = List.of("Charge", "Move", "SpotClean");

    private final FileModels models;
    private final String port;
    private final boolean guarded;
    private final SessionOptions options;
    private final Point startPoint;
    private volatile @Nullable RoombaSession session;

    /** In millimetres ahead and to the left of where the session began. */
    private record Point(double xMm, double yMm) {
        static Point parse(String text) {
            if (!text.matches("-?[0-9]{1,6}, ?-?[0-9]{1,6}")) {
                throw new IllegalArgumentException("'" + text + "' is no point; write X,Y in mm, such as \"1000,500\"");
            }
            String[] both = text.split(", ?", 2);
            return new Point(Integer.parseInt(both[0]), Integer.parseInt(both[1]));
        }
    }

    private RoombaFileConnection(
            String name, String port, boolean guarded, SessionOptions options, Point startPoint, FileModels models) {
        super(name, "roomba");
        this.port = port;
        this.guarded = guarded;
        this.options = options;
        this.startPoint = startPoint;
        this.models = models;
    }

    static RoombaFileConnection read(String name, Section section, FileModels models) {
        String port = section.text("roomba").map(Node.Text::value).orElse("");
        SessionOptions usual = SessionOptions.defaults();
        RobotEvents.COMMANDS.stream()
                .filter(models::isOfTheDevice)
                .forEach(event -> models.sent(named(section, event)));
        RobotEvents.FACTS.stream()
                .filter(models::isOfTheDevice)
                .forEach(event -> models.devicesOwn(named(section, event)));
        RobotEvents.STATES.stream()
                .filter(models::isStateOfTheDevice)
                .forEach(state -> models.deviceState(named(section, state)));
        return new RoombaFileConnection(
                name,
                port,
                section.flag("guard").orElse(true),
                section.number("mode-offset", 0, 1).map(usual::withModeOffset).orElse(usual),
                section.value("start-point", Point::parse).orElse(new Point(0, 0)),
                models);
    }

    private static Node.Text named(Section section, String name) {
        return new Node.Text(section.node().line(), name, true);
    }

    @Override
    public void send(Node.Text event, Section how) {
        if (!RobotEvents.COMMANDS.contains(event.value())) {
            how.problem(
                    "a Roomba has no command for '" + event + "'" + Names.hint(event.value(), RobotEvents.COMMANDS));
        }
    }

    @Override
    public @Nullable NewFunction function(Node.Text state, Section section) {
        Node.Text name = section.need("function").orElse(null);
        if (name == null) {
            return null;
        }
        return switch (name.value()) {
            case "Move" -> this::move;
            case "SpotClean" ->
                visit -> new RobotWork(
                                visit::device, "cleaning the spot", RobotEvents.SPOT, Set.of(RobotEvents.STATE_SPOT))
                        .run(visit);
            case "Charge" ->
                visit -> new RobotWork(
                                visit::device, "charging first, then going on", RobotEvents.DOCK, RobotWork.DOCKING)
                        .run(visit);
            default -> {
                section.problems()
                        .at(name, "a Roomba has no function '" + name + "'" + Names.hint(name.value(), FUNCTIONS));
                yield null;
            }
        };
    }

    /** It never drives on by itself after a restart. If it does not arrive, it leaves the state by {@code Clean}. */
    private void move(Visit visit) throws Exception {
        RoombaSession robot = requireNonNull(session);
        Move move = new Move(
                robot,
                clock -> StartPointSensor.byWheels(startPoint.xMm(), startPoint.yMm()),
                MoveOptions.defaults(),
                work -> RobotEvents.CLEAN);
        if (visit.beginning() == Visit.Beginning.RESUMED) {
            move.giveUp(visit, "the converter was stopped on the way");
        } else if (new Readiness(robot, visit::device).provide(visit)) {
            move.run(visit);
        }
    }

    @Override
    protected boolean asksByItself() {
        return true;
    }

    @Override
    protected Parts make(SystemEventConverter converter) throws IOException {
        RobotGuard guard = guarded ? guard() : null;
        IntFunction<Link> cable = RoombaCommand.cable(port);
        return parts(
                converter,
                guard == null ? cable : guard.cable(cable),
                guard,
                guard == null ? () -> {} : guard::close,
                List.of());
    }

    private RobotGuard guard() throws IOException {
        try {
            return new RobotGuard(port);
        } catch (IllegalArgumentException none) {
            throw new IOException("connection " + name() + ": " + none.getMessage() + " (guard: false)", none);
        }
    }

    @Override
    protected Parts makeSimulated(SystemEventConverter converter) throws IOException {
        SimulatedWorld world = SimulatedWorld.inThisProcess(1, false, RoomFile.named(RoomFile.LIVING_ROOM_NAME));
        ConsoleCommand command = ConsoleCommand.of(
                        "robot COMMAND [ARGUMENT] [ARGUMENT] [ARGUMENT]",
                        "gives the simulated robot's world a command: robot press clean, robot help",
                        (arguments, out) -> out.println(world.execute(String.join(" ", arguments))))
                .completing(before -> before.isEmpty() ? WorldCommands.NAMES : WorldCommands.BUTTON_NAMES);
        return parts(converter, RoombaCommand.cable(world.port().toString()), null, world::close, List.of(command));
    }

    private Parts parts(
            SystemEventConverter converter,
            IntFunction<Link> cable,
            @Nullable RobotGuard guard,
            Runnable closing,
            List<ConsoleCommand> commands) {
        StateMachine original = models.models().original();
        RoombaSession robot = new RoombaSession(cable, converter.clock(), options);
        session = robot;
        DeviceLink link = guard == null ? robot : guard.watch(robot);
        return new Parts(
                List.of(new MonitorEvent(robot, original, event -> false)),
                List.of(new ExecuteCommand(robot, original, converter.clock(), new Resumption())),
                link,
                () -> open(robot, converter),
                () -> {
                    robot.close();
                    closing.run();
                },
                commands);
    }

    private static void open(RoombaSession robot, SystemEventConverter converter) throws IOException {
        // What a journal has kept.
        robot.assume(RobotEvents.activity(converter.status().states().original()));
        try {
            robot.openPatiently(List.of());
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new IOException("the robot was not waited for", stop);
        }
    }
}
