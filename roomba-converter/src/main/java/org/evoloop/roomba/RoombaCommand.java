package org.evoloop.roomba;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import org.evoloop.config.Mistakes;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.journal.Journal;
import org.evoloop.link.Link;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.MqttOptions;
import org.evoloop.page.PageOptions;
import org.evoloop.page.Picture;
import org.evoloop.program.Program;
import org.evoloop.program.ProgramSetup;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.WorldCommands;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.RoomFile;
import org.evoloop.service.ServiceOptions;
import org.evoloop.statemachine.Names;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** The Roomba converter as a program: a robot, a converter and its console. */
@Command(
        name = "roomba",
        description = "Gives a Roomba new functions: converts its events between the original and the new model.",
        footer = "%nctl NAME COMMAND gives a command to the one that was started with --name NAME (ctl --help).",
        mixinStandardHelpOptions = true)
final class RoombaCommand {
    @Mixin
    private final ConverterOptions options = new ConverterOptions();

    @CommandLine.Option(
            names = "--port",
            paramLabel = "PATH",
            description = "The robot's serial port, such as /dev/ttyUSB0.")
    private @Nullable String port;

    @CommandLine.Option(names = "--simulate", description = "Starts a simulated robot and connects to it.")
    private boolean simulate;

    @CommandLine.Option(
            names = "--speed",
            paramLabel = "N",
            description = "With --simulate: time passes N times as fast, 0.01 to 1000 (default: 1).")
    private @Nullable Double speed;

    @CommandLine.Option(
            names = "--room",
            paramLabel = "FILE",
            description = "With --simulate: the room in which the robot lives, a file as in simulator --help, or "
                    + RoomFile.LIVING_ROOM_NAME + ", which has a dock and a marker (default: "
                    + RoomFile.LIVING_ROOM_NAME + ").")
    private @Nullable String room;

    private Room world = Room.OPEN;

    @CommandLine.Option(
            names = "--mode-offset",
            paramLabel = "N",
            description = "What the robot adds to the mode it reports: 1 for some 600 models with Wi-Fi, else 0 "
                    + "(default: found out when it answers).")
    private @Nullable Integer modeOffset;

    @CommandLine.Option(
            names = "--no-guard",
            description = "With --port: does not start the guard process, which stops the robot when this program is "
                    + "killed or frozen. A simulated robot has none.")
    private boolean noGuard;

    /** Its options, those in its fields and those that are declared where they are implemented. */
    Options options() {
        return ConverterOptions.refined(Options.annotated(this))
                .refined("speed", speeds -> speeds.checkedBy(text -> requireSpeed(Double.parseDouble(text))))
                .refined(
                        "room",
                        rooms -> rooms.placedBy((folder, text) ->
                                text.equals(RoomFile.LIVING_ROOM_NAME) ? text : Option.resolved(folder, text)))
                .refined(
                        "port",
                        ports -> ports.placedBy(
                                (folder, text) -> text.contains("/") ? Option.resolved(folder, text) : text))
                .alternatives("port", "simulate")
                .and(ServiceOptions.OPTIONS, PageOptions.OPTIONS, MqttOptions.OPTIONS)
                .checking((given, mistakes) -> {
                    check(given.isOnlyShown(), mistakes);
                    if (given.isOnlyShown()) {
                        checkStart(ServiceOptions.of(given).journal(), mistakes);
                    }
                });
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

    /** Runs the converter with options that have been read. */
    int run(Settings settings) throws IOException, InterruptedException {
        return Program.named("roomba", "").converter(this::assemble).run(settings);
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

    private void assemble(ProgramSetup setup) throws IOException, InterruptedException {
        double pace = pace();
        String real = port;
        SimulatedWorld simulated = real == null
                ? setup.closing(SimulatedWorld.inThisProcess(pace, options.wantsSimulatedCamera(), world))
                : null;
        Optional<Eyes> eyes = options.eyes(pace, simulated == null ? Optional.empty() : simulated.camera());
        ServiceOptions unattended = ServiceOptions.of(setup.settings());
        RoombaOptions read = options.read(pace, eyes, unattended.journal());
        Clock clock = setup.closing(new SystemClock(pace));
        RobotGuard guard = real == null || noGuard ? null : setup.closing(new RobotGuard(real));
        IntFunction<Link> robot = cable(
                simulated == null ? requireNonNull(real) : simulated.port().toString());
        RoombaConverter roomba = setup.closing(connect(
                guard == null ? robot : guard.cable(robot),
                config(clock, pace, unattended.pressAge()),
                read,
                unattended.start()));
        setup.uses(roomba.converter());
        if (guard != null) {
            roomba.converter().addLink(guard.watch(roomba.session()));
        }
        setup.command(ConsoleCommand.press(
                        "press BUTTON",
                        "presses a button of the external controller: " + String.join(", ", buttons(roomba)),
                        roomba.controller(),
                        arguments -> event(roomba.models(), arguments.get(0)))
                .completing(before -> before.isEmpty() ? buttons(roomba) : List.of()));
        setup.evolvesBy(new OtherModels(roomba));
        if (simulated != null) {
            setup.command(ConsoleCommand.of(
                            "robot COMMAND [ARGUMENT] [ARGUMENT] [ARGUMENT]",
                            "gives the simulated robot's world a command: robot press clean, robot place 500 0 "
                                    + "90, robot help",
                            (arguments, out) -> out.println(simulated.execute(String.join(" ", arguments))))
                    .completing(before -> before.isEmpty() ? WorldCommands.NAMES : WorldCommands.BUTTON_NAMES));
        }
        setup.picture(above(roomba, simulated));
        eyes.map(Eyes::picture).ifPresent(setup::picture);
        boolean waits = roomba.models().functions().containsValue(RobotFunction.QUIET_HOURS);
        setup.home(home -> {
            home.entity(new RoombaVacuum(roomba.session(), roomba.converter()).entity());
            roomba.day().settings(clock, waits).forEach(home::setting);
        });
    }

    private static List<String> buttons(RoombaConverter roomba) {
        return roomba.models().buttons().stream()
                .map(button -> button.toLowerCase(Locale.ROOT))
                .toList();
    }

    /** At a terminal a missing robot is an error at once; a service waits for it. */
    private RoombaConverter connect(IntFunction<Link> robot, LoopConfig config, RoombaOptions read, boolean patiently)
            throws InterruptedException {
        SessionOptions how = robotOptions(pace());
        return patiently
                ? RoombaConverter.connectPatiently(robot, config, how, read)
                : RoombaConverter.connect(robot, config, how, read);
    }

    private static Picture above(RoombaConverter roomba, @Nullable SimulatedWorld world) {
        return world == null
                ? DrivenPath.of(roomba.session())
                : new Picture(
                        "Room",
                        "The room from above: walls, dock and marker, the way that the robot has driven, and where it"
                                + " is",
                        "image/svg+xml",
                        () -> Picture.View.of(world.drawn().getBytes(StandardCharsets.UTF_8)));
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
