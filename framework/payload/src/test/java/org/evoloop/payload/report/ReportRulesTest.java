package org.evoloop.payload.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.evoloop.payload.Match;
import org.evoloop.payload.Meanings;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Which messages mean something, and when. */
class ReportRulesTest {
    private static final String POWER = "plug/power";
    private static final Duration SECOND = Duration.ofSeconds(1);
    private static final Meanings LOW = Meanings.NONE.with(Match.between(0, 3), "Off");
    private static final Meanings HIGH = Meanings.NONE.with(Match.between(100, 3000), "Heating");

    private final ManualClock clock = new ManualClock();
    private final Map<String, Consumer<Report>> subscribed = new HashMap<>();
    private final List<String> heard = new ArrayList<>();
    private final Turns turns = new Turns();
    private final ReportRules rules = new ReportRules(clock, turns, subscribed::put);

    @AfterEach
    void close() {
        clock.close();
    }

    private void add(Meanings meanings, ReportRules.Use use) {
        rules.add(POWER, meanings, use, meaning -> heard.add(meaning.name()));
    }

    private void says(String payload) {
        subscribed.get(POWER).accept(new Report(payload, false));
    }

    @Test
    void allRulesOfATopicAreHeardInTheirOrder() {
        add(LOW, ReportRules.Use.NEWS);
        add(HIGH, ReportRules.Use.NEWS);
        add(Meanings.NONE.with(Match.between(0, 1000), "Any"), ReportRules.Use.NEWS);
        says("1");
        says("200");
        says("50");
        subscribed.get(POWER).accept(new Report("1", true));
        assertThat(heard).containsExactly("Off", "Heating", "Any");
    }

    @Test
    void whatAReportEndsIsNotReportedByATimerThatIsDueMeanwhile() {
        add(LOW.lasting(SECOND), ReportRules.Use.STATE);
        add(HIGH, ReportRules.Use.STATE);
        says("1");
        turns.take(() -> {
            clock.advance(SECOND);
            says("200");
        });
        assertThat(heard).containsExactly("Heating");
    }

    @Test
    void aStateThatMustBeSteadyIsReportedOnceItHasLasted() {
        add(LOW.lasting(SECOND.multipliedBy(2)), ReportRules.Use.STATE);
        add(HIGH, ReportRules.Use.STATE);
        says("1");
        clock.advance(SECOND);
        says("200");
        assertThat(heard).containsExactly("Heating");
        clock.advance(SECOND.multipliedBy(5));
        says("1");
        clock.advance(SECOND);
        says("2");
        assertThat(heard).containsExactly("Heating");
        clock.advance(SECOND);
        assertThat(heard).containsExactly("Heating", "Off");
        says("0");
        assertThat(heard).containsExactly("Heating", "Off", "Off");
    }

    @Test
    void whatAnotherTopicSaysOfTheStateEndsWhatHasNotLastedYet() {
        add(LOW.lasting(SECOND.multipliedBy(2)), ReportRules.Use.STATE);
        rules.add(
                "plug/relay",
                Meanings.of(Map.of("off", "Unplugged", "low", "Off")),
                ReportRules.Use.STATE,
                meaning -> heard.add(meaning.name()));
        says("1");
        clock.advance(SECOND);
        subscribed.get("plug/relay").accept(new Report("low", false));
        clock.advance(SECOND);
        assertThat(heard).containsExactly("Off", "Off");

        says("200");
        says("1");
        clock.advance(SECOND);
        subscribed.get("plug/relay").accept(new Report("off", false));
        clock.advance(SECOND.multipliedBy(5));
        assertThat(heard).containsExactly("Off", "Off", "Unplugged");
    }

    @Test
    void anEventThatMustBeSteadyOccursOnceAndNotIfItHasLastedFromTheBeginning() {
        add(LOW.lasting(SECOND), ReportRules.Use.EVENT);
        says("1");
        clock.advance(SECOND);
        says("1");
        assertThat(heard).isEmpty();
        says("200");
        says("1");
        clock.advance(SECOND);
        clock.advance(SECOND);
        says("2");
        assertThat(heard).containsExactly("Off");
        says("50");
        says("2");
        clock.advance(SECOND);
        assertThat(heard).containsExactly("Off", "Off");
    }

    @Test
    void withoutAClockNothingCanLast() {
        assertThatThrownBy(() -> new ReportRules(null, turns, subscribed::put)
                        .add(POWER, LOW.lasting(SECOND), ReportRules.Use.STATE, state -> {}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("plug/power");
    }
}
