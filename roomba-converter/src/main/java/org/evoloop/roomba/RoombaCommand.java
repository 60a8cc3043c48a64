package org.evoloop.roomba;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.evoloop.config.CommandOptions;
import org.evoloop.config.Mistakes;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.journal.Journal;
import org.evoloop.link.Link;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.HomeAssistant;
import org.evoloop.mqtt.MqttOptions;
import org.evoloop.page.Page;
import org.evoloop.page.PageOptions;
import org.evoloop.page.Picture;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.WorldCommands;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.RoomFile;
import org.evoloop.service.Service;
import org.evoloop.service.ServiceOptions;
import org.evoloop.statemachine.Names;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The Roomba converter as a program: a robot, a converter and its console. */
@Command(
        name = "roomba",
        description = "Gives a Roomba new functions: converts its events between the original and the new model.",
        footer = "%nctl NAME COMMAND gives a command to the one that was started with --name NAME (ctl --help).",
        mixinStandardHelpOptions = true)
final class RoombaCommand implements Callable<Integer> {
    /** The options that are declared where they are implemented. */
    private static final Options OPTIONS =
            Options.of().and(ServiceOptions.OPTIONS, PageOptions.OPTIONS, MqttOptions.OPTIONS);

    @Mixin
    private final ConverterOptions options = new ConverterOptions();

    @Option(names = "--port", paramLabel = "PATH", description = "The robot's serial port, such as /dev/ttyUSB0.")
    private @Nullable String port;

    @Option(names = "--simulate", description = "Starts a simulated robot and connects to it.")
    private boolean simulate;

    @Option(
            names = "--speed",
            paramLabel = "N",
            description = "With --simulate: time passes N times as fast, 0.01 to 1000 (default: 1).")
    private @Nullable Double speed;

    @Option(
            names = "--room",
            paramLabel = "FILE",
            description = "With --simulate: the room in which the robot lives, a file as in simulator --help, or "
                    + RoomFile.LIVING_ROOM_NAME + ", which has a dock and a marker (default: "
                    + RoomFile.LIVING_ROOM_NAME + ").")
    private @Nullable String room;

    private Room world = Room.OPEN;

    @Option(
            names = "--mode-offset",
            paramLabel = "N",
            description = "What the robot adds to the mode it reports: 1 for some 600 models with Wi-Fi, else 0 "
                    + "(default: found out when it answers).")
    private @Nullable Integer modeOffset;

    @Option(
            names = "--no-guard",
            description = "With --port: does not start the guard process, which stops the robot when this program is "
                    + "killed or frozen. A simulated robot has none.")
    private boolean noGuard;

    private Settings settings = OPTIONS.read(List.of(), Map.of());

    /** The command, whose help and parser know all of its options. */
    static CommandLine line(RoombaCommand command) {
        return CommandOptions.show(new CommandLine(command), OPTIONS);
    }

    /**
     * Reads and checks the command's options, from all sources.
     *
     * @param line the command's own, which has its options afterwards
     * @throws org.evoloop.config.ConfigException if there are mistakes
     */
    Settings configure(CommandLine line, List<String> arguments) {
        CommandOptions own = ConverterOptions.refined(new CommandOptions(line, Main::isUsersMistake))
                .check("speed", text -> requireSpeed(Double.parseDouble(text)))
                .placed(
                        "room",
                        (folder, text) ->
                                text.equals(RoomFile.LIVING_ROOM_NAME) ? text : CommandOptions.resolved(folder, text))
                .placed("port", (folder, text) -> text.contains("/") ? CommandOptions.resolved(folder, text) : text)
                .alternatives("port", "simulate");
        settings = Options.named("roomba", "")
                .and(own.and(OPTIONS))
                .checking((given, mistakes) -> {
                    line.parseArgs(given.asArguments().toArray(String[]::new));
                    check(given.isOnlyShown(), mistakes);
                    if (given.isOnlyShown()) {
                        checkStart(ServiceOptions.of(given).journal(), mistakes);
                    }
                })
                .read(arguments, System.getenv());
        return settings;
    }

    private void check(boolean onlyShown, Mistakes mistakes) {
        boolean undecided = port == null && !simulate;
        if ((port == null) != simulate && !(undecided && onlyShown)) {
            mistakes.add("choose a robot: --port PATH or --simulate");
        }
        Double wanted = speed;
        if (wanted != null && wanted != 1 && port != null && !simulate) {
            mistakes.add("--speed goes with --simulate; a real robot has its own pace");
        }
        String named = room;
        if (named != null && port != null && !simulate) {
            mistakes.add("--room goes with --simulate; a real robot is in a room already");
        }
        Room read = mistakes.tried(
                "room", Main::isUsersMistake, () -> RoomFile.named(named == null ? RoomFile.LIVING_ROOM_NAME : named));
        world = read == null ? Room.OPEN : read;
        options.check(simulate || undecided, mistakes);
    }

    /** What a start would refuse besides, but for what only the robot and other programs can tell. */
    private void checkStart(@Nullable Path journal, Mistakes mistakes) {
        mistakes.tried("mode-offset", Main::isUsersMistake, () -> robotOptions(pace()));
        RobotModels models = options.models();
        if (models == null || mistakes.tried("models", Main::isUsersMistake, this::builtWithoutRobot) == null) {
            return;
        }
        if (journal != null) {
            mistakes.tried("journal", Main::isUsersMistake, () -> {
                Journal.in(journal).check(models.pair());
                return journal;
            });
        }
    }

    private RobotModels builtWithoutRobot() {
        double pace = pace();
        try (Clock clock = new SystemClock(pace);
                RoombaConverter built = RoombaConverter.build(
                        config(clock, pace),
                        new RoombaSession(cable("none"), clock, sessionOptions(pace)),
                        options.read(pace, Optional.empty(), null))) {
            return built.models();
        }
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        try (Service service = Service.open(ServiceOptions.of(settings))) {
            String robotPort = port;
            if (robotPort != null) {
                return converse(service, robotPort, null);
            }
            try (SimulatedWorld simulated =
                    SimulatedWorld.inThisProcess(pace(), options.wantsSimulatedCamera(), world)) {
                return converse(service, simulated.port().toString(), simulated);
            }
        }
    }

    private double pace() {
        return speed == null ? 1 : speed;
    }

    /** Refuses a speed that clocks and simulator do not have. */
    static double requireSpeed(double speed) {
        if (!(speed >= SimulatorServer.SLOWEST && speed <= SimulatorServer.FASTEST)) {
            throw new IllegalArgumentException("--speed is " + speed + ", allowed is " + SimulatorServer.SLOWEST
                    + " to " + SimulatorServer.FASTEST + " times real time");
        }
        return speed;
    }

    private int converse(Service service, String robotPort, @Nullable SimulatedWorld world)
            throws IOException, InterruptedException {
        double pace = pace();
        Optional<Eyes> eyes = options.eyes(pace, world == null ? Optional.empty() : world.camera());
        ServiceOptions unattended = ServiceOptions.of(settings);
        RoombaOptions read = options.read(pace, eyes, unattended.journal());
        try (Clock clock = new SystemClock(pace);
                RobotGuard guard = world == null && !noGuard ? new RobotGuard(robotPort) : null;
                RoombaConverter roomba = connect(
                        guard == null ? cable(robotPort) : guard.cable(cable(robotPort)),
                        config(clock, pace, unattended.pressAge()),
                        read)) {
            if (guard != null) {
                roomba.converter().addLink(guard.watch(roomba.session()));
            }
            Console console = new Console(roomba.converter(), System.in, System.out, System.err);
            console.addCommand(ConsoleCommand.of(
                            "press BUTTON",
                            "presses a button of the external controller: " + String.join(", ", buttons(roomba)),
                            (arguments, out) -> roomba.controller().press(event(roomba.models(), arguments.get(0))))
                    .completing(before -> before.isEmpty() ? buttons(roomba) : List.of()));
            console.evolvesBy(new OtherModels(roomba));
            if (world != null) {
                console.addCommand(ConsoleCommand.of(
                                "robot COMMAND [ARGUMENT] [ARGUMENT] [ARGUMENT]",
                                "gives the simulated robot's world a command: robot press clean, robot place 500 0 "
                                        + "90, robot help",
                                (arguments, out) -> out.println(world.execute(String.join(" ", arguments))))
                        .completing(before -> before.isEmpty() ? WorldCommands.NAMES : WorldCommands.BUTTON_NAMES));
            }
            Page.open(PageOptions.of(settings), console, System.err, pictures(roomba, world, eyes));
            showAtHome(roomba, console);
            return service.run(console);
        }
    }

    private static List<String> buttons(RoombaConverter roomba) {
        return roomba.models().buttons().stream()
                .map(button -> button.toLowerCase(Locale.ROOT))
                .toList();
    }

    /** At a terminal a missing robot is an error at once; a service waits for it. */
    private RoombaConverter connect(IntFunction<Link> robot, LoopConfig config, RoombaOptions read)
            throws InterruptedException {
        SessionOptions how = robotOptions(pace());
        return ServiceOptions.of(settings).start()
                ? RoombaConverter.connectPatiently(robot, config, how, read)
                : RoombaConverter.connect(robot, config, how, read);
    }

    /** The robot from above, and what its camera sees. */
    private static List<Picture> pictures(RoombaConverter roomba, @Nullable SimulatedWorld world, Optional<Eyes> eyes) {
        Picture above = world == null
                ? DrivenPath.of(roomba.session())
                : new Picture(
                        "Room",
                        "The room from above: walls, dock and marker, the way that the robot has driven, and where it is",
                        "image/svg+xml",
                        () -> Picture.View.of(world.drawn().getBytes(StandardCharsets.UTF_8)));
        return Stream.concat(Stream.of(above), eyes.map(Eyes::picture).stream()).toList();
    }

    private void showAtHome(RoombaConverter roomba, Console console) {
        MqttOptions.broker(settings).ifPresent(broker -> {
            HomeAssistant home = new HomeAssistant(console, broker);
            home.vacuum(new RoombaVacuum(home, roomba.session(), roomba.converter()));
            home.open();
            console.onEnd(reason -> home.close());
        });
    }

    private SessionOptions robotOptions(double pace) {
        SessionOptions usual = sessionOptions(pace);
        Integer known = modeOffset;
        return known == null ? usual : usual.withModeOffset(known);
    }

    /** Each call is the cable plugged in again. */
    static IntFunction<Link> cable(String robotPort) {
        return baud -> SerialLink.open(new SerialSettings(robotPort).withBaud(baud));
    }

    /** The messages of a fast simulation may be late in real time if its computer is busy. */
    static SessionOptions sessionOptions(double pace) {
        SessionOptions usual = SessionOptions.defaults();
        return usual.withSilenceLimit(
                Duration.ofMillis(Math.round(usual.silenceLimit().toMillis() * Math.max(1, pace))));
    }

    /** The usual limits. */
    static LoopConfig config(Clock clock, double pace) {
        return config(clock, pace, ServiceOptions.none().pressAge());
    }

    /** Limits are in real time: a fast simulation does not make its computer faster, nor the people who press. */
    private static LoopConfig config(Clock clock, double pace, Duration pressAge) {
        LoopConfig usual = LoopConfig.defaults("roomba", clock);
        return usual.withStepLimit(atLeast(usual.stepLimit(), pace)).withPressAge(atLeast(pressAge, pace));
    }

    private static Duration atLeast(Duration real, double pace) {
        return Duration.ofMillis(Math.round(real.toMillis() * Math.max(1, pace)));
    }

    private static String event(RobotModels models, String button) {
        List<String> known = models.buttons();
        String meant = Names.meant(button, known).toLowerCase(Locale.ROOT);
        return known.stream()
                .filter(name -> name.equalsIgnoreCase(button))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("the controller has no button " + button
                        + (meant.isEmpty()
                                ? "; it has "
                                        + String.join(", ", known)
                                                .toLowerCase(Locale.ROOT)
                                                .replaceFirst(", (?=[^,]*$)", " and ")
                                : meant)));
    }
}
