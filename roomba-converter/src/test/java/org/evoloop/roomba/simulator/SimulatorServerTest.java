package org.evoloop.roomba.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketId;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.oi.StreamFramer;
import org.evoloop.roomba.simulator.eye.Effects;
import org.evoloop.roomba.simulator.eye.EyeOptions;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.RandomRooms;
import org.evoloop.roomba.simulator.webcam.Webcam;
import org.evoloop.roomba.simulator.webcam.WebcamOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@EnabledOnOs(OS.LINUX)
@Timeout(60)
class SimulatorServerTest {
    private static final List<PacketId> WATCHED =
            List.of(Packet.BUTTONS, Packet.CURRENT, Packet.OI_MODE, Packet.LEFT_ENCODER);
    private static final Command START = new Command.Start();
    private static final Command SAFE = new Command.Safe();
    private static final Duration TICK = Duration.ofMillis(15);

    @TempDir
    Path folder;

    /** A client of the serial port, like the application. */
    private static final class Client implements AutoCloseable {
        private final List<SensorValues> frames = new CopyOnWriteArrayList<>();
        private final StreamFramer framer = new StreamFramer(WATCHED);
        private final Link link;
        private final CompletableFuture<LinkException> lost;
        private final AtomicInteger bytes = new AtomicInteger();

        Client(Path port) {
            this(port, new CompletableFuture<>());
        }

        Client(Path port, CompletableFuture<LinkException> lost) {
            this(new SerialSettings(port.toString()), lost);
        }

        Client(Path port, int baud) {
            this(new SerialSettings(port.toString()).withBaud(baud), new CompletableFuture<>());
        }

        private Client(SerialSettings settings, CompletableFuture<LinkException> lost) {
            this.lost = lost;
            link = SerialLink.open(settings);
            Thread reader = new Thread(this::read, "client");
            reader.setDaemon(true);
            reader.start();
        }

        private void read() {
            byte[] buffer = new byte[1_024];
            for (int length = link.receive(buffer); length > 0; length = link.receive(buffer)) {
                bytes.addAndGet(length);
                frames.addAll(framer.feed(buffer, 0, length));
            }
            LinkException cause = link.loss();
            if (cause != null) {
                lost.complete(cause);
            }
        }

        void send(Command... commands) {
            for (Command command : commands) {
                link.send(command.bytes());
            }
        }

        @Override
        public void close() {
            link.close();
        }
    }

    private Path port() {
        return folder.resolve("roomba");
    }

    @Test
    void aClientSeesASpotFromPressToEnd() throws IOException {
        RobotOptions options = RobotOptions.builder().spotDurationMillis(10_000).build();
        try (ManualClock clock = new ManualClock();
                SimulatorServer server = SimulatorServer.start(port(), options, clock, 20);
                Client client = new Client(server.path())) {
            client.send(START, SAFE, START, new InputCommand.Stream(WATCHED));
            await().until(() -> server.robot().state().streaming());
            assertThat(new WorldCommands(server.robot()).execute("press spot")).isEqualTo("ok");
            while (server.robot().state().activity() != RobotActivity.SPOT) {
                untilRead(client, clock, 20);
            }
            while (server.robot().state().activity() != RobotActivity.ON) {
                untilRead(client, clock, 20);
            }
            untilRead(client, clock, 20);

            List<SensorValues> frames = List.copyOf(client.frames);
            assertThat(frames.stream().filter(frame -> frame.currentMilliAmps() < -300))
                    .as("10 s of cleaning")
                    .hasSizeBetween(640, 690);
            assertThat(frames).anyMatch(frame -> frame.value(Packet.BUTTONS) == 2);
            assertThat(frames).allMatch(frame -> frame.mode().orElseThrow() == OiMode.PASSIVE);
        }
    }

    /** Lets one tick pass at this speed, and waits until the client has read what was sent in it: no frame is dropped. */
    private static void untilRead(Client client, ManualClock clock, int speed) {
        int before = client.frames.size();
        clock.advance(TICK);
        await().pollInterval(Duration.ofMillis(1)).until(() -> client.frames.size() >= before + speed);
    }

    @Test
    void theRobotContinuesWhileClientsComeAndGo() throws IOException {
        try (Clock clock = new SystemClock();
                SimulatorServer server = SimulatorServer.start(port(), RobotOptions.defaults(), clock, 5)) {
            try (Client first = new Client(server.path())) {
                first.send(START, SAFE, new DriveDirect(100, 100), new InputCommand.Stream(WATCHED));
                await().until(() -> first.frames.size() > 5);
            }
            double leftAtMm = server.robot().state().xMm();
            await().until(() -> server.robot().state().xMm() > leftAtMm + 50);
            try (Client second = new Client(server.path())) {
                await().until(() -> second.frames.size() > 5);
                assertThat(second.frames.get(5).mode()).contains(OiMode.SAFE);
            }
        }
    }

    @Test
    void theRobotLivesOnWhileItsCableIsUnplugged() throws Exception {
        try (Clock clock = new SystemClock();
                SimulatorServer server = SimulatorServer.start(port(), RobotOptions.defaults(), clock, 5)) {
            WorldCommands world = new WorldCommands(server);
            CompletableFuture<LinkException> lost = new CompletableFuture<>();
            try (Client first = new Client(server.path(), lost)) {
                first.send(START, SAFE, new DriveDirect(100, 100), new InputCommand.Stream(WATCHED));
                await().until(() -> first.frames.size() > 5);
                assertThat(world.execute("replug")).isEqualTo("error: the cable is plugged in already");
                assertThat(world.execute("unplug")).isEqualTo("ok");
                assertThat(lost.get(10, TimeUnit.SECONDS)).isNotNull();
            }
            assertThat(world.execute("unplug")).isEqualTo("error: the cable is unplugged already");
            assertThat(Files.exists(port(), LinkOption.NOFOLLOW_LINKS)).isFalse();
            double leftAtMm = server.robot().state().xMm();
            await().until(() -> server.robot().state().xMm() > leftAtMm + 50);
            assertThat(world.execute("replug")).isEqualTo("ok");
            try (Client second = new Client(server.path())) {
                await().until(() -> second.frames.size() > 5);
                assertThat(second.frames.get(5).mode()).contains(OiMode.SAFE);
            }
        }
    }

    @Test
    void openingThePortWakesTheRobotUnlessItIsSleepy() throws IOException {
        for (boolean sleepy : new boolean[] {false, true}) {
            RobotOptions options = RobotOptions.builder().sleepy(sleepy).build();
            try (ManualClock clock = new ManualClock();
                    SimulatorServer server = SimulatorServer.start(port(), options, clock, 1_000)) {
                try (Client client = new Client(server.path())) {
                    client.send(START);
                    await().until(() -> server.robot().state().oiMode() == OiMode.PASSIVE);
                }
                // 301 s of the robot's time.
                clock.advance(Duration.ofMillis(301));
                await().until(() -> server.robot().state().asleep());
                try (Client client = new Client(server.path())) {
                    client.send(START, new InputCommand.Stream(WATCHED));
                    if (sleepy) {
                        clock.advance(Duration.ofMillis(2));
                        await().until(() -> server.robot().state().timeMillis() >= 302_000);
                        assertThat(server.robot().state().asleep()).isTrue();
                        server.robot().press(Button.CLEAN);
                        client.send(START, new InputCommand.Stream(WATCHED));
                    }
                    await().until(() -> server.robot().state().streaming());
                    assertThat(server.robot().state().asleep()).isFalse();
                }
            }
        }
    }

    @Test
    void aClientWithAnotherBaudRateReceivesGarbage() throws IOException {
        RobotOptions options = RobotOptions.builder().baud(19_200).build();
        try (Clock clock = new SystemClock();
                SimulatorServer server = SimulatorServer.start(port(), options, clock, 5)) {
            try (Client right = new Client(server.path(), 19_200)) {
                right.send(START, new InputCommand.Stream(WATCHED));
                await().until(() -> right.frames.size() > 5);
            }
            try (Client wrong = new Client(server.path(), 115_200)) {
                await().until(() -> wrong.bytes.get() > 500);
                assertThat(wrong.frames).isEmpty();
            }
            try (Client right = new Client(server.path(), 19_200)) {
                await().until(() -> right.frames.size() > 5);
                right.send(new Command.Baud(57_600));
                await().until(() -> server.robot().baud() == 57_600);
            }
            try (Client right = new Client(server.path(), 57_600)) {
                await().until(() -> right.frames.size() > 5);
            }
        }
    }

    @Test
    void timeIsTheClocks() throws IOException {
        try (ManualClock clock = new ManualClock();
                SimulatorServer server = SimulatorServer.start(port(), RobotOptions.defaults(), clock, 2);
                RandomAccessFile client = new RandomAccessFile(server.path().toFile(), "rw")) {
            client.write(new byte[] {(byte) 128, (byte) 132});
            await().until(() -> server.robot().state().oiMode() == OiMode.FULL);
            assertThat(server.robot().state().timeMillis())
                    .as("commands need no tick")
                    .isZero();
            clock.advance(TICK.multipliedBy(10));
            await().until(() -> server.robot().state().timeMillis() == 300);
            clock.advance(Duration.ofSeconds(1));
            await().until(() -> server.robot().state().timeMillis() == 2_295);
        }
    }

    @Test
    void anUnboundedLagIsGivenUp() throws IOException {
        try (ManualClock clock = new ManualClock();
                SimulatorServer server = SimulatorServer.start(port(), RobotOptions.defaults(), clock, 1)) {
            clock.advance(Duration.ofHours(1));
            await().until(() -> server.robot().state().timeMillis() > 0);
            clock.advance(TICK);
            await().until(() -> server.robot().state().timeMillis() >= 30);
            RobotState state = server.robot().state();
            assertThat(state.timeMillis()).isEqualTo(30);
        }
    }

    @Test
    void theRobotsCameraShowsWhereItIs() throws Exception {
        RobotOptions options =
                RobotOptions.builder().room(RandomRooms.withMarker(7)).build();
        WebcamOptions camera = WebcamOptions.defaults()
                .withEye(EyeOptions.defaults().withSize(160, 120).withEffects(Effects.CLEAN));
        HttpClient http = HttpClient.newHttpClient();
        try (Clock clock = new SystemClock();
                SimulatorServer server =
                        SimulatorServer.start(port(), options, clock, 5, state -> {}, Optional.of(camera))) {
            URI url = server.camera().orElseThrow().url().resolve("/frame.jpg");
            HttpRequest request = HttpRequest.newBuilder(url).build();
            byte[] before =
                    http.send(request, HttpResponse.BodyHandlers.ofByteArray()).body();
            assertThat(http.send(request, HttpResponse.BodyHandlers.ofByteArray())
                            .body())
                    .isEqualTo(before);
            WorldCommands world = new WorldCommands(server);
            Pose start = options.room().start();
            assertThat(world.execute(String.format(
                            Locale.ROOT, "place %.3f %.3f %.3f", start.xMm(), start.yMm(), start.headingDeg() + 10)))
                    .isEqualTo("ok");
            assertThat(http.send(request, HttpResponse.BodyHandlers.ofByteArray())
                            .body())
                    .isNotEqualTo(before);
            assertThat(world.execute("camera unplug")).isEqualTo("ok");
            assertThat(world.execute("camera unplug")).isEqualTo("error: the camera is unplugged already");
            assertThatThrownBy(() -> http.send(request, HttpResponse.BodyHandlers.ofByteArray()))
                    .isInstanceOf(ConnectException.class);
            for (String command : List.of("camera replug", "camera stall", "camera resume", "camera damage 0.5")) {
                assertThat(world.execute(command)).as(command).isEqualTo("ok");
            }
            assertThat(world.execute("camera damage 2")).isEqualTo("error: P is '2'; allowed is 0 to 1");
            assertThat(world.execute("camera damage"))
                    .isEqualTo("error: the command is 'camera stall|resume|unplug|replug|damage P'");
            assertThat(world.execute("camera smile"))
                    .isEqualTo("error: the command is 'camera stall|resume|unplug|replug|damage P'");
        }
    }

    @Test
    void aCameraWithoutItsPortLeavesNothingBehind() throws IOException {
        try (Clock clock = new ManualClock();
                Webcam other = Webcam.start(WebcamOptions.defaults())) {
            WebcamOptions taken = WebcamOptions.defaults().withPort(other.url().getPort());
            assertThatThrownBy(() -> SimulatorServer.start(
                            port(), RobotOptions.defaults(), clock, 1, state -> {}, Optional.of(taken)))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("cannot be used");
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void afterCloseNothingIsLeft() throws IOException {
        Path port = port();
        try (Clock clock = new SystemClock()) {
            SimulatorServer server = SimulatorServer.start(port, RobotOptions.defaults(), clock, 1);
            assertThat(server.path()).isEqualTo(port).isSymbolicLink();
            server.close();
            server.close();
        }
        assertThat(Files.exists(port, LinkOption.NOFOLLOW_LINKS)).isFalse();
        assertThat(Thread.getAllStackTraces().keySet())
                .extracting(Thread::getName)
                .doesNotContain("roomba-simulator");
    }

    @Test
    void anImpossibleSpeedIsRefused() {
        try (Clock clock = new ManualClock()) {
            for (double speed : new double[] {0, -1, 1_001, Double.NaN}) {
                assertThatThrownBy(() -> SimulatorServer.start(port(), RobotOptions.defaults(), clock, speed))
                        .isInstanceOf(IllegalArgumentException.class)
                        .hasMessage("speed is " + speed + "; allowed is 0.01 to 1000.0 times real time");
            }
        }
        assertThat(folder).isEmptyDirectory();
    }
}
