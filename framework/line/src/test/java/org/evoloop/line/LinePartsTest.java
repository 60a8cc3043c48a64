package org.evoloop.line;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.Map;
import java.util.regex.Pattern;
import org.evoloop.LightBulb;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A lamp and its switch on one socket, with a converter between them. */
class LinePartsTest {
    private static final Duration PATIENCE = Duration.ofSeconds(LineServer.PATIENCE_SECONDS);

    private final SystemClock clock = new SystemClock();
    private final SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
    private LineServer server;
    private LineConnection connection;
    private LineExecute lamp;

    @BeforeEach
    void build() throws IOException {
        server = new LineServer();
        connection = new LineConnection(server.transport(), clock).greet("STATE?");
        lamp = new LineExecute("Lamp", connection, Map.of("switch", "SW"))
                .asking("STATE?", Map.of("is off", "off", "is on", "on"), PATIENCE);
        converter.addMonitor(new LineMonitor("Wall", connection)
                .controller(Map.of("click", "switch"))
                .controller(Pattern.compile("click (?<times>[0-9]+) (?<where>\\w+)"), "switch")
                .device(Map.of("by hand", "switch"))
                .found(Map.of("is off", "off", "is on", "on")));
        converter.addExecute(lamp);
        converter.addKnowledge(LightBulb.withoutTimeout());
        converter.addLink(connection);
    }

    @AfterEach
    void close() {
        converter.close();
        connection.close();
        server.close();
        clock.close();
    }

    private Socket start() throws InterruptedException {
        converter.build();
        converter.start();
        connection.open();
        Socket client = server.client();
        assertThat(server.nextLine()).isEqualTo("STATE?");
        await().atMost(PATIENCE).until(() -> converter.status().link().up());
        return client;
    }

    private void awaitStates(String original, String evolved) {
        await().atMost(PATIENCE).untilAsserted(() -> {
            assertThat(converter.status().states().original().name()).isEqualTo(original);
            assertThat(converter.status().states().evolved().name()).isEqualTo(evolved);
        });
    }

    private void awaitHistory(String detail) {
        await().atMost(PATIENCE)
                .untilAsserted(() -> assertThat(converter.history())
                        .anyMatch(entry -> entry.detail().contains(detail)));
    }

    @Test
    void whatIsOperatedArrivesAsALineAndIsSentAsALine() throws Exception {
        Socket client = start();
        LineServer.send(client, "nonsense\r\nclick\r\n");
        assertThat(server.nextLine()).isEqualTo("SW");
        awaitStates("on", "on");
        LineServer.send(client, "is off\n");
        awaitStates("off", "off");
        LineServer.send(client, "by hand\n");
        awaitStates("on", "on");
    }

    @Test
    void aStepIsCarriedOutWhenTheDeviceSaysSo() throws Exception {
        lamp.answeredBy("OK", "ERR.*", PATIENCE);
        server.answers.put("SW", "OK");
        LineServer.send(start(), "click\n");
        awaitStates("on", "on");
    }

    @Test
    void whatTheDeviceRefusesHasFailed() throws Exception {
        lamp.answeredBy("OK", "ERR.*", PATIENCE);
        server.answers.put("SW", "ERR burnt out");
        LineServer.send(start(), "click\n");
        awaitHistory("the device refuses 'SW': ERR burnt out");
        awaitStates("off", "off");
    }

    @Test
    void whatIsNotAnsweredHasFailedAndTheDeviceIsAskedWhereItIsWithoutSendingTwice() throws Exception {
        lamp.answeredBy("OK", "ERR.*", Duration.ofMillis(50));
        server.answers.put("STATE?", "is on");
        LineServer.send(startAnswered(), "click\n");
        assertThat(server.nextLine()).isEqualTo("SW");
        assertThat(server.nextLine()).isEqualTo("STATE?");
        awaitHistory("has not answered 'SW' within 50 ms");
        awaitStates("on", "on");
        assertThat(server.heard).isEmpty();
    }

    /** Starts with a lamp that reports that it is off. */
    private Socket startAnswered() throws InterruptedException {
        server.answers.put("STATE?", "is off");
        Socket client = start();
        server.answers.put("STATE?", "is on");
        return client;
    }

    @Test
    void whileTheDeviceIsGoneAStepFailsAndIsNotSentLater() throws Exception {
        int port = server.port();
        LineServer.send(start(), "click\n");
        assertThat(server.nextLine()).isEqualTo("SW");
        awaitStates("on", "on");
        server.close();
        await().atMost(PATIENCE).until(() -> !connection.isUp());
        assertThat(converter.status().link().up()).isFalse();
        assertThatThrownBy(() -> connection.send("SW"))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("was not sent");
        try (LineServer again = new LineServer(port)) {
            assertThat(again.nextLine()).isEqualTo("STATE?");
            await().atMost(PATIENCE).until(connection::isUp);
            assertThat(again.heard).isEmpty();
        }
    }

    @Test
    void whatIsSentIsOneLine() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new LineExecute("Lamp", connection, Map.of("switch", "a\nb")))
                .withMessageContaining("is not one line");
    }
}
