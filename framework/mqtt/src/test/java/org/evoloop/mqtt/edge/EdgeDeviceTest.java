package org.evoloop.mqtt.edge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.evoloop.PaperModels;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.edge.EdgeShell;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Message;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.statemachine.Event;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A lamp on a real MQTT broker; the test is its gateway. */
class EdgeDeviceTest {
    private static final JsonMapper JSON = new JsonMapper();

    private static final Instant NOW = Instant.parse("2026-11-23T12:00:00Z");
    private static final Duration LIMIT = Duration.ofSeconds(60);

    @TempDir
    private Path directory;

    private final List<Map<String, Object>> records = new CopyOnWriteArrayList<>();
    private final List<Object> firsts = new CopyOnWriteArrayList<>();
    private final List<String> done = new CopyOnWriteArrayList<>();
    private final List<String> link = new CopyOnWriteArrayList<>();
    private final SystemClock clock = new SystemClock();
    private volatile boolean keeping = true;
    private Mosquitto mosquitto;
    private BrokerConnection gateway;

    private final class Lamp implements AutoCloseable {
        final PushMonitor panel = new PushMonitor("Panel");
        final EdgeDevice edge;
        final EdgeShell shell;

        Lamp() {
            this(clock);
        }

        Lamp(Clock sending) {
            edge = new EdgeDevice(
                    "lamp",
                    BrokerAddress.parse(mosquitto.url()),
                    directory.resolve("edge"),
                    sending,
                    InstantSource.fixed(NOW),
                    link::add);
            shell = new EdgeShell(LoopConfig.defaults("lamp", clock), knowledge(), edge);
            shell.addMonitor(panel);
            shell.addExecute(new EventExecute("Bulb") {
                @Override
                protected Set<String> sendableEvents() {
                    return Set.of("switch");
                }

                @Override
                protected void send(Step step) {
                    done.add(step + " " + values());
                }
            });
            shell.open();
            edge.open(shell);
        }

        @Override
        public void close() {
            edge.close();
            shell.close();
        }
    }

    static StateKnowledge knowledge() {
        return new StateKnowledge(PaperModels.lightBulb()) {
            @Override
            protected void registerNewFunctions() {
                function("wait", visit -> visit.finish("timeout"));
                function("incandescentOn", NewFunction.none());
            }
        };
    }

    @BeforeEach
    void begin() {
        mosquitto = new Mosquitto(directory).start();
        gateway = new BrokerConnection(BrokerAddress.parse(mosquitto.url()), "gateway");
        gateway.subscribe("evoloop/lamp/occurrence", this::hear);
        gateway.subscribe("evoloop/lamp/effect", this::hear);
        gateway.open();
        Awaitility.await().atMost(LIMIT).until(gateway::isUp);
    }

    @AfterEach
    void end() {
        gateway.close();
        mosquitto.close();
        clock.close();
    }

    private void hear(Message message) {
        Map<String, Object> record = members(message.payload());
        // It differs when a record is repeated.
        firsts.add(record.remove("first"));
        records.add(record);
        if (keeping) {
            gateway.publish(Message.command("evoloop/lamp/kept", "{\"number\":" + number(record) + "}"));
        }
    }

    private static long number(Map<String, Object> record) {
        return ((Double) record.get("number")).longValue();
    }

    /** What was reported, which may be repeated until its confirmation has arrived. */
    private List<Map<String, Object>> reported() {
        return records.stream().distinct().toList();
    }

    private void await(int different) {
        Awaitility.await().atMost(LIMIT).until(() -> reported().size() >= different);
    }

    private void awaitLink(boolean up) {
        Awaitility.await()
                .atMost(LIMIT)
                .until(() -> !link.isEmpty()
                        && link.get(link.size() - 1).startsWith("the gateway's broker can be reached") == up);
    }

    private static String command(long sequence, Instant deadline) {
        return "{\"schema\":1,\"sequence\":" + sequence + ",\"kind\":\"send\",\"deadlineMillis\":"
                + deadline.toEpochMilli()
                + ",\"event\":\"switch\",\"from\":\"off\",\"to\":\"on\",\"visit\":1,\"function\":false,\"values\":{\"by\":\"me\"}}";
    }

    private void send(String topic, String payload) {
        gateway.publish(Message.event("evoloop/lamp/" + topic, payload));
    }

    @Test
    void whatIsReportedWhileTheBrokerIsAwayComesInOrderAndIsNumberedFromTheTime() {
        try (Lamp lamp = new Lamp()) {
            lamp.panel.press("switch");
            await(1);
            mosquitto.stop();
            lamp.panel.press("switch", Values.of("level", 0.5));
            lamp.panel.press("timeout");
            awaitLink(false);
            mosquitto.start();
            await(3);
        }
        List<Map<String, Object>> first = reported();
        assertThat(first).extracting(each -> each.get("event")).containsExactly("switch", "switch", "timeout");
        long begun = NOW.toEpochMilli();
        assertThat(first).extracting(EdgeDeviceTest::number).containsExactly(begun + 1, begun + 2, begun + 3);
        assertThat(first.get(1))
                .containsEntry("atMillis", (double) begun)
                .containsEntry("source", "controller")
                .containsEntry("values", Map.of("level", 0.5));
        assertThat(link).anyMatch(how -> how.startsWith("the gateway's broker can be reached"));
    }

    /** It may have been published before the gateway had subscribed; then the gateway stores none of those after it. */
    @Test
    void theFirstThatIsNotConfirmedIsReportedAgainWhateverIsReportedMeanwhile() {
        keeping = false;
        double first = NOW.toEpochMilli() + 1;
        try (ManualClock time = new ManualClock();
                Lamp lamp = new Lamp(time)) {
            for (int press = 1; press <= 4; press++) {
                lamp.panel.press("switch");
                await(press);
                time.advance(Duration.ofSeconds(2));
            }
            Awaitility.await()
                    .atMost(LIMIT)
                    .until(() -> records.stream()
                                    .filter(each -> each.get("number").equals(first))
                                    .count()
                            == 2);
        }
        assertThat(firsts).containsOnly(first);
    }

    @Test
    void whatIsNotStoredIsReportedAgainByTheNextProcess() {
        keeping = false;
        try (Lamp lamp = new Lamp()) {
            lamp.panel.press("switch");
            await(1);
        }
        keeping = true;
        records.clear();
        try (Lamp next = new Lamp()) {
            await(1);
            next.panel.press("switch");
            await(2);
        }
        assertThat(reported())
                .extracting(EdgeDeviceTest::number)
                .containsExactly(NOW.toEpochMilli() + 1, NOW.toEpochMilli() + 2);
    }

    @Test
    void aConfirmationOfWhatWasNeverReportedIsIgnored() {
        try (Lamp lamp = new Lamp()) {
            awaitLink(true);
            send("kept", "{\"number\":9e15}");
            lamp.panel.press("switch");
            Path sent = directory.resolve("edge").resolve("outbox.sent");
            Awaitility.await()
                    .atMost(LIMIT)
                    .until(() -> Files.exists(sent)
                            && Files.readString(sent).strip().equals(String.valueOf(NOW.toEpochMilli() + 1)));
        }
    }

    /** Here a directory stands where the file is to be written, instead of a full disk. */
    @Test
    void aDeviceThatCouldNotWriteWhatIsConfirmedGoesOn() throws Exception {
        try (Lamp lamp = new Lamp()) {
            Path obstacle = Files.createDirectory(directory.resolve("edge").resolve("outbox.sent.new"));
            lamp.panel.press("switch");
            await(1);
            lamp.panel.press("switch");
            await(2);
            Files.delete(obstacle);
            lamp.panel.press("switch");
            await(3);
            Path sent = directory.resolve("edge").resolve("outbox.sent");
            Awaitility.await()
                    .atMost(LIMIT)
                    .until(() -> Files.exists(sent)
                            && Files.readString(sent).strip().equals(String.valueOf(NOW.toEpochMilli() + 3)));
        }
    }

    @Test
    void whatIsObservedIsInTheFileAtOnceSoThatAKilledProcessLosesNothing() throws Exception {
        Path killed = directory.resolve("killed");
        Path next = Files.createDirectories(directory.resolve("next"));
        // No thread of its own runs yet.
        try (EdgeDevice edge = new EdgeDevice(
                "lamp", BrokerAddress.parse(mosquitto.url()), killed, clock, InstantSource.fixed(NOW), link::add)) {
            edge.observed(new Occurrence.Heard(new Event("switch"), Values.NONE, Source.PANEL, 0, 1));
            edge.answered(7, EdgeShell.Result.SENT, "", Optional.empty());
            Files.copy(killed.resolve("outbox"), next.resolve("outbox"));
        }
        try (Outbox outbox = new Outbox(next, 0)) {
            assertThat(outbox.first(9, 1)).extracting(Outbox.Entry::topic).containsExactly("occurrence", "effect");
        }
    }

    @Test
    void aValueThatJsonCannotExpressIsWrittenAsText() throws Exception {
        try (EdgeDevice edge = new EdgeDevice(
                "lamp",
                BrokerAddress.parse(mosquitto.url()),
                directory.resolve("edge"),
                clock,
                InstantSource.fixed(NOW),
                link::add)) {
            Values values = Values.of("a", Double.NaN)
                    .with("b", Double.NEGATIVE_INFINITY)
                    .with("c", 0.5);
            edge.observed(new Occurrence.Heard(new Event("switch"), values, Source.PANEL, 0, 1));
        }
        try (Outbox outbox = new Outbox(directory.resolve("edge"), 0)) {
            Map<String, Object> record = members(outbox.first(1, 1).get(0).record());
            assertThat(record).containsEntry("values", Map.of("a", "NaN", "b", "-Infinity", "c", 0.5));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"1.5", "1e300", "-1e19", "\"7\"", "null", "true"})
    void aNumberOfARecordIsWhole(String number) {
        assertThatThrownBy(() ->
                        new Received("{\"number\":" + number + "}").members().number("number", 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("'number' must be a whole number");
    }

    @Test
    void aCommandIsCarriedOutOnceAndNeverLate() {
        try (Lamp lamp = new Lamp()) {
            awaitLink(true);
            send("command", command(1, NOW.plusSeconds(9)));
            send("command", command(1, NOW.plusSeconds(9)));
            send("command", command(2, NOW.minusMillis(1)));
            await(2);
        }
        link.clear();
        try (Lamp next = new Lamp()) {
            awaitLink(true);
            send("command", "what is this");
            send("command", command(2, NOW.plusSeconds(9)));
            send("command", "{\"sequence\":3,\"kind\":\"locate\",\"deadlineMillis\":" + Long.MAX_VALUE / 1000 + "}");
            Awaitility.await()
                    .atMost(LIMIT)
                    .until(() -> records.stream()
                            .anyMatch(each -> each.get("sequence").equals(3.0)));
            assertThat(next.edge).isNotNull();
        }
        assertThat(done).containsExactly("off --switch--> on by=me");
        assertThat(reported())
                .extracting(each -> each.get("sequence") + " " + each.get("outcome") + " " + each.get("reason"))
                .containsExactly("1.0 sent null", "2.0 failed the command arrived after its deadline", "3.0 sent null");
    }

    @Test
    void aCommandThatMakesNoSenseFailsAndTheNextOneIsCarriedOut() {
        try (Lamp lamp = new Lamp()) {
            awaitLink(true);
            send("state", "{\"device\":\" \",\"system\":\"on\"}");
            send("command", command(1, NOW.plusSeconds(9)).replace("\"off\"", "\"\""));
            send("command", command(2, NOW.plusSeconds(9)).replace("\"send\"", "\"sing\""));
            send("command", command(3, NOW.plusSeconds(9)).replace("\"visit\":1", "\"visit\":1.5"));
            send("command", command(4, NOW.plusSeconds(9)));
            await(4);
            assertThat(lamp.edge).isNotNull();
        }
        assertThat(reported())
                .extracting(each -> each.get("sequence") + " " + each.get("outcome") + " " + each.get("reason"))
                .containsExactly(
                        "1.0 failed a state has no name; give it one",
                        "2.0 failed the kind of the command is 'sing'; known are send, run and locate",
                        "3.0 failed 'visit' must be a whole number",
                        "4.0 sent null");
    }

    @Test
    void theFunctionOfAStateRunsHere() {
        try (Lamp lamp = new Lamp()) {
            gateway.publish(Message.state(
                    "evoloop/lamp/state",
                    "{\"schema\":1,\"device\":\"on\",\"system\":\"wait\",\"visit\":4,\"function\":true,\"settled\":true,"
                            + "\"sequence\":0,\"from\":\"on\",\"by\":\"switch\",\"timersMillis\":{\"x\":[1]}}"));
            await(1);
            assertThat(lamp.edge).isNotNull();
        }
        assertThat(records.get(0)).containsEntry("event", "timeout").containsEntry("visit", 4.0);
        assertThat(records.get(0)).containsEntry("source", "function");
    }

    @Test
    void aRecordOfANewerSchemaIsRefused() {
        assertThatThrownBy(() -> new Received("{\"schema\":2}")).hasMessageContaining("update this program");
    }

    /** All numbers as doubles. */
    private static Map<String, Object> members(String record) {
        Map<String, Object> members = new LinkedHashMap<>();
        JSON.readTree(record).properties().forEach(each -> members.put(each.getKey(), plain(each.getValue())));
        return members;
    }

    private static Object plain(JsonNode value) {
        if (value.isObject()) {
            return members(value.toString());
        } else if (value.isArray()) {
            return value.valueStream().map(EdgeDeviceTest::plain).toList();
        } else if (value.isNumber()) {
            return value.doubleValue();
        }
        return value.isBoolean() ? (Object) value.booleanValue() : value.stringValue();
    }
}
