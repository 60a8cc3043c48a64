package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;

/** The page in Chromium, as a person uses it. */
@EnabledIf("org.evoloop.page.Browser#isThere")
class BrowserTest {
    private static final String LIT =
            "[...document.querySelectorAll('#%s .state.now')].map(s => s.dataset.state).join()";
    private static final Picture ROOM = new Picture(
            "Room",
            "The room from above",
            "image/svg+xml",
            () -> Picture.View.of(
                    "<svg xmlns='http://www.w3.org/2000/svg' width='120' height='60'><style>.floor { fill: #888 }</style><rect class='floor' width='120' height='60'/></svg>"
                            .getBytes(StandardCharsets.UTF_8)));

    private static Browser browser;
    private final AtomicReference<Picture.View> seen =
            new AtomicReference<>(new Picture.View(new byte[0], "No picture yet: its lens is covered – naïvely."));
    private final AtomicInteger asked = new AtomicInteger();
    private Shown shown;

    @BeforeAll
    static void launch() throws Exception {
        browser = new Browser();
    }

    @AfterAll
    static void quit() {
        browser.close();
    }

    @BeforeEach
    void open() throws Exception {
        shown = new Shown(List.of(ROOM, new Picture("Camera", "What the camera saw", "image/jpeg", true, () -> {
            asked.incrementAndGet();
            return seen.get();
        })));
        browser.requests.clear();
        browser.complaints.clear();
        browser.looks(1280, 900, false);
    }

    @AfterEach
    void close() {
        browser.open("about:blank");
        shown.close();
    }

    private void lit(String original, String evolved) {
        browser.await("document.readyState === 'complete' && " + LIT.formatted("original") + " === '" + original
                + "' && " + LIT.formatted("new") + " === '" + evolved + "'");
    }

    private static String text(String id) {
        return browser.evaluate("document.getElementById('" + id + "').textContent");
    }

    /** Waits until the event of this number is explained. */
    private static void event(int number) {
        browser.await("document.getElementById('why').textContent.startsWith('Event" + number + ". ')");
    }

    private static void act(String event) {
        browser.evaluate("document.querySelector('.act[data-event=" + event + "]').click()");
    }

    private static void click(String buttonText) {
        browser.evaluate(
                "[...document.querySelectorAll('button')].find(b => b.textContent === '" + buttonText + "').click()");
    }

    @Test
    void anEventLightsWhereTheModelsAreAndSaysWhy() {
        shown.converter.start();
        browser.open(shown.address() + "/");
        lit("Off", "Off");

        shown.panel.press("Clean");
        lit("On", "On");
        shown.panel.press("Spot");
        lit("On", "Move");
        // The new state may be shown before the event has ended.
        browser.await("document.getElementById('headline').innerText === 'Spot began Move, which is new.'");
        assertThat(text("steps")).contains("On → Move", "Nothing is sent: the function of Move begins.");
        assertThat(text("why")).contains("the next state is new", "On → Move on Spot", "nothing");

        shown.panel.press("Clean");
        event(3);
        assertThat(text("headline")).isEqualTo("Clean had no effect in Move.");
        assertThat(text("facts")).contains("Robot itselfOn", "Battery93 %", "Dockedno", "Troublenone");
        shown.battery.set(7);
        browser.await("document.getElementById('facts').innerText.includes('7 %')");
    }

    @Test
    void theRemainingTimeOfTheStatesTimerRunsDown() {
        shown.converter.start();
        browser.open(shown.address() + "/");
        for (int press = 0; press < 3; press++) {
            shown.panel.press("Clean");
        }
        browser.await("/^9:5\\d$/.test(document.querySelector('#chain .left').textContent)");
        assertThat(text("chain")).startsWith("SpotWait").endsWith("timeoutOn");
    }

    @Test
    void noOtherHostIsRequestedAndNoErrorIsLogged() {
        shown.converter.start();
        browser.open(shown.address() + "/");
        lit("Off", "Off");
        browser.await("document.querySelector('#pictures img').naturalWidth === 120");
        assertThat(browser.requests)
                .isNotEmpty()
                .allMatch(url -> url.replaceFirst("^blob:", "").startsWith(shown.address()));
        // Without the token the answer is 401, which the browser logs.
        assertThat(browser.complaints).noneMatch(complaint -> !complaint.contains("/controls"));
    }

    private static byte[] jpeg(int width) throws IOException {
        BufferedImage picture = new BufferedImage(width, 60, BufferedImage.TYPE_INT_RGB);
        picture.setRGB(0, 0, 0xffffff);
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(picture, "jpg", file);
        return file.toByteArray();
    }

    @Test
    void aPictureComesWithItsNoteAndASentenceStandsForOneThatIsNotThere() throws Exception {
        String camera = "document.querySelectorAll('#pictures figure')[1]";
        browser.open(shown.address() + "/#token=" + shown.token);
        browser.await(camera + ".innerText === \"" + seen.get().note() + "\"");
        assertThat(browser.evaluate("getComputedStyle(" + camera + ".querySelector('img')).display"))
                .isEqualTo("none");

        seen.set(new Picture.View(jpeg(80), "Taken 0.3 s ago."));
        browser.await(camera + ".querySelector('img').naturalWidth === 80");
        assertThat(browser.evaluate(camera + ".innerText")).isEqualTo("Taken 0.3 s ago.");
        assertThat(browser.evaluate(camera + ".querySelector('img').checkVisibility()"))
                .isEqualTo("true");

        // Each picture is asked for apart, so the drawing may come after the camera's view.
        browser.await("""
                (() => {
                  const canvas = document.createElement('canvas').getContext('2d');
                  canvas.drawImage(document.querySelector('#pictures img'), 0, 0);
                  return String(canvas.getImageData(9, 9, 1, 1).data);
                })() === '136,136,136,255'""");

        seen.set(new Picture.View(jpeg(96), ""));
        browser.await(camera + ".querySelector('img').naturalWidth === 96 && " + camera + ".innerText === ''");
        assertThat(browser.complaints).noneMatch(complaint -> !complaint.contains("/controls"));
    }

    @Test
    void aPrivatePictureIsShownOnlyWithTheToken() throws Exception {
        String camera = "document.querySelectorAll('#pictures figure')[1]";
        seen.set(new Picture.View(jpeg(80), "Taken 0.3 s ago."));
        browser.open(shown.address() + "/");
        browser.await("document.querySelector('#pictures img').naturalWidth === 120");
        browser.await(camera + ".innerText.includes('token')");
        assertThat(browser.evaluate("getComputedStyle(" + camera + ".querySelector('img')).display"))
                .isEqualTo("none");
        assertThat(browser.evaluate("fetch('/picture?number=1').then(answer => answer.status)"))
                .isEqualTo("401");
        assertThat(asked).as("not made without a login").hasValue(0);

        browser.evaluate("document.getElementById('token').value = '" + shown.token + "'");
        click("Let me control");
        browser.await(camera + ".querySelector('img').naturalWidth === 80");
        assertThat(browser.evaluate(camera + ".innerText")).isEqualTo("Taken 0.3 s ago.");
    }

    @Test
    void theHistoryIsLookedBackThroughWithTheKeyboard() {
        shown.converter.start();
        for (String button : List.of("Clean", "Spot", "Clean")) {
            shown.panel.press(button);
        }
        browser.open(shown.address() + "/");
        event(3);
        browser.evaluate("document.getElementById('position').focus()");
        browser.key("ArrowLeft", 37);
        event(2);
        lit("On", "Move");
        assertThat(text("moment")).isEqualTo("after event 2");
        browser.key("Home", 36);
        lit("On", "On");
        shown.panel.press("Clean");
        browser.await("document.getElementById('position').max === '3'");
        event(1);
        click("Live");
        event(4);
    }

    @Test
    void theTokenAllowsControl() {
        browser.open(shown.address() + "/");
        lit("Off", "Off");
        assertThat(browser.evaluate("document.getElementById('buttons').hidden"))
                .isEqualTo("true");
        browser.evaluate("document.getElementById('token').value = 'wrong'");
        click("Let me control");
        browser.await("document.getElementById('told').innerText.includes('not the token')");

        browser.open("about:blank");
        browser.open(shown.address() + "/#token=" + shown.token);
        browser.await("document.readyState === 'complete' && !document.getElementById('buttons').hidden");
        assertThat(browser.evaluate("location.href")).doesNotContain(shown.token);
        assertThat(browser.evaluate("document.cookie"))
                .as("not readable by scripts")
                .isEmpty();
        act("Clean");
        browser.await("document.getElementById('told').innerText === 'Clean: waits: stopped. Nothing was sent.'");
        click("start");
        browser.await("document.getElementById('answer').textContent.startsWith('start: running: ')");
        browser.await("document.querySelector('.act[data-event=Clean]').ariaDisabled === 'false'");
        act("Clean");
        lit("On", "On");
        click("Robot2");
        browser.await("document.getElementById('answer').textContent.includes('has replaced Robot')");
    }

    @Test
    void onlyASpareOfItsRoleIsOfferedForAComponent() {
        browser.open(shown.address() + "/#token=" + shown.token);
        browser.await("document.querySelectorAll('[data-exchange]').length === 2");
        assertThat(
                        browser.evaluate(
                                "[...document.querySelectorAll('[data-exchange]')].map(b => b.dataset.exchange + ' ' + b.textContent).join()"))
                .isEqualTo("Panel Panel2,Robot Robot2");
    }

    @Test
    void otherModelsAreTriedAsAShadowPutInAndTakenBack() {
        shown.converter.start();
        browser.open(shown.address() + "/");
        lit("Off", "Off");
        assertThat(browser.evaluate("document.getElementById('others').hidden")).isEqualTo("true");

        browser.open("about:blank");
        browser.open(shown.address() + "/#token=" + shown.token);
        browser.await("document.readyState === 'complete' && !document.getElementById('choose').hidden");
        browser.evaluate("document.getElementById('probation').value = '600'");
        click("Try beside");
        browser.await("document.getElementById('told-models').textContent.includes(\"shadow of 'hasty'\")");
        for (String button : List.of("Clean", "Spot", "Spot")) {
            shown.panel.press(button);
        }
        browser.await(
                "document.getElementById('shadow').textContent.includes('3 events, 1 of them decided differently')");
        // The differences are asked for apart, after each change.
        browser.await("document.getElementById('shadow').textContent.includes('It would be in (On, On).')"
                + " && document.getElementById('differences').children.length === 1");
        assertThat(text("differences"))
                .contains("Spot (controller)", "stays in (On, Move): not-acceptable", "(On, Move) -> (On, On)");
        assertThat(text("faults")).contains("breaks 'Who goes arrives'");

        click("Let it take over");
        browser.await(
                "document.getElementById('evolution').textContent.includes(\"'hasty', which took over from 'new'\")");
        assertThat(text("evolution")).contains("on probation for");
        browser.await("document.querySelector('#new svg .event[data-source=Move][data-event=Spot]')");
        browser.await("document.getElementById('shadow').textContent === ''"
                + " && document.getElementById('differences').textContent === ''");
        click("Roll back");
        browser.await("document.getElementById('evolution').textContent === ''");
        browser.await("!document.querySelector('#new svg .event[data-source=Move][data-event=Spot]')");

        click("Take over");
        browser.await("document.getElementById('told-models').textContent.includes(\"evolved to 'hasty'\")");
    }

    @Test
    void aViolationOfAPropertyOfTimeIsAnEventThatHasFailed() {
        shown.converter.start();
        browser.open(shown.address() + "/");
        lit("Off", "Off");
        shown.panel.press("arriveSpot");
        browser.await("document.getElementById('position').max === '1'");
        // Either may end first.
        assertThat(browser.evaluate("""
                        ['0', '1'].map(number => {
                          const position = document.getElementById('position');
                          position.value = number;
                          position.dispatchEvent(new Event('input'));
                          return document.getElementById('event').textContent;
                        }).join()"""))
                .contains("Violation of Who arrives has left.", "arriveSpot had no effect in Off.");
        assertThat(text("facts")).contains("TroubleWho arrives has left, ");
    }

    @Test
    void aBrowserLeavesNoProcessAndNoFolder() throws Exception {
        Browser another = new Browser();
        Path profile = another.profile();
        assertThat(another.processes()).isNotEmpty();
        another.close();
        assertThat(another.processes()).isEmpty();
        assertThat(profile).doesNotExist();
    }

    @Test
    void aScreenReaderFindsItsWay() {
        browser.open(shown.address() + "/");
        lit("Off", "Off");
        String unnamed = browser.evaluate("[...document.querySelectorAll('button, input, select')]"
                + ".filter(e => !(e.ariaLabel || e.textContent.trim() || (e.labels && e.labels.length)))"
                + ".map(e => e.id).join()");
        assertThat(unnamed).isEmpty();
        assertThat(browser.evaluate("document.querySelector('#new svg').ariaLabel"))
                .contains("Now Off");
        assertThat(browser.evaluate(
                        "document.querySelectorAll('h1').length + ',' + document.querySelectorAll('main').length"))
                .isEqualTo("1,1");
        assertThat(browser.evaluate("document.querySelector('#told-now').ariaLive"))
                .isEqualTo("polite");
    }
}
