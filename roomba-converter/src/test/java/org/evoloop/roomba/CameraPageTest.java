package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.awaitility.Awaitility;
import org.evoloop.page.Browser;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;

/** The page in Chromium; the program has a robot's port and a network camera. */
@EnabledIf("org.evoloop.page.Browser#isThere")
@Timeout(180)
class CameraPageTest {
    private static final Pattern ADDRESS =
            Pattern.compile("(http://127\\.0\\.0\\.1:[0-9]+/) to look, (\\S+) to control");
    private static final String CAMERA = "document.querySelectorAll('#pictures figure')[1]";

    @TempDir
    private Path folder;

    @Test
    void whatTheRobotsCameraSeesIsOnThePage() throws Exception {
        Path log = folder.resolve("log");
        try (SimulatedWorld world = SimulatedWorld.inAnotherProcess(1, true);
                Browser browser = new Browser()) {
            String url = world.camera().orElseThrow().toString().replace("http://", "http://me:secret@");
            Process converter = Program.startWithLog(
                    log, "--port", world.port().toString(), "--no-guard", "--camera", url, "--page", "0", "--start");
            try {
                Awaitility.await()
                        .atMost(Duration.ofSeconds(60))
                        .until(() -> ADDRESS.matcher(Files.readString(log)).find());
                Matcher addresses = ADDRESS.matcher(Files.readString(log));
                assertThat(addresses.find()).isTrue();
                browser.looks(1280, 900, false);
                browser.open(addresses.group(1));
                browser.await(CAMERA + ".innerText.includes('the token')");

                browser.open("about:blank");
                browser.open(addresses.group(2));
                browser.await(CAMERA + ".innerText.startsWith('No picture yet. ')");
                OtherRobot.type(converter, "press clean\npress spot\n");
                browser.await(CAMERA + ".querySelector('img').naturalWidth === 640");
                browser.await("/^Taken [0-9.]+ s ago\\.$/.test(" + CAMERA + ".innerText)");
                for (int width : List.of(390, 1280)) {
                    for (boolean dark : List.of(true, false)) {
                        browser.looks(width, 900, dark);
                        browser.await(CAMERA + ".querySelector('img').complete");
                        assertThat(browser.evaluate("document.documentElement.scrollWidth"))
                                .isEqualTo(Integer.toString(width));
                        browser.picture(Path.of("target/camera-" + width + (dark ? "-dark.png" : "-light.png")));
                    }
                }
                OtherRobot.type(converter, "stop\n");
                browser.await(CAMERA + ".innerText.includes('The next picture is taken when')");
                browser.await(CAMERA + ".querySelector('img').naturalWidth === 640");
                assertThat(Files.readString(log)).doesNotContain("secret");
            } finally {
                converter.destroyForcibly().onExit().join();
            }
        }
    }
}
