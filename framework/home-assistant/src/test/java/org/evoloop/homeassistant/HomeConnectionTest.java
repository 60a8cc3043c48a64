package org.evoloop.homeassistant;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyStore;
import java.security.MessageDigest;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import org.awaitility.Awaitility;
import org.evoloop.Machines;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.Reading;
import org.evoloop.loop.LoopConfig;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.Match;
import org.evoloop.payload.Meanings;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A lamp and a remote control in an imitated Home Assistant. */
@Timeout(120)
class HomeConnectionTest {
    private static final StateMachine ORIGINAL = Machines.machine("lamp", "off turn-on -> on", "on turn-off -> off");
    private static final StateMachine NEW =
            Machines.machine("lamp", "off turn-on -> on", "on turn-off -> off", "off press => off", "on press => on");
    private static final ServiceCall OFF = new ServiceCall("light.turn_off", "light.lamp", "{\"transition\": 2}");
    private static final EntityValue LAMP = EntityValue.state("light.lamp");
    private static final Meanings STATES = Meanings.of(Map.of("on", "on", "off", "off"));

    private final SystemClock clock = new SystemClock();
    private final AtomicReference<String> token = new AtomicReference<>(HomeImitation.TOKEN);
    private final PushMonitor wall = new PushMonitor("Wall");
    private final SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
    private final List<AutoCloseable> opened = new ArrayList<>();
    private final List<String> told = new CopyOnWriteArrayList<>();
    private long handledBefore;
    private HomeImitation home;
    private HomeConnection connection;
    private HomeDevice device;

    @BeforeEach
    void begin() throws Exception {
        // A connection that ends without a word is noticed after 13 s.
        Awaitility.setDefaultTimeout(Duration.ofSeconds(40));
        use(new HomeImitation(), "");
    }

    private void use(HomeImitation imitation, String parameters) {
        home = imitation;
        opened.add(home);
        home.put("light.lamp", "off", "{\"supported_features\":0}");
        home.put("light.lounge", "off");
        home.put("cover.gate", "closed", "{\"supported_features\":3}");
        connection = new HomeConnection(
                HomeAddress.parse(
                        (parameters.isEmpty() ? home.url() : home.url().replace("http", "https")) + parameters),
                token::get);
        opened.add(connection);
        device = new HomeDevice(connection, clock);
        connection.onLost(told::add);
    }

    @AfterEach
    void end() throws Exception {
        converter.close();
        for (int each = opened.size() - 1; each >= 0; each--) {
            opened.get(each).close();
        }
        clock.close();
    }

    private void run(HomeMonitor monitor, ServiceCall on) {
        converter.addMonitor(wall);
        converter.addMonitor(monitor);
        converter.addExecute(new HomeExecute("Lamp", device, Map.of("turn-on", on, "turn-off", OFF))
                .confirmedBy(LAMP, STATES, Duration.ofSeconds(20)));
        converter.addKnowledge(new StateKnowledge(new ModelPair(ORIGINAL, NEW)) {
            @Override
            protected void registerNewFunctions() {}
        });
        converter.addLink(device);
        converter.build();
        converter.start();
        connection.open();
    }

    private void run() {
        run(new HomeMonitor("Reports", device).found(LAMP, STATES), ServiceCall.of("light.turn_on", "light.lamp"));
    }

    private void awaitUp() {
        await().untilAsserted(
                        () -> assertThat(device.isUp()).as(device.describe()).isTrue());
    }

    private void awaitTrouble(String text) {
        await().untilAsserted(() -> assertThat(device.describe()).contains(text));
        assertThat(device.isUp()).isFalse();
    }

    private void awaitState(String state) {
        await().until(() -> converter.status().states().original().name().equals(state));
    }

    @Test
    void aServiceIsCalledAndTheStateConfirmsIt() {
        home.with(call -> {
            home.put("light.lamp", call.text("service").replace("turn_", ""), "{\"supported_features\":0}");
            return HomeImitation.done();
        });
        run();
        awaitUp();
        wall.submit("turn-on").join();
        awaitState("on");
        wall.submit("turn-off").join();
        awaitState("off");
        assertThat(home.calls())
                .containsExactly("light.turn_on light.lamp", "light.turn_off light.lamp {\"transition\":2}");
        assertThat(converter.status().doubt()).isEmpty();
    }

    @Test
    void whatHomeAssistantRefusesHasNoEffectAndIsNoDoubt() {
        home.with(call -> HomeImitation.failed("service_validation_error Not while it is locked"));
        run();
        awaitUp();
        assertThat(wall.submit("turn-on").join().toString()).contains("Not while it is locked");
        assertThat(converter.status().doubt()).isEmpty();
        assertThat(converter.status().states().original().name()).isEqualTo("off");
    }

    @Test
    void whatFailsInTheMiddleIsInDoubtUntilTheStateIsRead() {
        home.with(call -> {
            if (call.text("service").equals("turn_on")) {
                home.put("light.lamp", "on");
                return HomeImitation.failed("home_assistant_error The bridge did not answer");
            }
            return HomeImitation.done();
        });
        run();
        awaitUp();
        wall.submit("turn-on").join();
        awaitState("on");
        await().until(() -> converter.status().doubt().isEmpty());
    }

    @Test
    void aStateThatChangesOutsideIsFoundAlsoAfterALostConnectionAndARestart() throws Exception {
        run();
        awaitUp();
        home.put("light.lamp", "on");
        awaitState("on");
        home.drop();
        home.put("light.lamp", "off");
        awaitState("off");
        home.restart();
        home.put("light.lamp", "on");
        awaitState("on");
        awaitUp();
    }

    @Test
    void anUnavailableEntityIsABrokenLinkAndNoState() {
        run();
        awaitUp();
        home.put("light.lamp", "unavailable");
        awaitTrouble("light.lamp is unavailable in Home Assistant");
        assertThat(device.downSince()).isPresent();
        assertThat(wall.submit("turn-on").join().toString()).contains("unavailable");
        assertThat(home.calls()).isEmpty();
        home.put("light.lamp", "unknown");
        awaitTrouble("light.lamp is unknown in Home Assistant");
        home.put("light.lamp", "on");
        awaitState("on");
        awaitUp();
    }

    @Test
    void anEntityThatIsNotThereIsNamedWithTheNearest() {
        home.remove("light.lamp");
        home.put("light.lamb", "off");
        run();
        awaitTrouble("has no entity light.lamp; did you mean light.lamb?");
        home.put("light.lamp", "on");
        awaitState("on");
        awaitUp();
    }

    @Test
    void anEntityThatIsRenamedOrRemovedIsSaid() {
        run();
        awaitUp();
        home.rename("light.lamp", "light.desk");
        awaitTrouble("light.lamp is called light.desk now; write that name");
        home.drop();
        awaitTrouble("light.lamp is called light.desk now; write that name");
        home.rename("light.desk", "light.lamp");
        awaitUp();
        home.remove("light.lamp");
        awaitTrouble("light.lamp is no longer in Home Assistant; if it was removed");
    }

    @Test
    void anEntityThatIsDisabledIsSaid() {
        run();
        awaitUp();
        home.disable("light.lamp");
        awaitTrouble("light.lamp is disabled in Home Assistant; enable it in its settings");
        home.drop();
        awaitTrouble("light.lamp is disabled in Home Assistant; enable it in its settings");
        home.enable("light.lamp");
        home.put("light.lamp", "off");
        awaitUp();
        home.remove("light.lamp");
        awaitTrouble("light.lamp is no longer in Home Assistant; if it was removed");
    }

    @Test
    void aServiceThatIsNotThereOrThatTheEntityDoesNotSupportIsSaid() {
        run(new HomeMonitor("Reports", device).found(LAMP, STATES), ServiceCall.of("light.turn_onn", "light.lamp"));
        awaitTrouble("has no service light.turn_onn; did you mean light.turn_on");
    }

    @Test
    void aServiceOfAnotherKindOrWithoutTheFeatureIsSaid() {
        run(
                new HomeMonitor("Reports", device).found(LAMP, STATES),
                ServiceCall.of("cover.set_cover_position", "cover.gate"));
        awaitTrouble(
                "cover.gate does not support cover.set_cover_position; it supports cover.close_cover, cover.open_cover");
        home.put("cover.gate", "closed", "{\"supported_features\":15}");
        home.drop();
        awaitUp();
    }

    @Test
    void aServiceForOtherEntitiesIsSaid() {
        run(new HomeMonitor("Reports", device).found(LAMP, STATES), ServiceCall.of("cover.open_cover", "light.lamp"));
        awaitTrouble("light.lamp does not support cover.open_cover, which is for entities of other kinds");
    }

    @Test
    void whatTheConverterItselfShowsIsRefused() {
        home.registered("light.lamp", "evoloop_lamp_device_state");
        connection.shownAs("lamp");
        run();
        awaitTrouble("light.lamp is what this converter itself shows in Home Assistant");
        home.registered("light.lamp", "evoloop_other_state");
        home.drop();
        awaitUp();
    }

    @Test
    void aRefusedTokenIsSaidOnceAndNotTriedAgain() {
        token.set("wrong");
        run();
        awaitTrouble("refuses the token");
        assertThat(device.describe()).doesNotContain("wrong-").contains("long-lived access token");
        // The next attempts read the token again.
        token.set(HomeImitation.TOKEN);
        awaitUp();
        assertThat(home.logins()).containsExactly("wrong", HomeImitation.TOKEN);

        home.revoke("another");
        awaitTrouble("refuses the token");
        token.set("another");
        awaitUp();
        assertThat(home.logins()).containsExactly("wrong", HomeImitation.TOKEN, HomeImitation.TOKEN, "another");
    }

    @Test
    void nothingIsJudgedBeforeHomeAssistantHasStarted() {
        home.starting(true);
        home.remove("light.lamp");
        run();
        awaitTrouble("is starting");
        home.put("light.lamp", "on");
        home.starting(false);
        awaitState("on");
        awaitUp();
    }

    @Test
    void controllersPressByStatesAttributesEventsAndTriggers() {
        home.put("button.chime", "unknown");
        home.put("event.remote", "unknown");
        home.put("binary_sensor.door", "off");
        Meanings press = Meanings.NONE.with(Match.any(), "press");
        run(
                new HomeMonitor("Reports", device)
                        .found(LAMP, STATES)
                        .controller(EntityValue.state("button.chime"), press)
                        .controller(
                                EntityValue.attribute("event.remote", "event_type"),
                                Meanings.of(Map.of("double", "press")))
                        .controller(EntityValue.state("binary_sensor.door"), Meanings.of(Map.of("on", "press")))
                        .controller(HomeEvents.ofType("zha_event"), Meanings.at("/command", Map.of("hold", "press")))
                        .controller(HomeEvents.trigger("{\"trigger\":\"device\"}"), press),
                ServiceCall.of("light.turn_on", "light.lamp"));
        awaitUp();
        home.put("light.lamp", "on");
        awaitState("on");
        wall.submit("press").join();
        handledBefore = converter.status().events().handled();
        home.put("button.chime", "2026-11-28T10:00:00");
        awaitHandled(1);
        home.put("event.remote", "2026-11-28T10:00:01", "{\"event_type\":\"double\"}");
        awaitHandled(2);
        home.put("event.remote", "2026-11-28T10:00:02", "{\"event_type\":\"double\"}");
        awaitHandled(3);
        home.put("binary_sensor.door", "on", "{\"battery\":90}");
        awaitHandled(4);
        home.fire("zha_event", new JsonObject().put("command", "hold"));
        awaitHandled(5);
        home.trigger();
        awaitHandled(6);
        // What only repeats a state is none, nor is what was there before the connection.
        home.put("binary_sensor.door", "on", "{\"battery\":80}");
        home.drop();
        await().until(() -> home.logins().size() == 2);
        awaitUp();
        home.put("light.lamp", "off");
        awaitState("off");
        // All that was added is where the lamp was found.
        assertThat(converter.status().events().handled() - handledBefore).isEqualTo(7);
    }

    private void awaitHandled(int count) {
        await().until(() -> converter.status().events().handled() - handledBefore == count);
    }

    @Test
    void readingsAreThoseOfSensorsAndAttributes() {
        home.put("sensor.power", "12.5");
        device.reading("power", EntityValue.state("sensor.power"), "W")
                .reading("brightness", EntityValue.attribute("light.lamp", "brightness"), "");
        run();
        awaitUp();
        home.put("light.lamp", "on", "{\"brightness\":128}");
        await().until(() -> device.readings().size() == 2);
        assertThat(device.readings()).extracting(Reading::name).containsExactlyInAnyOrder("power", "brightness");
        home.put("light.lamp", "unavailable");
        await().until(() -> device.readings().size() == 1);
    }

    @Test
    void theCertificateMayBePinnedAndAnotherIsRefused(@TempDir Path folder) throws Exception {
        CompletableFuture<Integer> keytool = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "keytool")
                                .toString(),
                        "-genkeypair",
                        "-keyalg",
                        "EC",
                        "-alias",
                        "a",
                        "-dname",
                        "CN=home",
                        "-storetype",
                        "PKCS12",
                        "-keystore",
                        folder.resolve("keys").toString(),
                        "-storepass",
                        "changeit")
                .inheritIO()
                .start()
                .onExit()
                .thenApply(Process::exitValue);
        assertThat(keytool.join()).isZero();
        KeyStore keys = KeyStore.getInstance("PKCS12");
        try (InputStream in = Files.newInputStream(folder.resolve("keys"))) {
            keys.load(in, "changeit".toCharArray());
        }
        KeyManagerFactory managers = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
        managers.init(keys, "changeit".toCharArray());
        SSLContext context = SSLContext.getInstance("TLS");
        context.init(managers.getKeyManagers(), null, null);
        byte[] digest = MessageDigest.getInstance("SHA-256")
                .digest(keys.getCertificate("a").getEncoded());
        use(
                new HomeImitation(context.getServerSocketFactory()),
                "?sha256=" + HexFormat.of().formatHex(digest));
        run();
        awaitUp();
        try (HomeConnection other =
                new HomeConnection(HomeAddress.parse(home.url().replace("http", "https")), () -> HomeImitation.TOKEN)) {
            other.open();
            await().untilAsserted(() ->
                    assertThat(other.describe()).contains("certificate").contains("?sha256="));
        }
    }
}
