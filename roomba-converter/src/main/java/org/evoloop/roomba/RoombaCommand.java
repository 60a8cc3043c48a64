package org.evoloop.roomba;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.IntFunction;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.HomeAssistant;
import org.evoloop.page.Page;
import org.evoloop.page.PageOptions;
import org.evoloop.page.Picture;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.SerialLink;
import org.evoloop.roomba.link.SerialSettings;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.WorldCommands;
import org.evoloop.service.Service;
import org.evoloop.statemachine.Names;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
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
    @Mixin
    private final ConverterOptions options = new ConverterOptions();

    @Mixin
    private final Unattended unattended = new Unattended();

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
            names = "--mode-offset",
            paramLabel = "N",
            description = "What the robot adds to the mode it reports: 1 for some 600 models with Wi-Fi, else 0 "
                    + "(default: found out when it answers).")
    private @Nullable Integer modeOffset;

    @Option(
            names = "--no-guard",
            description =
                    "With --port: starts no guard process, which stops the robot when this program is killed or stands "
                            + "still. A simulated robot has none.")
    private boolean noGuard;

    private @Nullable BrokerAddress broker;

    @Override
    public Integer call() throws IOException, InterruptedException {
        double pace = checkedSpeed();
        PageOptions shown = unattended.page();
        broker = unattended.broker();
        try (Service service = Service.open(unattended.options())) {
            String robotPort = port;
            if (robotPort != null) {
                return converse(service, shown, robotPort, options.read(pace, Optional.empty()), pace, null);
            }
            try (SimulatedWorld world = SimulatedWorld.inThisProcess(pace, options.wantsSimulatedCamera())) {
                return converse(
                        service, shown, world.port().toString(), options.read(pace, world.camera()), pace, world);
            }
        }
    }

    private double checkedSpeed() {
        if ((port == null) != simulate) {
            throw new IllegalArgumentException("say which robot: --port PATH or --simulate");
        }
        Double wanted = speed;
        if (wanted == null) {
            return 1;
        }
        if (!simulate) {
            throw new IllegalArgumentException("--speed goes with --simulate; a real robot has its own pace");
        }
        return requireSpeed(wanted);
    }

    /** Refuses a speed that clocks and simulator do not have. */
    static double requireSpeed(double speed) {
        if (!(speed >= SimulatorServer.SLOWEST && speed <= SimulatorServer.FASTEST)) {
            throw new IllegalArgumentException("--speed is " + speed + ", allowed is " + SimulatorServer.SLOWEST
                    + " to " + SimulatorServer.FASTEST + " times real time");
        }
        return speed;
    }

    private int converse(
            Service service,
            PageOptions shown,
            String robotPort,
            RoombaOptions read,
            double pace,
            @Nullable SimulatedWorld world)
            throws IOException, InterruptedException {
        try (Clock clock = new SystemClock(pace);
                RobotGuard guard = world == null && !noGuard ? new RobotGuard(robotPort) : null;
                RoombaConverter roomba = RoombaConverter.connect(
                        guard == null ? cable(robotPort) : guard.cable(cable(robotPort)),
                        config(clock, pace),
                        robotOptions(pace),
                        read)) {
            if (guard != null) {
                roomba.converter().addLink(guard.watch(roomba.session()));
            }
            List<String> buttons = read.models().buttons().stream()
                    .map(button -> button.toLowerCase(Locale.ROOT))
                    .toList();
            Console console = new Console(roomba.converter(), System.in, System.out, System.err);
            console.addCommand(ConsoleCommand.of(
                            "press BUTTON",
                            "presses a button of the external controller: " + String.join(", ", buttons),
                            (arguments, out) -> roomba.controller().press(event(read.models(), arguments.get(0))))
                    .completing(before -> before.isEmpty() ? buttons : List.of()));
            if (world != null) {
                console.addCommand(ConsoleCommand.of(
                                "robot COMMAND [ARGUMENT] [ARGUMENT] [ARGUMENT]",
                                "tells the simulated robot's world something: robot press clean, robot place 500 0 90, robot help",
                                (arguments, out) -> out.println(world.execute(String.join(" ", arguments))))
                        .completing(before -> before.isEmpty() ? WorldCommands.NAMES : WorldCommands.BUTTON_NAMES));
            }
            Page.open(shown, console, System.err, world == null ? List.of() : pictures(world));
            showAtHome(roomba, console);
            return service.run(console);
        }
    }

    /** What can be seen of a simulated robot, from above and with its own eye. */
    private static List<Picture> pictures(SimulatedWorld world) {
        Picture room = new Picture(
                "Room",
                "The room from above: walls, dock and marker, the way that the robot has driven, and where it is",
                "image/svg+xml",
                () -> world.drawn().getBytes(StandardCharsets.UTF_8));
        Picture sight =
                new Picture("Camera", "What the robot's camera saw last, while Move looked", "image/jpeg", world::seen);
        return world.camera().isPresent() ? List.of(room, sight) : List.of(room);
    }

    private void showAtHome(RoombaConverter roomba, Console console) {
        BrokerAddress address = broker;
        if (address != null) {
            SystemEventConverter converter = roomba.converter();
            HomeAssistant home = new HomeAssistant(converter, address);
            home.vacuum(new RoombaVacuum(
                    home, roomba.session(), converter.knowledge().models()));
            home.open();
            console.onEnd(reason -> home.close());
        }
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

    /** What a fast simulation sends may come late by as much as its computer is busy, in real time. */
    static SessionOptions sessionOptions(double pace) {
        SessionOptions usual = SessionOptions.defaults();
        return usual.withSilenceLimit(
                Duration.ofMillis(Math.round(usual.silenceLimit().toMillis() * Math.max(1, pace))));
    }

    /** Limits are meant in real time: a simulation that runs fast is not served faster by its computer. */
    static LoopConfig config(Clock clock, double pace) {
        LoopConfig usual = LoopConfig.defaults("roomba", clock);
        return usual.withStepLimit(
                Duration.ofMillis(Math.round(usual.stepLimit().toMillis() * Math.max(1, pace))));
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
