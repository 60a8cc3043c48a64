package org.evoloop.roomba;

import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import org.evoloop.config.Options;
import org.evoloop.console.TerminationSignals;
import org.evoloop.converter.edge.EdgeShell;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.MqttOptions;
import org.evoloop.mqtt.edge.EdgeDevice;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.time.SystemClock;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** A robot whose events a fleet decides: the converter's parts at the robot without its loop. */
@Command(
        name = "edge",
        description = {
            "Lets a Roomba take part in a fleet, until it gets SIGTERM: reports what happens at the robot to the "
                    + "fleet's gateway, and does what the fleet decides. The new functions run here."
        },
        mixinStandardHelpOptions = true,
        sortOptions = false,
        footer = {"", "Exit status: 0 success, 2 wrong usage or input."})
final class EdgeCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(
            names = "--port",
            required = true,
            paramLabel = "PATH",
            description = "The robot's serial port, such as /dev/ttyUSB0.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String port;

    @Option(names = "--device", required = true, paramLabel = "ID", description = "The robot's id in the fleet.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String device;

    @Option(
            names = "--mqtt",
            required = true,
            paramLabel = "URL",
            description = "The gateway's MQTT broker: mqtt://USER@HOST, or mqtts://USER@HOST with TLS; the password is "
                    + "taken from the environment variable EVOLOOP_MQTT_PASSWORD.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String mqtt;

    @Option(
            names = "--journal",
            required = true,
            paramLabel = "DIR",
            description = "Stores what the gateway has not received yet, and which command was carried out last.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path directory;

    @Option(
            names = "--no-guard",
            description = "Does not start the guard process, which stops the robot when this program is killed or "
                    + "frozen.")
    private boolean noGuard;

    @Mixin
    private final ConverterOptions options = new ConverterOptions();

    @Override
    public Integer call() throws InterruptedException {
        EdgeDevice.requireTopicName("--device", device);
        BrokerAddress broker = MqttOptions.brokerAt(mqtt);
        options.checkRanges();
        Options.of()
                .checking((settings, mistakes) -> options.check(false, mistakes))
                .read(List.of(), Map.of());
        RoombaOptions read = options.read(1, options.eyes(1, Optional.empty()), null);
        SystemClock clock = new SystemClock();
        PrintWriter out = spec.commandLine().getOut();
        try (EdgeDevice edge = new EdgeDevice(device, broker, directory, clock, Clock.systemUTC(), how -> {
            out.println(how);
            out.flush();
        })) {
            serve(edge, clock, read);
        } catch (UncheckedIOException unusable) {
            throw new IllegalArgumentException(
                    "--journal: " + unusable.getMessage() + "; give a directory that this program may write", unusable);
        }
        return 0;
    }

    private void serve(EdgeDevice edge, SystemClock clock, RoombaOptions read) throws InterruptedException {
        LoopConfig config = RoombaCommand.config(clock, 1);
        try (RobotGuard guard = noGuard ? null : new RobotGuard(port)) {
            RoombaSession session = new RoombaSession(
                    guard == null ? RoombaCommand.cable(port) : guard.cable(RoombaCommand.cable(port)),
                    clock,
                    SessionOptions.defaults());
            EdgeShell shell = shell(config, session, read, edge);
            try {
                // The models come first: if they are wrong, no robot is touched.
                shell.open();
                if (guard != null) {
                    guard.watch(session);
                }
                session.open();
                session.awaitRobot();
                RoombaConverter.greeting(read).forEach(session::send);
                edge.open(shell);
                CountDownLatch ended = new CountDownLatch(1);
                TerminationSignals signals = new TerminationSignals(signal -> ended.countDown());
                ended.await();
                // A second signal ends it at once.
                signals.restore();
            } finally {
                edge.close();
                shell.close();
                session.close();
                clock.close();
            }
        }
    }

    /** The parts of a {@link RoombaConverter} around its core. */
    static EdgeShell shell(LoopConfig config, RoombaSession session, RoombaOptions options, EdgeShell.Decider decider) {
        Resumption resumption = new Resumption();
        RobotModels models = options.models();
        KnowledgeState knowledge = RoombaConverter.knowledge(models, session, options, resumption);
        EdgeShell shell = new EdgeShell(config, knowledge, decider);
        shell.addMonitor(new MonitorEvent(
                session, models.pair().original(), event -> models.restartsMove(knowledge.getCurrentState(), event)));
        RoombaConverter.day(options).timetable().ifPresent(shell::addMonitor);
        shell.addExecute(new ExecuteCommand(session, models.pair().original(), config.clock(), resumption));
        // Whatever moved before another process ended: the robot does not drive on by itself.
        resumption.released();
        return shell;
    }
}
