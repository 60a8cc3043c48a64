package org.evoloop.payload.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class AftermathTest {
    private static final Duration LIMIT = Duration.ofSeconds(2);

    private final ManualClock clock = new ManualClock();
    private final List<String> told = new ArrayList<>();
    private final Consumer<String> monitor = told::add;
    private final Aftermath aftermath = new Aftermath(new Turns());

    @AfterEach
    void close() {
        clock.close();
    }

    private void reports(String state) {
        aftermath.receives(new Report(state, false));
        aftermath.hear(state, monitor);
    }

    private void retained(String state) {
        aftermath.receives(new Report(state, true));
        aftermath.hear(state, monitor);
    }

    private void isLost() {
        aftermath.sends("off", "on");
        aftermath.isUnknown("on", clock, LIMIT);
    }

    @Test
    void whereNothingIsUnknownEveryReportCounts() {
        retained("on");
        reports("off");
        aftermath.sends("off", "on");
        reports("broken");
        reports("on");
        aftermath.settled();
        reports("off");
        assertThat(told).containsExactly("on", "off", "broken", "on", "off");
    }

    @Test
    void whatWasReportedBeforeTheDeviceWasLostSettlesNothing() {
        isLost();
        reports("off");
        aftermath.isLost();
        clock.advance(LIMIT);
        assertThat(told).isEmpty();
        reports("on");
        assertThat(told).containsExactly("on");
    }

    @Test
    void onlyWhatConfirmsTheCommandCountsAtOnce() {
        isLost();
        reports("off");
        reports("broken");
        assertThat(told).isEmpty();
        reports("on");
        reports("off");
        clock.advance(LIMIT);
        assertThat(told).containsExactly("on", "off");
    }

    @Test
    void theNewestReportCountsWhenTheCommandCanHaveNoEffectAnyMore() {
        isLost();
        reports("broken");
        reports("off");
        clock.advance(LIMIT.minusMillis(1));
        assertThat(told).isEmpty();
        clock.advance(Duration.ofMillis(1));
        assertThat(told).containsExactly("off");
    }

    @Test
    void aReportFromBeforeTheLimitOfTheStepIsNoneOfTheTimeAfterIt() {
        aftermath.sends("off", "on");
        reports("off");
        aftermath.isUnknown("on", clock, LIMIT);
        assertThat(told).isEmpty();
        reports("on");
        clock.advance(LIMIT);
        assertThat(told).containsExactly("on");
    }

    @Test
    void withoutAReportTheNextOneCounts() {
        isLost();
        clock.advance(LIMIT);
        reports("off");
        assertThat(told).containsExactly("off");
    }

    @Test
    void whatTheBrokerHasRetainedSettlesNothingUnlessItConfirms() {
        isLost();
        retained("off");
        clock.advance(LIMIT);
        retained("off");
        assertThat(told).isEmpty();
        retained("on");
        assertThat(told).containsExactly("on");
    }

    @Test
    void anEventThatLeadsBackToItsStateIsConfirmedByIt() {
        aftermath.sends("off", "off");
        reports("off");
        assertThat(told).containsExactly("off");
    }

    @Test
    void theNextCommandForgetsTheLast() {
        isLost();
        reports("broken");
        aftermath.sends("broken", "off");
        clock.advance(LIMIT);
        assertThat(told).isEmpty();
        reports("off");
        assertThat(told).containsExactly("off");
    }
}
