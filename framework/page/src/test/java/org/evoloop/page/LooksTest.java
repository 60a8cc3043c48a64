package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.awaitility.Awaitility;
import org.evoloop.PaperModels;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the page shows first, whatever the window, the colours and the state; time is the converter's. */
@EnabledIf("org.evoloop.page.Browser#isThere")
class LooksTest {
    private static final Picture ROOM = new Picture(
            "Room",
            "The room from above",
            "image/svg+xml",
            () -> Picture.View.of("<svg xmlns='http://www.w3.org/2000/svg' width='240' height='160'/>"
                    .getBytes(StandardCharsets.UTF_8)));

    /** What is cut, or sticks out of what holds it; nothing else may hide a text. */
    private static final String CUT = """
            [...document.querySelectorAll('body *')].filter(e => e.checkVisibility() && !e.closest('svg, .port, .sr, .skip, option, .cell, .arr, .track'))
              .filter(e => e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0 && getComputedStyle(e).display !== 'inline'
                || e.getBoundingClientRect().right > innerWidth + 1 || e.getBoundingClientRect().left < -1)
              .map(e => e.tagName + '#' + e.id + '.' + e.className).join()""";

    /** Which texts lie on each other. */
    private static final String OVERLAPS = """
            (() => {
              const leaves = [...document.querySelectorAll('main *, header *')].filter(e => e.checkVisibility() && !e.closest('svg, .port, .sr, .skip, option')
                && [...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim()));
              const boxes = leaves.flatMap(e => [...e.childNodes].filter(n => n.nodeType === 3 && n.textContent.trim()).flatMap(n => {
                const range = document.createRange();
                range.selectNodeContents(n);
                return [...range.getClientRects()].map(r => [e, r]);
              }));
              const over = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 2 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 6;
              return boxes.flatMap(([e, a], i) => boxes.slice(i + 1).filter(([f, b]) => e !== f && over(a, b) && !e.closest('.log') && !f.closest('.log'))
                .map(([f]) => e.textContent + ' | ' + f.textContent)).join('; ');
            })()""";

    /** Texts with too little contrast (4.5 to 1) to the colour behind them. */
    private static final String FAINT = """
            (() => {
              const pixel = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
              const rgb = colour => {
                pixel.clearRect(0, 0, 1, 1);
                pixel.fillStyle = colour;
                pixel.fillRect(0, 0, 1, 1);
                return [...pixel.getImageData(0, 0, 1, 1).data];
              };
              const light = ([r, g, b]) => [r, g, b].map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
                .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
              const behind = e => { for (let at = e; at; at = at.parentElement) { const c = rgb(getComputedStyle(at).backgroundColor); if (c[3] > 250) return c; } return [255, 255, 255]; };
              const contrast = (a, b) => { const [x, y] = [light(a), light(b)].sort((p, q) => q - p); return (x + 0.05) / (y + 0.05); };
              const html = [...document.querySelectorAll('body *')].filter(e => e.checkVisibility() && !e.closest('svg, option')
                && [...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim()));
              const faint = html.filter(e => contrast(rgb(getComputedStyle(e).color), behind(e)) < 4.5).map(e => e.className + ': ' + e.textContent);
              const card = rgb(getComputedStyle(document.querySelector('.card')).backgroundColor);
              const drawn = [...document.querySelectorAll('.chart text')].filter(e => e.checkVisibility()).filter(e => {
                const box = e.closest('.state')?.querySelector('.box');
                return contrast(rgb(getComputedStyle(e).fill), box ? rgb(getComputedStyle(box).fill) : card) < 4.5;
              }).map(e => e.getAttribute('class') + ': ' + e.textContent);
              return [...faint, ...drawn].join('; ');
            })()""";

    /** Whether the state in which it is stands in the middle of the window, as far as there is more on both sides. */
    private static final String IN_VIEW = """
            (() => {
              const { x, width } = document.querySelector('#new svg.chart').viewBox.baseVal;
              const whole = document.querySelector('.view:has(#new) .mini').viewBox.baseVal.width;
              const box = document.querySelector('#new .state.now .box').getBBox();
              return Math.abs(box.x + box.width / 2 - x - width / 2) < 2 || (x < 1 || x + width > whole - 1) && box.x >= x - 1 && box.x + box.width <= x + width + 1;
            })()""";

    private static final String PLACES =
            "[...document.querySelectorAll('.act')].map(b => [b.dataset.event, b.getBoundingClientRect().x, b.getBoundingClientRect().y].join(' ')).join()";

    private static Browser browser;
    private final ManualClock clock = new ManualClock();
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
        shown = new Shown(List.of(ROOM), clock);
        shown.converter.start();
        browser.complaints.clear();
        browser.looks(1280, 900, false);
    }

    @AfterEach
    void close() {
        browser.open("about:blank");
        shown.close();
    }

    private void look() {
        browser.open(shown.address() + "/#token=" + shown.token);
        browser.await(
                "document.readyState === 'complete' && document.querySelector('#chain .st') && document.querySelector('.act')");
    }

    private static String text(String selector) {
        return browser.evaluate("document.querySelector('" + selector + "').textContent");
    }

    private void press(String... events) {
        for (String event : events) {
            int before = shown.converter.history().size();
            shown.panel.press(event);
            Awaitility.await().until(() -> shown.converter.history().size() > before);
        }
    }

    @ParameterizedTest
    @CsvSource({"390,light", "390,dark", "768,light", "768,dark", "1280,light", "1280,dark"})
    void nothingIsCutOverlapsOrIsFaint(int width, String colours) throws Exception {
        shown.tryHasty();
        press("Clean", "Spot", "Spot", "arriveSpot");
        browser.looks(width, 900, colours.equals("dark"));
        look();
        browser.await("document.querySelector('#chain .st').textContent === 'Spot'");
        browser.await("document.getElementById('differences').children.length === 2");
        for (String folds : List.of("closed", "open")) {
            browser.evaluate(
                    "document.querySelectorAll('details').forEach(d => { d.open = " + folds.equals("open") + "; })");
            browser.picture(Path.of("target/page-" + width + "-" + colours + "-" + folds + ".png"));
            assertThat(browser.evaluate("document.documentElement.scrollWidth")).isEqualTo(Integer.toString(width));
            assertThat(browser.evaluate(CUT)).isEmpty();
            assertThat(browser.evaluate(OVERLAPS)).isEmpty();
            assertThat(browser.evaluate(FAINT)).isEmpty();
        }
    }

    @ParameterizedTest
    @CsvSource({"390", "768", "1280"})
    void longNamesAreBrokenRatherThanCut(int width) throws Exception {
        shown.close();
        Map<State, String> names = Map.of(
                new State("SpotWait"), "WaitingForASecondPressOfTheCleanButton", new State("On"), "掃除の開始位置で待っています");
        ModelPair paper = PaperModels.cleaningRobot();
        shown = new Shown(
                List.of(),
                clock,
                new ModelPair(
                        paper.original().withStateNames(Map.of(new State("On"), names.get(new State("On")))),
                        paper.evolved().withStateNames(names)));
        shown.converter.start();
        press("Clean", "Clean", "Clean");
        browser.looks(width, 900, false);
        look();
        browser.await("document.querySelector('#chain .st').textContent.startsWith('Waiting')");
        browser.picture(Path.of("target/page-" + width + "-long.png"));
        assertThat(browser.evaluate("document.documentElement.scrollWidth")).isEqualTo(Integer.toString(width));
        assertThat(browser.evaluate(CUT)).isEmpty();
        assertThat(browser.evaluate(OVERLAPS)).isEmpty();
        browser.evaluate("document.querySelector('[data-view=all]').click()");
        browser.await("document.querySelector('#new .state.now')");
        assertThat(browser.evaluate(CUT)).isEmpty();
    }

    @Test
    void whereItIsStaysInView() {
        press("Clean");
        browser.looks(240, 900, false);
        look();
        browser.evaluate("document.querySelector('[data-view=all]').click()");
        for (String event : List.of("Clean", "Clean", "Clean")) {
            press(event);
            List<HistoryEntry> history = shown.converter.history();
            String now = history.get(history.size() - 1).after().evolved().name();
            browser.await("document.querySelector('#new .state.now')?.dataset.state === '" + now + "'");
            browser.await(IN_VIEW);
        }
    }

    @ParameterizedTest
    @CsvSource({"390,844", "1280,900"})
    void theFirstScreenSaysWhatItDoesHowLongAndWhatCanBeDone(int width, int height) {
        press("Clean", "Clean", "Clean");
        browser.looks(width, height, false);
        look();
        browser.await("document.querySelector('#chain .st').textContent === 'SpotWait'");
        for (String id : List.of("chain", "facts", "acts")) {
            assertThat(browser.evaluate(
                            "document.getElementById('" + id + "').getBoundingClientRect().bottom <= " + height))
                    .as(id)
                    .isEqualTo("true");
        }
        assertThat(text("#now") + text("#do") + text(".models > header") + text("#caption-new"))
                .doesNotContainIgnoringCase("new model")
                .doesNotContainIgnoringCase("original");
    }

    @Test
    void theTimeLeftIsThatOfTheConvertersClock() {
        press("Clean", "Clean", "Clean");
        look();
        // By itself, the page counts on for at most 1.5 s.
        browser.await("/^(10:00|9:59)$/.test(document.querySelector('#chain .left').textContent)");
        assertThat(text("#chain .next")).isEqualTo("On");
        clock.advance(Duration.ofSeconds(108));
        browser.await("/^8:1[12]$/.test(document.querySelector('#chain .left').textContent)");
        assertThat(
                        browser.evaluate(
                                "Math.abs(0.18 - document.querySelector('#chain .track i').style.getPropertyValue('--part')) < 0.01"))
                .isEqualTo("true");
        String heard = text("#told-now");
        clock.advance(Duration.ofSeconds(483));
        browser.await("/^0:0[78 9]$/.test(document.querySelector('#chain .left').textContent)");
        assertThat(text("#told-now"))
                .as("a screen reader is not told the time each second")
                .isEqualTo(heard);
        clock.advance(Duration.ofSeconds(9));
        browser.await("document.querySelector('#chain').textContent === 'On'");
    }

    @Test
    void aButtonKeepsItsPlaceAndSaysWhatItDoesHere() {
        look();
        browser.await("document.querySelectorAll('.act').length === 2");
        String places = browser.evaluate(PLACES);
        press("Clean");
        browser.await("document.querySelector('.act[data-event=Spot] small').textContent === '→ Move'");
        assertThat(text(".act[data-event=Clean] small")).isEqualTo("→ Clean");
        assertThat(browser.evaluate("document.querySelector('.act[data-event=Clean]').title"))
                .isEqualTo("Sends Clean");
        assertThat(browser.evaluate(PLACES)).isEqualTo(places);
        press("Spot");
        browser.await("document.querySelector('.act[data-event=Spot] small').textContent === 'no effect in Move'");
        assertThat(
                        browser.evaluate(
                                "document.querySelector('.act[data-event=Spot]').ariaDisabled + ' ' + getComputedStyle(document.querySelector('.act[data-event=Spot]')).borderTopStyle"))
                .isEqualTo("true dashed");
        assertThat(browser.evaluate(PLACES)).isEqualTo(places);
        browser.evaluate("document.querySelector('.act[data-event=Spot]').click()");
        assertThat(text("#told")).isEqualTo("Spot: no effect in Move. Nothing was sent.");
        assertThat(shown.converter.history()).hasSize(2);
    }

    @Test
    void inDoubtNothingIsYellowAndNothingIsSent() {
        press("Clean");
        shown.answers.set(false);
        press("Clean");
        look();
        browser.await("document.querySelectorAll('#chain .st.doubt').length === 2");
        assertThat(text("#chain")).isEqualTo("OnorClean");
        assertThat(text("#says")).contains("no answer to Clean came");
        assertThat(browser.evaluate("document.querySelectorAll('.now.st, .chart .state.now').length"))
                .isEqualTo("0");
        assertThat(
                        browser.evaluate(
                                "[...document.querySelectorAll('#original .state.doubt')].map(s => s.dataset.state).sort().join()"))
                .isEqualTo("Clean,On");
        assertThat(browser.evaluate("[...document.querySelectorAll('.act')].every(b => b.ariaDisabled === 'true')"))
                .isEqualTo("true");
        int before = shown.converter.history().size();
        browser.evaluate("document.querySelector('.act').click()");
        assertThat(text("#told")).endsWith("Nothing was sent.");
        assertThat(shown.converter.history()).hasSize(before);
        assertThat(browser.evaluate(FAINT)).isEmpty();
    }

    @Test
    void aLostLinkIsSaidFirst() {
        shown.reached.set(false);
        look();
        browser.await("!document.getElementById('alarm').hidden");
        assertThat(text("#alarm b")).startsWith("No link to the robot since ");
        assertThat(text("#connection")).isEqualTo("no link");
        assertThat(text(".act small")).isEqualTo("waits: no link");
    }

    @Test
    void theEventsAreFilteredAndAClickLightsTheTransition() {
        press("Clean", "Spot", "Clean");
        look();
        browser.await("document.querySelectorAll('#log button').length === 3");
        browser.evaluate("[...document.querySelectorAll('#log button')].find(b => b.dataset.number === '2').click()");
        browser.await("document.querySelector('#new .transition.taken')?.dataset.target === 'Move'");
        assertThat(text("#moment")).isEqualTo("after event 2");
        assertThat(text("#log [aria-current=true]")).contains("Spot", "On → Move", "nothing sent");
        browser.evaluate(
                "const filter = document.getElementById('filter'); filter.value = 'no effect'; filter.dispatchEvent(new Event('input'))");
        assertThat(browser.evaluate("[...document.querySelectorAll('#log button')].map(b => b.dataset.number).join()"))
                .isEqualTo("3");
        browser.evaluate("filter.value = ''; document.querySelector('[data-who=failed]').click()");
        assertThat(text("#log")).isEqualTo("No such event.");
    }
}
