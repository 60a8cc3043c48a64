package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.concurrent.CompletableFuture;
import org.evoloop.Logged;
import org.evoloop.config.Options;
import org.evoloop.homeassistant.HomeImitation;
import org.evoloop.payload.JsonRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** The lamp of devices/home-assistant-lamp in an imitated Home Assistant. */
@Timeout(120)
class DeviceOverHomeAssistantTest {
    private static final Path LAMP =
            Path.of(System.getProperty("evoloop.root", "../.."), "devices", "home-assistant-lamp");

    @RegisterExtension
    private final TypedConsole console = new TypedConsole();

    @TempDir
    private Path folder;

    private Path file(String from, String to) throws IOException {
        Files.copy(LAMP.resolve("README.md"), folder.resolve("README.md"));
        Files.writeString(folder.resolve("token"), HomeImitation.TOKEN + "\n");
        String text = Files.readString(LAMP.resolve("home-assistant-lamp.yaml"));
        assertThat(text).contains(from);
        return Files.writeString(folder.resolve("lamp.yaml"), text.replace(from, to));
    }

    private static void obey(HomeImitation home, JsonRecord call) {
        if (call.text("service").equals("turn_off")) {
            home.put("light.lamp", "off");
        } else {
            long brightness = call.inner("service_data").orElseThrow().number("brightness");
            home.put("light.lamp", "on", "{\"brightness\":" + brightness + "}");
        }
    }

    @Test
    void theLampIsOperatedByAButtonAndFollowsHomeAssistant() throws Exception {
        try (HomeImitation home = new HomeImitation()) {
            home.put("light.lamp", "off");
            home.put("input_button.lamp", "unknown");
            home.with(call -> {
                obey(home, call);
                return HomeImitation.done();
            });
            Path file = file(
                    "{home-assistant: \"http://homeassistant.local:8123\"",
                    "{home-assistant: \"" + home.url() + "\", token-file: token");
            CompletableFuture<Integer> status = console.run(file, "--start");
            await().until(() -> home.subscribers() == 1);
            home.put("input_button.lamp", "2026-11-28T10:00:00");
            console.awaitHistory("press (controller)  (Off, Off) -> (Bright, Fresh)");
            home.put("input_button.lamp", "2026-11-28T10:00:01");
            console.awaitHistory("press (controller)  (Bright, Fresh) -> (Dim, Dim)");
            console.awaitStatus("brightness 60");
            assertThat(home.calls())
                    .containsExactly(
                            "light.turn_on light.lamp {\"brightness\":255}",
                            "light.turn_on light.lamp {\"brightness\":60}");
            home.put("light.lamp", "off");
            console.awaitHistory("(Dim, Dim) -> (Off, Off)");
            console.exit(status);
        }
    }

    @Test
    void whatTheConverterItselfShowsUnderItsNameAtTheBrokerIsRefused() throws Exception {
        try (HomeImitation home = new HomeImitation();
                Logged logged = new Logged("org.evoloop.homeassistant")) {
            home.put("light.lamp", "off");
            home.put("input_button.lamp", "unknown");
            home.registered("light.lamp", "evoloop_desk_state");
            Path file = file(
                    "{home-assistant: \"http://homeassistant.local:8123\"",
                    "{home-assistant: \"" + home.url() + "\", token-file: token");
            // Nobody listens at this port, and nobody needs to.
            CompletableFuture<Integer> status = console.run(file, "--start", "--mqtt", "mqtt://127.0.0.1:1?id=desk");
            await().untilAsserted(() -> assertThat(logged.lines())
                    .anyMatch(
                            line -> line.contains("light.lamp is what this converter itself shows in Home Assistant")));
            console.exit(status);
        }
    }

    private String refused(String from, String to) throws IOException {
        Path file = file(from, to);
        return String.valueOf(catchThrowable(() -> DeviceFile.read(file, Options.of())));
    }

    @Test
    void anEntityThatIsOperatedIsNoController() throws IOException {
        assertThat(refused("{entity: input_button.lamp, event: press}", "{values: {\"on\": press}}"))
                .contains(
                        "lamp.yaml:20: light.lamp is operated by this converter, so it cannot be its controller, too");
    }

    @Test
    void whatIsNoEntityOrServiceIsAMistakeInItsLine() throws IOException {
        assertThat(refused("turn off: light.turn_off", "turn off: {service: turn off, entity: Lamp}"))
                .contains("lamp.yaml:12: entity: 'Lamp' is no entity's id")
                .contains("lamp.yaml:12: service: 'turn off' is no service");
    }

    @Test
    void aStateThatAnEntityNeverHasIsAMistake() throws IOException {
        assertThat(refused("{\"off\": \"Off\"}", "{\"of\": \"Off\", unavailable: \"Off\"}"))
                .contains("lamp.yaml:14: light.lamp is never 'of'; did you mean off or on?")
                .contains("lamp.yaml:14: an entity that is unavailable cannot be reached, which is no state");
    }

    @Test
    void aTokenInTheFileIsRefused() throws IOException {
        assertThat(refused(", entity: light.lamp}", ", entity: light.lamp, token: secret}"))
                .contains("lamp.yaml:6: a token in this file would be seen by everybody")
                .doesNotContain("secret");
    }

    @Test
    void whatIsNotThereIsSaidWithItsLine() throws Exception {
        try (HomeImitation home = new HomeImitation();
                Logged logged = new Logged("org.evoloop.homeassistant")) {
            home.put("light.lamb", "off");
            home.put("input_button.lamp", "unknown");
            Path file = file(
                    "{home-assistant: \"http://homeassistant.local:8123\"",
                    "{home-assistant: \"" + home.url() + "\", token-file: token");
            CompletableFuture<Integer> status = console.run(file, "--start");
            await().untilAsserted(() -> assertThat(logged.lines())
                    .anyMatch(line -> line.contains(
                            "lamp.yaml:10: " + home.url() + " has no entity light.lamp; did you mean light.lamb?")));
            console.exit(status);
        }
    }

    @Test
    void aTokenThatAllMayReadIsSaid() throws Exception {
        try (HomeImitation home = new HomeImitation();
                Logged logged = new Logged("org.evoloop.device")) {
            home.put("light.lamp", "off");
            home.put("input_button.lamp", "unknown");
            Path file = file(
                    "{home-assistant: \"http://homeassistant.local:8123\"",
                    "{home-assistant: \"" + home.url() + "\", token-file: token");
            Files.setPosixFilePermissions(folder.resolve("token"), PosixFilePermissions.fromString("rw-r--r--"));
            CompletableFuture<Integer> status = console.run(file, "--start");
            console.awaitStatus("link        up");
            console.exit(status);
            assertThat(logged.lines())
                    .anyMatch(line -> line.contains("chmod 600 " + folder.resolve("token")))
                    .noneMatch(line -> line.contains(HomeImitation.TOKEN));
        }
    }

    @Test
    void aTokenIsNeitherInTheAddressNorMissingInItsFile() throws IOException {
        String mistakes = refused(
                "{home-assistant: \"http://homeassistant.local:8123\"",
                "{home-assistant: \"http://me:secret@ha\", token-file: nowhere");
        assertThat(mistakes)
                .contains("lamp.yaml:6: home-assistant: Home Assistant's URL contains a login")
                .contains("lamp.yaml:6: token-file: ")
                .contains("nowhere cannot be read")
                .doesNotContain("secret");
    }
}
