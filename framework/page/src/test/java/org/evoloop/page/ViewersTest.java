package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.Socket;
import java.net.SocketException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.awaitility.Awaitility;
import org.evoloop.HalfRequests;
import org.evoloop.page.server.PageServer;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.slf4j.LoggerFactory;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Viewers that read well, slowly, never, or no longer. */
class ViewersTest {
    /** HTTP/1.0, so that the answer is not chunked. */
    private static final String REQUEST = "GET /events HTTP/1.0\r\nHost: localhost\r\n\r\n";

    private static final Duration LIMIT = Duration.ofSeconds(30);
    private final List<Viewer> viewers = new ArrayList<>();
    private Shown shown;

    /** A connection with a stream of updates. */
    private static final class Viewer implements AutoCloseable {
        final Socket socket;
        final BufferedReader lines;

        Viewer(Shown shown, String request) throws IOException {
            socket = new Socket();
            socket.setReceiveBufferSize(4096);
            socket.connect(new java.net.InetSocketAddress("127.0.0.1", shown.page.port()));
            socket.setSoTimeout((int) LIMIT.toMillis());
            socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
            lines = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
        }

        JsonNode next() throws IOException {
            String line = lines.readLine();
            while (line != null && !line.startsWith("data: ")) {
                line = lines.readLine();
            }
            assertThat(line).as("the stream continues").isNotNull();
            return new JsonMapper().readTree(line.substring("data: ".length()));
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    @BeforeEach
    void open() throws IOException {
        // A page does not wait for its threads when it is closed.
        Awaitility.await()
                .atMost(LIMIT)
                .untilAsserted(() -> assertThat(threads()).isEmpty());
        shown = new Shown();
        shown.converter.start();
    }

    @AfterEach
    void close() throws IOException {
        for (Viewer viewer : viewers) {
            viewer.close();
        }
        shown.close();
    }

    private Viewer look() throws IOException {
        return ask(REQUEST);
    }

    private Viewer ask(String request) throws IOException {
        Viewer viewer = new Viewer(shown, request);
        viewers.add(viewer);
        return viewer;
    }

    private static List<String> threads() {
        return Thread.getAllStackTraces().keySet().stream()
                .map(Thread::getName)
                .filter(name -> name.startsWith("evoloop-page") || name.endsWith("-listeners"))
                .toList();
    }

    @Test
    void allListenersAreNotifiedOfAnEventAndTheReason() throws IOException {
        List<Viewer> five = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            five.add(look());
        }
        for (Viewer viewer : five) {
            assertThat(viewer.next().at("/status/originalState").asString()).isEqualTo("Off");
        }
        shown.panel.press("Clean");
        for (Viewer viewer : five) {
            JsonNode update = viewer.next();
            while (update.path("events").isEmpty()) {
                update = viewer.next();
            }
            assertThat(update.at("/events/0/decision/kind").asString()).isEqualTo("existing-function");
            assertThat(update.at("/events/0/decision/steps/0/sends").asString()).isEqualTo("Clean");
            assertThat(update.at("/status/newState").asString()).isEqualTo("On");
            assertThat(update.path("last").asLong()).isEqualTo(1);
        }
    }

    @Test
    void anUpdateIsMadeOnceForAllViewers() throws InterruptedException {
        try (SystemClock clock = new SystemClock()) {
            Broadcast broadcast = new Broadcast(shown.converter, clock);
            broadcast.join();
            Broadcast.Update seen = broadcast.after(-1, Long.MAX_VALUE);
            shown.panel.press("Clean");
            Broadcast.Update news = broadcast.after(seen.number(), 0);
            shown.battery.set(50);
            Broadcast.Update again = broadcast.after(seen.number(), 0);
            assertThat(again.json()).isEqualTo(news.json()).doesNotContain("50 %");
            assertThat(broadcast.after(again.number(), 0).readings().toString()).contains("50 %");
            broadcast.leave();
        }
    }

    @Test
    void viewersThatLeaveLeaveNothingBehind() throws IOException {
        assertThat(threads()).isEmpty();
        look().next();
        assertThat(threads()).isNotEmpty();
        viewers.get(0).close();
        Awaitility.await()
                .atMost(LIMIT)
                .untilAsserted(() -> assertThat(threads()).isEmpty());
    }

    @Test
    void thereAreSeatsForSoMany() throws IOException {
        for (int i = 0; i < PageServer.MOST_VIEWERS; i++) {
            look().next();
        }
        assertThat(look().lines.readLine()).isEqualTo("HTTP/1.1 503 Service Unavailable");
        viewers.get(0).close();
        Awaitility.await().atMost(LIMIT).until(() -> {
            try (Viewer next = new Viewer(shown, REQUEST)) {
                return "HTTP/1.1 200 OK".equals(next.lines.readLine());
            }
        });
    }

    @Test
    void requestsThatAreNotWholeAreFewAndEnd() throws IOException {
        List<Viewer> half = new ArrayList<>();
        for (int i = 0; i < 300; i++) {
            try {
                half.add(ask("GET /about HTTP/1.1\r\nHost: loc"));
            } catch (SocketException hungUp) {
                // As expected.
            }
        }
        int most = PageServer.MOST_VIEWERS + PageServer.MOST_REQUESTS;
        assertThat(threads().size()).isLessThanOrEqualTo(most + 1);
        for (Viewer viewer : half) {
            try {
                assertThat(viewer.lines.read()).as("the connection is closed").isNegative();
            } catch (SocketException hungUp) {
                // Closed, too.
            }
        }
        assertThat(ask("GET /about HTTP/1.1\r\nHost: localhost\r\n\r\n").lines.readLine())
                .isEqualTo("HTTP/1.1 200 OK");
    }

    /** Neither half headers, nor half bodies, nor connections on which nothing is sent. */
    @ParameterizedTest
    @ValueSource(
            strings = {"GET /about HTTP/1.1\r\nHost: loc", "POST /session HTTP/1.1\r\nContent-Length: 5\r\n\r\nab", ""})
    void clientsThatKeepOpeningHalfRequestsLockNobodyOut(String half) throws Exception {
        Viewer before = look();
        before.next();
        try (HalfRequests clients = new HalfRequests(shown.page.port(), half)) {
            assertThat(HalfRequests.slowestOf(URI.create("http://127.0.0.1:" + shown.page.port() + "/about")))
                    .isLessThan(Duration.ofSeconds(5));
            look().next();
            shown.panel.press("Clean");
            before.next();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"Content-Length: 5\r\n\r\nab", "Transfer-Encoding: chunked\r\n\r\nno length\r\n"})
    void requestsThatBreakOffUseUpNoConnections(String rest) throws IOException {
        // More than there may be connections.
        for (int i = 0; i < 100; i++) {
            try (Viewer viewer = new Viewer(shown, "POST /session HTTP/1.1\r\nHost: localhost\r\n" + rest)) {
                viewer.socket.shutdownOutput();
                viewer.lines.readLine();
            } catch (SocketException hungUp) {
                // As expected.
            }
        }
        Awaitility.await().atMost(LIMIT).until(() -> {
            try (Viewer viewer = new Viewer(shown, "GET /about HTTP/1.0\r\nHost: localhost\r\n\r\n")) {
                return "HTTP/1.1 200 OK".equals(viewer.lines.readLine());
            } catch (SocketException hungUp) {
                return false;
            }
        });
    }

    @Test
    void aPictureThatFailsUsesUpNoConnectionsAndIsReportedOnce() throws IOException {
        Logger log = (Logger) LoggerFactory.getLogger(PageServer.class);
        ListAppender<ILoggingEvent> logged = new ListAppender<>();
        logged.start();
        log.setLevel(Level.WARN);
        log.addAppender(logged);
        Picture broken = new Picture("Broken", "A picture", "image/png", false, () -> {
            throw new IllegalStateException("no paint");
        });
        try (Shown another = new Shown(List.of(broken))) {
            for (int i = 0; i < 100; i++) {
                try (Viewer viewer = new Viewer(another, "GET /picture HTTP/1.1\r\nHost: localhost\r\n\r\n")) {
                    assertThat(viewer.lines.readLine()).isEqualTo("HTTP/1.1 500 Internal Server Error");
                }
            }
            try (Viewer viewer = new Viewer(another, "GET /about HTTP/1.1\r\nHost: localhost\r\n\r\n")) {
                assertThat(viewer.lines.readLine()).isEqualTo("HTTP/1.1 200 OK");
            }
        } finally {
            log.detachAppender(logged);
            log.setLevel(null);
        }
        assertThat(logged.list)
                .extracting(ILoggingEvent::getFormattedMessage)
                .containsExactly("the page cannot answer /picture; further failures of it are not reported");
    }

    @Test
    void whenNobodyLooksOnlyTwoThreadsOfTheJdkWait() throws IOException {
        Set<Thread> before = Thread.getAllStackTraces().keySet();
        try (Shown another = new Shown()) {
            assertThat(another.page.port()).isPositive();
            assertThat(Thread.getAllStackTraces().keySet())
                    .filteredOn(thread -> !before.contains(thread))
                    .extracting(Thread::getName)
                    .filteredOn(name -> !name.startsWith("mapek-"))
                    .containsExactlyInAnyOrder("HTTP-Dispatcher", "idle-timeout-task");
        }
    }

    private static long served() {
        return threads().stream().filter("evoloop-page"::equals).count();
    }

    @Test
    @Tag("slow")
    void aViewerThatReadsNothingIsClosedAndTheOthersAreNotified() throws Exception {
        look();
        Viewer quick = look();
        quick.next();
        Awaitility.await().atMost(LIMIT).until(() -> served() == 2);
        Thread presser = new Thread(() -> {
            while (!Thread.currentThread().isInterrupted()) {
                shown.panel.operate("Clean");
            }
        });
        presser.setDaemon(true);
        presser.start();
        try {
            // The other viewer's buffers fill up; then it has ten seconds.
            Awaitility.await().atMost(Duration.ofMinutes(2)).until(() -> {
                quick.next();
                return served() == 1;
            });
        } finally {
            presser.interrupt();
            presser.join(10_000);
        }
        assertThat(quick.next().path("last").asLong()).isPositive();
    }
}
