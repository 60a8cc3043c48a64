package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;

/**
 * Measures the time from when something happens until the new state is lit in Chromium, with five viewers, and prints
 * it. What is a good time depends on the machine, so the only limit is that every state is lit.
 */
@EnabledIf("org.evoloop.page.Browser#isThere")
@Tag("slow")
class LitTimeTest {
    private static final int VIEWERS = 5;
    private static final int EVENTS = 1_000;

    private static final String OBSERVER = """
            window.lit = [];
            new MutationObserver(() => {
              const state = document.querySelector('#new .state.now')?.dataset.state;
              if (state === window.lit.at(-1)?.state) return;
              window.lit.push({ state, at: performance.timeOrigin + performance.now() });
              window.heard?.();
            }).observe(document.getElementById('new'), { subtree: true, attributes: true });
            """;

    /** The time of the change of a number, in milliseconds since 1970, when it has happened. */
    private static final String AT = """
            new Promise(resolve => {
              window.heard = () => { if (window.lit.length > %1$d) resolve(String(window.lit[%1$d].at)); };
              window.heard();
            })""";

    @Test
    void fiveViewersSeeAnEventSoon() throws Exception {
        try (Shown shown = new Shown();
                Browser browser = new Browser()) {
            shown.converter.start();
            shown.panel.press("Clean");
            for (int other = 1; other < VIEWERS; other++) {
                browser.call("Target.createTarget", Map.of("url", shown.address() + "/", "background", true));
            }
            browser.open(shown.address() + "/");
            browser.await("document.querySelector('#new .state.now').dataset.state === 'On'");
            browser.evaluate(OBSERVER);

            double[] millis = new double[EVENTS];
            for (int event = 0; event < EVENTS; event++) {
                double happened = ChronoUnit.MICROS.between(Instant.EPOCH, Instant.now()) / 1e3;
                // On, Clean, SpotWait, Spot, and from there on again.
                if (event % 4 == 3) {
                    shown.panel.acts("endSpot");
                } else {
                    shown.panel.press("Clean");
                }
                millis[event] = Double.parseDouble(browser.evaluate(AT.formatted(event))) - happened;
            }
            Arrays.sort(millis);
            System.out.printf(
                    Locale.ROOT,
                    "%d events, %d viewers in Chromium, until the state is lit: median %.1f ms, 99th percentile %.1f ms,"
                            + " longest %.1f ms%n",
                    EVENTS,
                    VIEWERS,
                    millis[EVENTS / 2],
                    millis[EVENTS * 99 / 100],
                    millis[EVENTS - 1]);
            assertThat(browser.complaints).noneMatch(complaint -> !complaint.contains("/controls"));
        }
    }
}
