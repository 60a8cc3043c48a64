package org.evoloop.models.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.awaitility.Awaitility;
import org.evoloop.models.device.DeviceCommands;
import org.evoloop.page.Browser;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The studio in Chromium, as an author uses it. */
@EnabledIf("org.evoloop.page.Browser#isThere")
class StudioPageTest {
    private static final String LAMP = """
            ```mermaid
            ---
            title: original
            ---
            stateDiagram-v2
                [*] --> off
                off --> on : switch
                on --> off : switch
            ```
            ```mermaid
            ---
            title: new
            ---
            stateDiagram-v2
                %% it goes off by itself
                [*] --> off
                off --> on : switch
                on --> wait : switch
                wait --> off : tm(2s)
            ```
            """;
    private static final int LINE_OF_WAIT = 18;

    private static Browser browser;

    @TempDir
    private Path folder;

    @TempDir
    private Path other;

    private StudioWindow window;

    @BeforeAll
    static void launch() throws Exception {
        browser = new Browser();
    }

    @AfterAll
    static void quit() {
        browser.close();
    }

    @BeforeEach
    void start() throws Exception {
        browser.looks(1280, 900, false);
        browser.requests.clear();
        browser.complaints.clear();
        window = new StudioWindow(browser, folder, other.resolve("token"));
    }

    @AfterEach
    void end() {
        browser.open("about:blank");
        window.close();
    }

    private void lamp() throws Exception {
        Files.writeString(folder.resolve("lamp.md"), LAMP);
        window.open();
        window.awaitState("new", "wait");
    }

    private void go(int line) {
        browser.evaluate("(() => { const text = document.querySelector('#text'); text.focus();"
                + " const end = text.value.split('\\n').slice(0, " + line + ").join('\\n').length;"
                + " text.setSelectionRange(end, end); })()");
    }

    private void undo() {
        browser.click("#undo");
        window.quiet();
    }

    @Test
    void aLineAndItsElementArePickedTogether() throws Exception {
        lamp();
        go(LINE_OF_WAIT);
        browser.await("document.querySelector('.view[data-side=new] .event.taken')?.dataset.source === 'on'");
        // The plan of the arrow, through the device itself.
        browser.await("document.querySelector('.plan-says').textContent.includes('wait')");
        go(LINE_OF_WAIT + 1);
        browser.await("document.querySelector('.view[data-side=original] .event.plan')?.dataset.source === 'on'");
        browser.await("document.querySelector('.plan-says').textContent === 'The device: on → off; sends switch'");
        window.pick("new", "wait");
        browser.await("document.querySelector('.lines .at .no').textContent === '" + LINE_OF_WAIT + "'");
        assertThat(browser.complaints).isEmpty();
        assertThat(browser.requests)
                .allMatch(request -> request.startsWith("http://127.0.0.1:") || request.startsWith("about:"));
    }

    @Test
    void halfTypedTextKeepsTheLastGoodPictureAndMarksTheLine() throws Exception {
        lamp();
        go(LINE_OF_WAIT);
        browser.type("\n    wait --> ");
        browser.await("document.querySelector('.view[data-side=new]').classList.contains('stale')");
        assertThat(window.states("new")).isEqualTo("off,on,wait");
        browser.await("[...document.querySelectorAll('.lines .error .no')].map(no => no.textContent).join() === '"
                + (LINE_OF_WAIT + 1) + "'");
        browser.type("on : again");
        window.awaitArrow("new", "wait", "on", "again");
        browser.await("!document.querySelector('.stale')");
    }

    @Test
    void aWarningIsMarkedAsOneAndNotAsAnError() throws Exception {
        lamp();
        go(LINE_OF_WAIT + 1);
        browser.type("\n    wait --> warm : switch");
        browser.await("document.querySelector('.view[data-side=new] .state.warned')?.dataset.state === 'warm'");
        String line = String.valueOf(LINE_OF_WAIT + 2);
        browser.await(
                "[...document.querySelectorAll('.lines .warning .no')].some(no => no.textContent === '" + line + "')");
        assertThat(browser.evaluate("String(document.querySelectorAll('.chart .wrong, .lines .error').length)"))
                .isEqualTo("0");
        browser.await("getComputedStyle(document.querySelector('.state.warned .box')).stroke"
                + " === getComputedStyle(document.querySelector('.pill.warn')).color");
    }

    @Test
    void editsAndUndosKeepTextAndPictureEqual() throws Exception {
        lamp();
        List<String> texts = new ArrayList<>();
        List<String> pictures = new ArrayList<>();
        for (int number = 0; number < 10; number++) {
            remember(texts, pictures);
            window.addState("new", "s" + number);
            remember(texts, pictures);
            window.drag("new", number == 0 ? "wait" : "s" + (number - 1), "s" + number, "e" + number);
            remember(texts, pictures);
            window.pick("new", "s" + number);
            rename("s" + number, "s" + number + "x");
            remember(texts, pictures);
            rename("s" + number + "x", "s" + number);
        }
        for (int step = texts.size() - 1; step >= 0; step--) {
            while (!window.text().equals(texts.get(step))) {
                undo();
            }
            assertThat(window.states("new") + window.arrows("new")).isEqualTo(pictures.get(step));
        }
        assertThat(window.text()).isEqualTo(LAMP).contains("%% it goes off by itself");
        for (int step = 0; step < texts.size() / 2; step++) {
            browser.click("#redo");
        }
        window.quiet();
        assertThat(window.states("new")).contains("s0");
    }

    private void remember(List<String> texts, List<String> pictures) {
        texts.add(window.text());
        pictures.add(window.states("new") + window.arrows("new"));
    }

    private void rename(String from, String to) {
        browser.await("document.querySelector('#state-name')?.value === '" + from + "'");
        browser.evaluate("document.querySelector('#state-name').select()");
        window.focus("#state-name");
        browser.type(to);
        browser.enter();
        window.awaitState("new", to);
    }

    @Test
    void anOlderAnswerNeverReplacesANewerOne() throws Exception {
        lamp();
        CountDownLatch slow = window.hold();
        go(LINE_OF_WAIT);
        int before = asked("draw");
        browser.type("\n    wait --> old");
        Awaitility.await().until(() -> asked("draw") > before);
        window.goOn();
        browser.type("er : b");
        window.awaitState("new", "older");
        slow.countDown();
        window.quiet();
        assertThat(window.states("new")).isEqualTo("off,older,on,wait");
        assertThat(window.text()).contains("wait --> older : b");
    }

    private int asked(String what) {
        return (int) browser.requests.stream()
                .filter(request -> request.endsWith("/api/" + what))
                .count();
    }

    @Test
    void aKilledServerTakesNothingAway() throws Exception {
        lamp();
        window.kill();
        go(LINE_OF_WAIT);
        browser.type("\n    wait --> on : again");
        browser.await("document.querySelector('#banners').innerText.includes('The studio has ended')");
        window.startAgain();
        window.awaitArrow("new", "wait", "on", "again");
        browser.await("document.querySelector('#banners').innerText === ''");
        browser.evaluate("location.reload()");
        window.awaitArrow("new", "wait", "on", "again");
        window.save();
        assertThat(folder.resolve("lamp.md")).content().contains("wait --> on : again");
    }

    @Test
    void aStudioThatIsStartedAnewAsksForItsTokenAndKeepsWhatWasTyped() throws Exception {
        lamp();
        window.kill();
        Files.delete(other.resolve("token"));
        go(LINE_OF_WAIT);
        browser.type("\n    wait --> on : again");
        window.startAgain();
        browser.await("document.querySelector('#banners').innerText.includes('The studio was started anew')");
        window.focus("#banners input");
        browser.type("not the token");
        browser.enter();
        browser.await("document.querySelector('#banners').innerText.includes('not the one')");
        assertThat(window.text()).contains("wait --> on : again");
        browser.evaluate("document.querySelector('#banners input').select()");
        browser.type(window.address());
        browser.enter();
        window.awaitArrow("new", "wait", "on", "again");
        browser.await("document.querySelector('#banners').innerText === ''");
        window.save();
        assertThat(folder.resolve("lamp.md")).content().contains("wait --> on : again");
    }

    @Test
    void whatIsTypedOnASlowNetworkIsNeitherLostNorTakenForSaved() throws Exception {
        lamp();
        go(LINE_OF_WAIT);
        browser.type("\n    wait --> on : first");
        browser.network(400);
        browser.control("s", 83);
        browser.type(" / blink");
        browser.await("document.querySelector('#save').disabled === false");
        Awaitility.await()
                .untilAsserted(
                        () -> assertThat(folder.resolve("lamp.md")).content().contains("first"));
        window.awaitArrow("new", "wait", "on", "first");
        assertThat(window.text()).contains("wait --> on : first / blink");
        assertThat(folder.resolve("lamp.md")).content().doesNotContain("blink");
        assertThat(browser.evaluate("document.querySelector('#unsaved').textContent"))
                .contains("1 file not saved");
        browser.network(0);
        window.save();
        assertThat(folder.resolve("lamp.md")).content().contains("wait --> on : first / blink");
    }

    @Test
    void aRunIsKeptAsAScenarioThatTheDeviceFilesCheckPlays() throws Exception {
        Files.writeString(folder.resolve("lamp.md"), LAMP);
        Files.writeString(folder.resolve("lamp.yaml"), """
                converter: lamp
                models: {original: lamp.md#original, new: lamp.md#new}
                connections:
                  lamp: {lines: "tcp://127.0.0.1:4001"}
                device:
                  send: {switch: SW}
                  answer: {ok: OK, within: 2 s}
                controller:
                  press: {button: switch}
                functions:
                  wait: {}
                """);
        window.open();
        window.awaitState("new", "wait");
        window.button("#try", "switch");
        browser.await("document.querySelector('#try-new').textContent === 'on'");
        window.button("#try", "switch");
        browser.await("document.querySelector('#try-new').textContent === 'wait'");
        window.button("#try", "let 2 s pass");
        browser.await("document.querySelector('#try-new').textContent === 'off'");
        window.button("#try", "Keep as scenario");
        browser.evaluate("document.querySelector('#dialog input').select()");
        browser.type("it waits, then it's off");
        window.button("#dialog", "Keep it");
        browser.await("document.querySelector('#text').value.includes('scenarios:')");
        window.save();
        browser.await("!document.querySelector('.lines .error')");
        String file = folder.resolve("lamp.yaml").toString();
        assertThat(Path.of(file)).content().contains("'it waits, then it''s off':", "sent: [switch]");
        assertThat(DeviceCommands.run(List.of("check", file), models -> 0)).isZero();
        Files.writeString(Path.of(file), Files.readString(Path.of(file)).replace("state: wait", "state: 'on'"));
        assertThat(DeviceCommands.run(List.of("check", file), models -> 0)).isEqualTo(1);
    }

    @Test
    void aModelThatIsTooLargeIsSaidAtOnce() throws Exception {
        StringBuilder large = new StringBuilder("stateDiagram-v2\n    [*] --> s0\n");
        for (int i = 0; i < 700; i++) {
            large.append("    s").append(i).append(" --> s").append(i + 1).append(" : e\n");
        }
        Files.writeString(folder.resolve("original.mmd"), large);
        Files.writeString(folder.resolve("new.mmd"), large);
        window.open();
        browser.await(
                "document.querySelector('.view[data-side=new] .note').innerText.includes('too many for a picture')");
        browser.evaluate("document.querySelector('#detail').value = 'around'");
        browser.evaluate("document.querySelector('#detail').dispatchEvent(new Event('change'))");
        go(5);
        browser.await("document.querySelector('.view[data-side=new] .state[data-state=s2]')");
        assertThat(window.states("new")).isEqualTo("s2,s3");
        go(300);
        browser.await("document.querySelector('.view[data-side=new] .state[data-state=s297]')");
        browser.type("\n    s297 --> s0 : home");
        window.awaitArrow("new", "s297", "s0", "home");
    }

    @Test
    void theMinimapShowsWhatIsSeenOfALargePictureAndMovesIt() throws Exception {
        StringBuilder long40 = new StringBuilder("stateDiagram-v2\n    [*] --> s0\n");
        for (int i = 0; i < 40; i++) {
            long40.append("    s").append(i).append(" --> s").append(i + 1).append(" : e\n");
        }
        Files.writeString(
                folder.resolve("original.mmd"), LAMP.substring(LAMP.indexOf("stateDiagram"), LAMP.indexOf("```\n```")));
        Files.writeString(folder.resolve("new.mmd"), long40);
        window.open();
        window.awaitState("new", "s40");
        String mini = ".view[data-side=\"new\"] .mini";
        browser.await("!document.querySelector('" + mini + "').classList.contains('all')");
        browser.await("document.querySelector('.view[data-side=original] .mini').classList.contains('all')");
        String left = "document.querySelector('" + mini + " .win').x.baseVal.value";
        browser.await(left + " === 0");
        browser.click(mini);
        browser.await(left + " > 100");
        assertThat(browser.evaluate(
                        "String(document.querySelector('.view[data-side=new] svg.chart').viewBox.baseVal.x > 100)"))
                .isEqualTo("true");
        browser.click(".view[data-side=new] [data-zoom=fit]");
        browser.await("document.querySelector('" + mini + "').classList.contains('all')");
    }

    @Test
    void theSurroundingsFollowWhatIsPicked() throws Exception {
        lamp();
        browser.evaluate("document.querySelector('#detail').value = 'around'");
        browser.evaluate("document.querySelector('#detail').dispatchEvent(new Event('change'))");
        go(LINE_OF_WAIT + 1);
        browser.await("!document.querySelector('.view[data-side=new] .state[data-state=on]')");
        assertThat(window.states("new")).isEqualTo("off,wait");
        browser.click(".view[data-side=new] .state[data-state=off] .box");
        browser.await("document.querySelector('.view[data-side=new] .state[data-state=on]')");
        assertThat(window.states("new")).isEqualTo("off,on");
    }

    @Test
    void twoWindowsAndTheDiskLoseNothing() throws Exception {
        lamp();
        go(LINE_OF_WAIT);
        browser.type("\n    wait --> on : first");
        window.awaitArrow("new", "wait", "on", "first");
        String first = browser.another();
        browser.looks(1280, 900, false);
        window.openAnother();
        window.awaitState("new", "wait");
        assertThat(window.text()).isEqualTo(LAMP);
        go(LINE_OF_WAIT);
        browser.type("\n    wait --> on : second");
        window.awaitArrow("new", "wait", "on", "second");
        window.save();

        browser.goOn(first);
        browser.control("s", 83);
        browser.await("document.querySelector('#banners').innerText.includes('has changed on the disk')");
        assertThat(window.text()).contains("first").doesNotContain("second");
        assertThat(folder.resolve("lamp.md")).content().contains("second").doesNotContain("first");
        window.button("#banners", "Take the disk’s");
        window.awaitArrow("new", "wait", "on", "second");
        undo();
        window.awaitArrow("new", "wait", "on", "first");
        window.save();
        assertThat(folder.resolve("lamp.md")).content().contains("first").doesNotContain("second");
    }

    @Test
    void theLineBreaksOfAFileStay() throws Exception {
        lamp();
        Files.writeString(folder.resolve("lamp.md"), LAMP.replace("\n", "\r\n"));
        window.open();
        window.awaitState("new", "wait");
        go(LINE_OF_WAIT);
        browser.type("\n    wait --> on : again");
        window.awaitArrow("new", "wait", "on", "again");
        window.drag("new", "wait", "on", "wink");
        window.save();
        String saved = Files.readString(folder.resolve("lamp.md"));
        assertThat(saved).contains("again\r\n", "wink\r\n");
        assertThat(saved.replace("\r\n", "")).doesNotContain("\n", "\r");
    }

    @Test
    void whyAFileCannotBeSavedIsTold() throws Exception {
        lamp();
        go(LINE_OF_WAIT);
        browser.type("\n    wait --> on : again");
        window.awaitArrow("new", "wait", "on", "again");
        Files.setPosixFilePermissions(folder.resolve("lamp.md"), PosixFilePermissions.fromString("r--r--r--"));
        browser.control("s", 83);
        browser.await(
                "document.querySelector('#banners').innerText.includes('lamp.md is not saved. lamp.md is read-only')");
        Files.setPosixFilePermissions(folder.resolve("lamp.md"), PosixFilePermissions.fromString("rw-r--r--"));
        window.save();
        browser.await("document.querySelector('#banners').innerText === ''");
    }

    @Test
    void aFileThatIsDeletedMeanwhileIsToldAndItsTextStays() throws Exception {
        lamp();
        Files.delete(folder.resolve("lamp.md"));
        browser.evaluate("dispatchEvent(new Event('focus'))");
        browser.await("document.querySelector('#banners').innerText.includes('lamp.md is no longer on the disk')");
        assertThat(window.text()).isEqualTo(LAMP);
        window.button("#banners", "Write it again");
        browser.await("document.querySelector('#banners').innerText === ''");
        assertThat(folder.resolve("lamp.md")).content().isEqualTo(LAMP);

        go(LINE_OF_WAIT);
        browser.type("\n    wait --> on : again");
        window.awaitArrow("new", "wait", "on", "again");
        Files.delete(folder.resolve("lamp.md"));
        browser.control("s", 83);
        browser.await("document.querySelector('#banners').innerText.includes('lamp.md is no longer on the disk')");
        window.save();
        assertThat(folder.resolve("lamp.md")).content().contains("again");
    }

    @Test
    void whatAClosedWindowHasTypedIsTakenOver() throws Exception {
        lamp();
        go(LINE_OF_WAIT);
        browser.type("\n    wait --> on : again");
        window.awaitArrow("new", "wait", "on", "again");
        browser.open("about:blank");
        browser.await("location.href === 'about:blank'");
        browser.another();
        browser.looks(1280, 900, false);
        window.openAnother();
        window.awaitArrow("new", "wait", "on", "again");
        assertThat(folder.resolve("lamp.md")).content().isEqualTo(LAMP);
    }

    @Test
    void aCounterexampleIsPlayedInThePicture() throws Exception {
        lamp();
        window.button("#tools", "Properties");
        window.focus("#property");
        browser.type("It is never left on: always not wait");
        browser.enter();
        browser.await("document.querySelector('#properties').innerText.includes('Does not hold')");
        window.button("#properties", "Play it");
        browser.await("document.querySelector('#try-new').textContent === 'wait'");
        browser.await("document.querySelector('.view[data-side=new] .state.now').dataset.state === 'wait'");
        window.button("#try", "One back");
        browser.await("document.querySelector('#try-new').textContent === 'on'");
        window.button("#try", "switch");
        browser.await("document.querySelector('#try-new').textContent === 'wait'");
        window.button("#try", "let 2 s pass");
        browser.await("document.querySelector('#try-new').textContent === 'off'");
    }

    @Test
    void aKeywordStaysAndAGuardIsUnderstoodWhereTheEventIsWritten() throws Exception {
        Files.writeString(
                folder.resolve("lamp.md"), LAMP.replace("on --> off : switch", "on --> off : «spontaneous» burnt"));
        window.open();
        window.awaitState("new", "wait");
        go(8);
        browser.await(
                "document.querySelector('#trigger')?.value === 'burnt' && document.querySelector('#own').checked");
        window.focus("#trigger");
        browser.evaluate("document.querySelector('#trigger').setSelectionRange(99, 99)");
        browser.type(" out");
        browser.enter();
        window.awaitArrow("original", "on", "off", "burnt out");
        assertThat(window.text()).contains("on --> off : «spontaneous» burnt out");
        browser.click("#own");
        browser.await("document.querySelector('#text').value.includes('on --> off : burnt out')");
        window.drag("new", "on", "wait", "wink [dark]", "wink");
        assertThat(window.text()).contains("on --> wait : wink [dark]");
    }

    @Test
    void theKeyboardAloneSuffices() throws Exception {
        lamp();
        window.focus(".view[data-side=\"new\"] .port");
        browser.key("n", 78);
        browser.await("document.querySelector('#state-name')?.value === 'off'");
        browser.key("n", 78);
        browser.await("document.querySelector('#state-name')?.value === 'on'");
        browser.key("a", 65);
        browser.await("document.activeElement.id === 'new-target'");
        browser.type("w");
        browser.key("w", 87);
        window.focus("#new-event");
        browser.type("wink");
        browser.enter();
        browser.await("document.querySelector('#text').value.includes(': wink')");
        window.quiet();
        browser.control("z", 90);
        browser.await("!document.querySelector('#text').value.includes(': wink')");
        browser.control("y", 89);
        browser.await("document.querySelector('#text').value.includes(': wink')");
    }

    @ParameterizedTest
    @CsvSource({"390,844", "768,1024", "1280,800"})
    void nothingIsCutAtAnyWidth(int width, int height) throws Exception {
        for (boolean dark : new boolean[] {false, true}) {
            browser.looks(width, height, dark);
            lamp();
            for (String view : List.of("text", "picture", "try", "properties", "findings")) {
                browser.evaluate("(document.querySelector('#tools [data-tool=" + view + "]')?.click(),"
                        + " document.querySelector('#views [data-show=" + view + "]').click())");
                assertThat(browser.evaluate("String(Math.max(innerWidth, document.documentElement.scrollWidth))"))
                        .as(view)
                        .isEqualTo(String.valueOf(width));
                assertThat(
                                browser.evaluate(
                                        "[...document.querySelectorAll('button, input, select')].filter(one =>"
                                                + " one.offsetParent && one.getBoundingClientRect().height < 30).map(one => one.outerHTML).join()"))
                        .as(view)
                        .isEmpty();
            }
        }
    }
}
