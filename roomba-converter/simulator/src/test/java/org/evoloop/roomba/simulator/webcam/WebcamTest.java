package org.evoloop.roomba.simulator.webcam;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.imageio.ImageIO;
import org.evoloop.HalfRequests;
import org.evoloop.roomba.simulator.eye.CameraImage;
import org.evoloop.roomba.simulator.eye.Effects;
import org.evoloop.roomba.simulator.eye.Eye;
import org.evoloop.roomba.simulator.eye.EyeOptions;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.RandomRooms;
import org.evoloop.roomba.simulator.room.Room;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(60)
class WebcamTest {
    private static final Duration LIMIT = Duration.ofSeconds(40);
    private static final EyeOptions SMALL = EyeOptions.defaults().withSize(160, 120);
    private static final WebcamOptions CAMERA = WebcamOptions.defaults().withEye(SMALL);
    private static final Room ROOM = RandomRooms.withMarker(3);

    private final HttpClient http = HttpClient.newHttpClient();
    private final SimulatedRoomba robot =
            new SimulatedRoomba(RobotOptions.builder().room(ROOM).build(), bytes -> {});
    private final Webcam webcam;

    WebcamTest() throws IOException {
        webcam = Webcam.start(CAMERA);
    }

    @AfterEach
    void close() {
        webcam.close();
    }

    /** Reads a stream as it arrives, on its own thread. */
    private static final class Viewer {
        final BlockingQueue<byte[]> pictures = new LinkedBlockingQueue<>();
        final AtomicBoolean ended = new AtomicBoolean();
        private final InputStream body;

        Viewer(HttpResponse<InputStream> response) {
            assertThat(response.headers().firstValue("Content-Type"))
                    .contains("multipart/x-mixed-replace; boundary=evoloop-frame");
            body = response.body();
            Thread thread = new Thread(this::read, "viewer");
            thread.setDaemon(true);
            thread.start();
        }

        private void read() {
            try (DataInputStream input = new DataInputStream(body)) {
                while (true) {
                    int length = 0;
                    for (String line = line(input); !line.isEmpty(); line = line(input)) {
                        length = line.startsWith("Content-Length: ") ? Integer.parseInt(line.substring(16)) : length;
                    }
                    byte[] picture = new byte[length];
                    input.readFully(picture);
                    assertThat(line(input)).isEmpty();
                    pictures.add(picture);
                }
            } catch (IOException hungUp) {
                ended.set(true);
            }
        }

        private static String line(InputStream input) throws IOException {
            StringBuilder line = new StringBuilder();
            for (int next = input.read(); next != '\n'; next = input.read()) {
                if (next < 0) {
                    throw new EOFException();
                }
                if (next != '\r') {
                    line.append((char) next);
                }
            }
            return line.toString();
        }

        void leave() throws IOException {
            body.close();
        }
    }

    private Viewer view() throws IOException, InterruptedException {
        int before = webcam.clients();
        Viewer viewer = new Viewer(get("/stream"));
        await().until(() -> webcam.clients() == before + 1);
        return viewer;
    }

    private HttpResponse<InputStream> get(String path) throws IOException, InterruptedException {
        return http.send(request(path), BodyHandlers.ofInputStream());
    }

    private HttpRequest request(String path) {
        return HttpRequest.newBuilder(webcam.url().resolve(path)).build();
    }

    private void ticks(int count) {
        for (int i = 0; i < count; i++) {
            robot.tick();
            webcam.accept(robot.state());
        }
    }

    /** Lets time pass until a viewer has this many more pictures. */
    private void untilSeen(Viewer viewer, int more) {
        int wanted = viewer.pictures.size() + more;
        await().atMost(LIMIT).pollInterval(Duration.ofMillis(1)).until(() -> {
            ticks(3);
            return viewer.pictures.size() >= wanted;
        });
    }

    @Test
    void clientsSeeWhatTheEyeSees() throws Exception {
        Viewer one = view();
        Viewer other = view();
        untilSeen(one, 3);
        untilSeen(other, 3);
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(one.pictures.take()));
        CameraImage truth = new Eye(SMALL.withEffects(Effects.CLEAN)).render(ROOM, ROOM.start(), 0, 0);
        assertThat(image.getWidth()).isEqualTo(160);
        assertThat(image.getHeight()).isEqualTo(120);
        // On the bright side, where a typical camera's levels differ from a clean one's by a tenth at most.
        double difference = 0;
        for (int y = 0; y < 120; y++) {
            int at = (y * 160 + 146) * 3;
            int rgb = image.getRGB(146, y);
            difference += Math.abs((rgb >> 16 & 0xFF) - (truth.bgr()[at + 2] & 0xFF))
                    + Math.abs((rgb & 0xFF) - (truth.bgr()[at] & 0xFF));
        }
        assertThat(difference / 240).as("red is red and blue is blue").isLessThan(25);
    }

    @Test
    void nothingIsDrawnWithoutViewers() throws Exception {
        ticks(500);
        assertThat(webcam.drawn()).isZero();
        Viewer viewer = view();
        untilSeen(viewer, 1);
        viewer.leave();
        await().until(() -> {
            ticks(3);
            return webcam.clients() == 0;
        });
        // Everything that was requested before has been drawn once this one is.
        byte[] last = picture();
        long drawn = webcam.drawn();
        ticks(500);
        assertThat(last).isNotEmpty();
        assertThat(webcam.drawn()).isEqualTo(drawn);
    }

    /** Requests one picture while time passes. */
    private byte[] picture() {
        var answer = http.sendAsync(request("/frame.jpg"), BodyHandlers.ofByteArray());
        await().until(() -> {
            ticks(3);
            return answer.isDone();
        });
        assertThat(answer.join().statusCode()).isEqualTo(200);
        await().until(() -> webcam.clients() == 0);
        return answer.join().body();
    }

    @Test
    void picturesComeAsOftenAsTheRobotsTimeSays() throws Exception {
        try (Webcam slow = Webcam.start(CAMERA.withFramesPerSecond(10))) {
            http.send(HttpRequest.newBuilder(slow.url()).build(), BodyHandlers.ofInputStream());
            await().until(() -> slow.clients() == 1);
            for (int tick = 1; tick <= 200; tick++) {
                robot.tick();
                slow.accept(robot.state());
                // Frame 0 shows the first tick; then one every 100 ms.
                int frames = 1 + tick * SimulatedRoomba.TICK_MILLIS / 100;
                await().pollInterval(Duration.ofMillis(1)).until(() -> slow.drawn() == frames);
            }
            assertThat(slow.drawn()).isEqualTo(31);
        }
    }

    @Test
    void aClientThatNeverReadsDelaysNoOther() throws Exception {
        try (Socket silent =
                new Socket(InetAddress.getLoopbackAddress(), webcam.url().getPort())) {
            silent.setReceiveBufferSize(1_024);
            silent.getOutputStream()
                    .write("GET /stream HTTP/1.1\r\nHost: robot\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
            await().until(() -> webcam.clients() == 1);
            Viewer viewer = view();
            untilSeen(viewer, 200);
            assertThat(webcam.clients()).as("it is still connected").isEqualTo(2);
            webcam.close();
            await().untilTrue(viewer.ended);
            assertThat(webcam.clients()).isZero();
        }
    }

    @Test
    void aStalledCameraKeepsItsClientsWaiting() throws Exception {
        Viewer viewer = view();
        untilSeen(viewer, 1);
        webcam.stall();
        ticks(3);
        // The one being drawn and the next one may still arrive.
        long drawn = webcam.drawn();
        Viewer late = view();
        ticks(500);
        assertThat(webcam.drawn()).isBetween(drawn, drawn + 2);
        assertThat(late.pictures).isEmpty();
        assertThat(viewer.ended).isFalse();
        webcam.resume();
        untilSeen(viewer, 2);
        untilSeen(late, 1);
    }

    @Test
    void anUnpluggedCameraIsGoneUntilItIsPluggedInAgain() throws Exception {
        URI url = webcam.url();
        Viewer viewer = view();
        untilSeen(viewer, 1);
        assertThatThrownBy(webcam::replug).hasMessage("the camera is plugged in already");
        webcam.unplug();
        await().untilTrue(viewer.ended);
        assertThatThrownBy(() -> get("/stream")).isInstanceOf(ConnectException.class);
        assertThatThrownBy(webcam::unplug).hasMessage("the camera is unplugged already");
        ticks(100);
        webcam.replug();
        assertThat(webcam.url()).isEqualTo(url);
        untilSeen(view(), 2);
    }

    @Test
    void damagedPicturesAreNotWhatTheyWere() throws Exception {
        try (Webcam twin = Webcam.start(CAMERA)) {
            webcam.damage(1);
            var damaged = http.sendAsync(request("/frame.jpg"), BodyHandlers.ofByteArray());
            var whole = http.sendAsync(
                    HttpRequest.newBuilder(twin.url().resolve("/frame.jpg")).build(), BodyHandlers.ofByteArray());
            await().until(() -> webcam.clients() == 1 && twin.clients() == 1);
            robot.tick();
            webcam.accept(robot.state());
            twin.accept(robot.state());
            byte[] one = damaged.get().body();
            byte[] other = whole.get().body();
            assertThat(one).hasSameSizeAs(other);
            assertThat(Arrays.mismatch(one, other)).isGreaterThan(600);
        }
        assertThatThrownBy(() -> webcam.damage(1.5)).hasMessage("the damaged share is 1.5; allowed is 0 to 1");
    }

    @Test
    void aBrowserFindsAPageAndOthersFindOutWhatThereIs() throws Exception {
        HttpResponse<String> page = http.send(request("/"), BodyHandlers.ofString());
        assertThat(page.body()).contains("<img src=\"/stream\"");
        assertThat(page.headers().firstValue("Content-Type")).contains("text/html; charset=utf-8");
        HttpResponse<String> none = http.send(request("/favicon.ico"), BodyHandlers.ofString());
        assertThat(none.statusCode()).isEqualTo(404);
        assertThat(none.body()).isEqualTo("there are /, /stream and /frame.jpg\n");
        HttpRequest post = HttpRequest.newBuilder(webcam.url())
                .POST(HttpRequest.BodyPublishers.ofString("x"))
                .build();
        assertThat(http.send(post, BodyHandlers.ofString()).statusCode()).isEqualTo(405);
    }

    @Test
    void tooManyClientsAreRefusedWithAMessage() throws Exception {
        for (int i = 0; i < 16; i++) {
            view();
        }
        assertThat(get("/stream").statusCode()).isEqualTo(503);
        await().until(() -> webcam.clients() == 16);
    }

    @Test
    void endlessRequestsAreClosedAndTheirNumberIsLimited() throws Exception {
        URI url = webcam.url();
        Deque<Socket> halfOpen = new ArrayDeque<>();
        try {
            while (halfOpen.size() < 512) {
                halfOpen.add(connect(url));
                if (halfOpen.size() > 480) {
                    halfOpen.getLast().getOutputStream().write("GET /frame".getBytes(StandardCharsets.US_ASCII));
                }
            }
            assertThat(Thread.getAllStackTraces().keySet())
                    .filteredOn(thread -> thread.getName().equals("roomba-webcam-client"))
                    .hasSizeLessThanOrEqualTo(48);
            try (Socket oneTooMany = connect(url)) {
                assertThat(isHungUpOn(oneTooMany)).isTrue();
            }
            for (Socket socket : halfOpen) {
                assertThat(isHungUpOn(socket)).isTrue();
            }
            assertThat(http.send(request("/"), BodyHandlers.ofString()).statusCode())
                    .as("there is room again")
                    .isEqualTo(200);
        } finally {
            for (Socket socket : halfOpen) {
                socket.close();
            }
        }
    }

    @Test
    void halfRequestsHoldFewThreadsForALimitedTime() throws Exception {
        URI url = webcam.url();
        Deque<Socket> half = new ArrayDeque<>();
        try {
            for (int i = 0; i < 300; i++) {
                half.add(connect(url));
                try {
                    half.getLast()
                            .getOutputStream()
                            .write("GET /stream HTTP/1.1\r\nHost: rob".getBytes(StandardCharsets.US_ASCII));
                } catch (SocketException hungUp) {
                    // As expected.
                }
                assertThat(Thread.getAllStackTraces().keySet())
                        .filteredOn(thread -> thread.getName().equals("roomba-webcam-client"))
                        .hasSizeLessThanOrEqualTo(48);
            }
            for (Socket socket : half) {
                assertThat(isHungUpOn(socket)).isTrue();
            }
            untilSeen(view(), 1);
        } finally {
            for (Socket socket : half) {
                socket.close();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "GET /nothing HTTP/1.1\r\nHost: robot\r\nContent-Length: 5\r\n\r\nab",
                "POST / HTTP/1.1\r\nHost: robot\r\nTransfer-Encoding: chunked\r\n\r\nFFFFFFFF\r\n"
            })
    void requestsThatBreakOffUseUpNoConnections(String request) throws Exception {
        // More than there may be connections.
        for (int i = 0; i < 100; i++) {
            try (Socket socket = connect(webcam.url())) {
                socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
                socket.shutdownOutput();
                socket.getInputStream().readAllBytes();
            } catch (SocketException hungUp) {
                // As expected.
            }
        }
        await().atMost(LIMIT)
                .ignoreExceptionsInstanceOf(IOException.class)
                .until(() -> http.send(request("/"), BodyHandlers.ofString()).statusCode() == 200);
    }

    private static Socket connect(URI url) throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), url.getPort());
        socket.setSoTimeout(40_000);
        return socket;
    }

    private static boolean isHungUpOn(Socket socket) throws IOException {
        try {
            return socket.getInputStream().read() < 0;
        } catch (SocketException reset) {
            return true;
        }
    }

    @Test
    void afterCloseNothingIsLeft() throws Exception {
        view();
        webcam.close();
        webcam.close();
        assertThat(Thread.getAllStackTraces().keySet())
                .extracting(Thread::getName)
                .doesNotContain("roomba-webcam");
        await().until(() -> Thread.getAllStackTraces().keySet().stream()
                .noneMatch(thread -> thread.getName().equals("roomba-webcam-client")));
        assertThatThrownBy(() -> get("/stream")).isInstanceOf(ConnectException.class);
        robot.place(new Pose(ROOM.start().xMm(), ROOM.start().yMm(), 0));
        ticks(10);
        assertThat(webcam.drawn()).isZero();
    }

    @Test
    void whatCannotBeIsRefused() {
        int taken = webcam.url().getPort();
        assertThatThrownBy(() -> Webcam.start(CAMERA.withPort(taken)))
                .isInstanceOf(IOException.class)
                .hasMessage("the camera's port " + taken
                        + " cannot be used (Address already in use); choose another, or 0 for any that is free");
        assertThatThrownBy(() -> CAMERA.withPort(65_536)).hasMessage("camera port is 65536; allowed is 0 to 65535");
        assertThatThrownBy(() -> CAMERA.withFramesPerSecond(61))
                .hasMessage("camera frames per second are 61.0; allowed is 0.1 to 60");
    }

    @ParameterizedTest
    @ValueSource(strings = {"GET /stream HTTP/1.1\r\nHost: loc", ""})
    void clientsThatKeepOpeningHalfRequestsLockNobodyOut(String half) throws Exception {
        URI page = webcam.url().resolve("/");
        try (HalfRequests clients = new HalfRequests(page.getPort(), half)) {
            assertThat(HalfRequests.slowestOf(page)).isLessThan(Duration.ofSeconds(5));
        }
    }
}
