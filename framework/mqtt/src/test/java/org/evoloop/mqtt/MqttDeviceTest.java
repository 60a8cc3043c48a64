package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.regex.Pattern;
import org.evoloop.Machines;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.Reading;
import org.evoloop.loop.LoopConfig;
import org.evoloop.payload.Match;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Part;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** An air conditioner, played by the test, that reports its state as JSON on a topic of a real broker. */
class MqttDeviceTest {
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    private static final Duration LIMIT = Duration.ofSeconds(2);
    private static final Duration BEEP = Duration.ofMillis(350);
    private static final String STATE = "ac/state";
    private static final String COMMAND = "ac/set";

    private static final StateMachine MODEL = Machines.machine(
            "ac", "Off power -> Cool", "Cool power -> Off", "Cool mode -> Dry", "Dry mode -> Cool", "Cool to -> Cool");

    private static final Meanings STATES = Meanings.at("/mode", Map.of("off", "Off", "cool", "Cool", "dry", "Dry"));

    @TempDir
    private Path directory;

    private final ManualClock clock = new ManualClock();
    private final SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("ac", clock));
    private Mosquitto broker;
    private BrokerConnection connection;
    private MqttDevice device;
    private Watcher owner;

    @BeforeEach
    void configure() throws Exception {
        broker = new Mosquitto(directory).start();
        owner = new Watcher(broker);
        connection = new BrokerConnection(BrokerAddress.parse(broker.url()), "converter");
        device = new MqttDevice(connection, clock)
                .availability("ac/availability", Match.exactly("online"))
                .reading("room", STATE, Part.at("/room"), "°C");
        converter.addMonitor(new MqttMonitor("Reports", connection)
                .controller(
                        "remote/action",
                        Meanings.at("/action", Map.of("single", "power", "double", "mode"))
                                .with(Match.matching(Pattern.compile("to (?<degrees>[0-9]+)")), "to"))
                .found(STATE, STATES));
        converter.addExecute(new MqttExecute(
                        "Ac",
                        device,
                        Map.of(
                                "power", Message.command(COMMAND, "power"),
                                "mode", Message.command(COMMAND, "mode"),
                                "to", Message.command(COMMAND, "{\"target\":${degrees}}")))
                .confirmedBy(STATE, STATES, LIMIT)
                .asking(Message.command("ac/get", "?"), STATE, STATES, LIMIT)
                .readyAfter(BEEP));
        converter.addKnowledge(new StateKnowledge(new ModelPair(MODEL, MODEL)) {
            @Override
            protected void registerNewFunctions() {}
        });
        converter.addLink(device);
        converter.build();
        converter.start();
    }

    @AfterEach
    void close() {
        converter.close();
        connection.close();
        owner.close();
        broker.close();
        clock.close();
    }

    private void open() {
        connection.open();
        await().atMost(PATIENCE).until(connection::isUp);
    }

    private void press(String action) throws Exception {
        owner.publish("remote/action", "{\"action\":\"" + action + "\"}", false);
    }

    private void report(String mode) throws Exception {
        owner.publish(STATE, "{\"mode\":\"" + mode + "\",\"room\":26.5}", true);
    }

    private void awaitRecord(String state) {
        await().atMost(PATIENCE).untilAsserted(() -> assertThat(record()).isEqualTo(state));
    }

    private String record() {
        return converter.status().states().original().name();
    }

    private String doubt() {
        return converter.status().doubt();
    }

    private long commands() {
        return owner.heard().stream().filter(line -> line.startsWith(COMMAND)).count();
    }

    private void awaitCommands(int number) {
        await().atMost(PATIENCE).until(() -> commands() == number);
    }

    private void awaitHistory(String part) {
        await().atMost(PATIENCE)
                .untilAsserted(() -> assertThat(converter.history())
                        .anyMatch(entry -> entry.detail().contains(part)));
    }

    @Test
    void whatTheBrokerHasRetainedIsTheStateButNoEvent() throws Exception {
        owner.publish("remote/action", "{\"action\":\"single\"}", true);
        report("dry");
        open();
        awaitRecord("Dry");
        assertThat(device.readings()).containsExactly(Reading.of("room", 26.5, "°C"));
        report("cool");
        awaitRecord("Cool");
        assertThat(commands()).isZero();
        assertThat(doubt()).isEmpty();
    }

    @Test
    void retainedGarbageIsNoState() throws Exception {
        owner.publish(STATE, "{\"mode\":\"dr", true);
        open();
        owner.publish(STATE, "dry", false);
        owner.publish(STATE, "[\"dry\"]", false);
        owner.publish(STATE, "{\"mode\":\"heat\"}", false);
        report("cool");
        awaitRecord("Cool");
        assertThat(converter.history())
                .noneMatch(entry -> entry.after().original().name().equals("Dry"));
    }

    @Test
    void aStepIsOverWhenTheStateTopicSaysSo() throws Exception {
        open();
        press("single");
        awaitCommands(1);
        report("off");
        owner.publish(STATE, "beeping", false);
        assertThat(record()).isEqualTo("Off");
        report("cool");
        report("cool");
        awaitRecord("Cool");
        owner.publish("remote/action", "to 21", false);
        clock.advance(BEEP);
        owner.awaitHeard(COMMAND, "{\"target\":21}");
        report("cool");
        press("double");
        clock.advance(BEEP);
        await().atMost(PATIENCE).until(() -> {
            clock.advance(BEEP);
            return commands() == 3;
        });
        report("dry");
        awaitRecord("Dry");
        assertThat(doubt()).isEmpty();
    }

    @Test
    void theNextCommandWaitsUntilTheDeviceIsReady() throws Exception {
        open();
        press("single");
        awaitCommands(1);
        report("cool");
        awaitRecord("Cool");
        press("single");
        await().atMost(PATIENCE)
                .until(() -> clock.untilNext().filter(BEEP::equals).isPresent());
        clock.advance(BEEP.minusMillis(1));
        assertThat(commands()).isEqualTo(1);
        clock.advance(Duration.ofMillis(1));
        awaitCommands(2);
        report("off");
        awaitRecord("Off");
    }

    @Test
    void aDroppedCommandIsAskedAbout() throws Exception {
        report("off");
        open();
        press("single");
        awaitCommands(1);
        clock.advance(LIMIT);
        owner.awaitHeard("ac/get", "?");
        report("off");
        owner.awaitHeard(STATE, "off");
        awaitHistory("has not reported within 2000 ms");
        assertThat(doubt()).isNotEmpty();
        clock.advance(LIMIT);
        await().atMost(PATIENCE).until(() -> doubt().isEmpty());
        assertThat(record()).isEqualTo("Off");
        // It had only been late.
        report("cool");
        awaitRecord("Cool");
    }

    @Test
    void aDeviceThatSaysNothingLeavesADoubtThatItsNextReportSettles() throws Exception {
        open();
        press("single");
        awaitCommands(1);
        clock.advance(LIMIT);
        owner.awaitHeard("ac/get", "?");
        clock.advance(LIMIT);
        await().atMost(PATIENCE).until(() -> !doubt().isEmpty());
        report("cool");
        awaitRecord("Cool");
        await().atMost(PATIENCE).until(() -> doubt().isEmpty());
    }

    @Test
    void aReportThatMayBeOlderThanTheCommandSettlesNothing() throws Exception {
        open();
        press("single");
        awaitCommands(1);
        clock.advance(LIMIT);
        owner.awaitHeard("ac/get", "?");
        report("dry");
        report("off");
        owner.publish("ac/availability", "offline", true);
        awaitHistory("ac/availability says 'offline'");
        assertThat(doubt()).isNotEmpty();
        report("cool");
        await().atMost(PATIENCE).until(() -> doubt().isEmpty());
        assertThat(record()).isEqualTo("Cool");
        clock.advance(LIMIT);
        assertThat(record()).isEqualTo("Cool");
    }

    @Test
    void aCommandThatIsNeverConfirmedHadNoEffectOnceItIsTooLateForOne() throws Exception {
        open();
        press("single");
        awaitCommands(1);
        clock.advance(LIMIT);
        owner.awaitHeard("ac/get", "?");
        clock.advance(LIMIT);
        awaitHistory("the message to ac/get");
        assertThat(doubt()).isNotEmpty();
        report("off");
        await().atMost(PATIENCE).until(() -> doubt().isEmpty());
        assertThat(record()).isEqualTo("Off");
    }

    @Test
    void aBrokerThatIsLostInMidStepLeavesADoubtThatTheRetainedStateSettles() throws Exception {
        open();
        press("single");
        awaitCommands(1);
        broker.stop();
        await().atMost(PATIENCE).until(() -> !doubt().isEmpty());
        assertThat(commands()).isEqualTo(1);
        broker.start();
        try (Watcher again = new Watcher(broker)) {
            again.publish(STATE, "{\"mode\":\"cool\"}", true);
            awaitRecord("Cool");
            await().atMost(PATIENCE).until(() -> doubt().isEmpty());
            assertThat(again.heard()).noneMatch(line -> line.startsWith(COMMAND));
        }
    }

    @Test
    void aDeviceThatLeavesIsABrokenLinkAndNoState() throws Exception {
        owner.publish("ac/availability", "online", true);
        report("off");
        open();
        await().atMost(PATIENCE).until(() -> device.isUp() && !device.readings().isEmpty());
        press("single");
        awaitCommands(1);
        owner.publish("ac/availability", "offline", true);
        await().atMost(PATIENCE).until(() -> !doubt().isEmpty());
        assertThat(device.isUp()).isFalse();
        assertThat(device.describe()).contains("ac/availability says 'offline'");
        assertThat(device.downSince()).contains(clock.wallTime());
        assertThat(device.readings()).isEmpty();
        assertThat(record()).isEqualTo("Off");
        clock.advance(LIMIT);
        report("off");
        await().atMost(PATIENCE).until(() -> doubt().isEmpty());
        press("single");
        awaitHistory("so power was not sent");
        owner.publish("ac/availability", "online", true);
        await().atMost(PATIENCE).until(device::isUp);
        assertThat(commands()).isEqualTo(1);
    }
}
