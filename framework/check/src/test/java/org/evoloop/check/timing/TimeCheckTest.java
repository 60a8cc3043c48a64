package org.evoloop.check.timing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.check.Lamp.lamp;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;
import org.evoloop.check.TimedEvent;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Time properties that are decided before anything runs. */
class TimeCheckTest {
    /** A lamp that switches itself off 5 s after it was dimmed, with a new model that dims it. */
    private static final ModelPair LAMP = new ModelPair(
            lamp("original").build(),
            lamp("new")
                    .transition("On", "dim", "Dim")
                    .transition("Dim", "after 5 s", "Off")
                    .transition("Dim", "press", "On")
                    .build());

    private static TimeReport check(ModelPair pair, String... lines) {
        TimeRules rules =
                PropertyFile.parse("lamp.txt", String.join("\n", lines), pair).time();
        return TimeCheck.run(CheckInput.of(pair), rules, "lamp.txt");
    }

    @Test
    void whereTheDeviceIsDependsOnWhatFunctionsSend() {
        CheckInput sending = CheckInput.of(LAMP).withSends("Dim", "press");
        PropertyFile file = PropertyFile.parse("lamp.txt", "Lit: after Dim, device Off within 1 s", LAMP);
        assertThat(TimeCheck.run(sending, file.time(), "lamp.txt").findings())
                .extracting(Finding::message)
                .containsExactly(
                        "'Lit' (lamp.txt, line 1) is unknown, since the function of Dim may send events to the "
                                + "device; if nothing is sent, it does not hold");
        assertThat(check(LAMP, "Lit: after Dim, device Off within 1 s").findings())
                .as("nobody declares anything, so nothing is sent")
                .extracting(Finding::rule)
                .contains(Rule.PROPERTY);
    }

    @Test
    void whatIsUrgentIsComparedWithWhatItWouldBeOtherwise() {
        ModelPair lift = new ModelPair(
                StateMachine.named("lift")
                        .initial("F")
                        .transition("F", "up", "G")
                        .transition("G", "up", "H")
                        .build(),
                StateMachine.named("express")
                        .initial("F")
                        .transition("F", "up", "G")
                        .transition("G", "up", "H")
                        .transition("F", "express", "H")
                        .transition("F", "fire", "Alarm")
                        .transition("G", "fire", "Alarm")
                        .transition("H", "fire", "Alarm")
                        .urgent("fire")
                        .build());
        TimeReport report = check(
                lift,
                "takes up 2 s",
                "queue 3",
                "at least 1 s between fire",
                "Alarmed: after event fire, Alarm within 9 s");

        assertThat(report.verdicts())
                .singleElement()
                .hasToString("'Alarmed' holds: 0 s at best, 2 s at worst; without a bound if nothing were urgent");
    }

    static Stream<Arguments> verdicts() {
        String slow = "takes press 1 s .. 2 s";
        String later = "dim comes 1 s .. 2 s after state On";
        return Stream.of(
                Arguments.of("Dim never longer than 5 s", "queue 1", true, "0 s at best, 5 s at worst"),
                Arguments.of("Dim never longer than 4999 ms", "queue 1", false, "0 s at best, 5 s at worst"),
                Arguments.of("Dim never longer than 7 s", slow, true, "0 s at best, 7 s at worst"),
                Arguments.of("Dim never longer than 6 s", slow, false, "0 s at best, 7 s at worst"),
                Arguments.of("after Dim, On or Off within 5 s", "queue 1", true, "0 s at best, 5 s at worst"),
                Arguments.of("after Dim, Off within 5 s", "queue 1", false, "0 s at best, without a bound at worst"),
                Arguments.of("after event press, true within 1 s", "queue 1", true, "0 s at best, 0 s at worst"),
                Arguments.of("On only after 2 s of Off", "queue 1", false, "after 0 s at worst"),
                Arguments.of("Dim only after 2 s of On", later, false, "after 1 s at worst"),
                Arguments.of("Dim only after 1 s of On", later, true, "after 1 s at worst"),
                Arguments.of("On never shorter than 1 s", "queue 1", false, "0 s at worst"),
                Arguments.of(
                        "event press at most 2 times in 1 s", "at least 500 ms between presses", false, "3 at worst"),
                Arguments.of(
                        "event press at most 3 times in 1 s", "at least 500 ms between presses", true, "3 at worst"),
                Arguments.of(
                        "event dim at most 1 times in 3 s",
                        "dim comes 1 s .. 2 s after state On",
                        false,
                        "2 at worst"));
    }

    @ParameterizedTest
    @MethodSource("verdicts")
    void everythingThatCanHappenCounts(String property, String known, boolean holds, String figures) {
        TimeReport report =
                check(LAMP, "queue 1".equals(known) ? "at least 1 s between dim" : "queue 1", known, property);

        assertThat(report.verdicts()).singleElement().satisfies(verdict -> {
            assertThat(verdict.holds()).isEqualTo(holds);
            assertThat(verdict.toString()).endsWith(figures);
        });
        assertThat(report.findings())
                .filteredOn(finding -> finding.rule() == Rule.PROPERTY)
                .hasSize(holds ? 0 : 1);
    }

    @Test
    void theShortestPathIsReportedWithTimes() {
        TimeReport report = check(LAMP, "takes press 1 s .. 2 s", "queue 1", "Dim never longer than 6 s");

        assertThat(report.findings().get(0).timed())
                .extracting(TimedEvent::what)
                .containsExactly(
                        "start", "press", "obeyed", "dim", "after 5 s", "'Dim never longer than 6 s' is violated");
        assertThat(report.findings().get(0).timed())
                .extracting(TimedEvent::atNanos)
                .containsExactly(0L, 0L, 1_000_000_000L, 1_000_000_000L, 6_000_000_000L, 7_000_000_000L);
        assertThat(report.findings().get(0).timed().get(4).step()).isEqualTo("press");
    }

    @Test
    void whatFollowsFromAViolationHappens() {
        ModelPair alarmed = new ModelPair(
                lamp("original").build(),
                lamp("new")
                        .transition("On", "dim", "Dim")
                        .transition("Dim", "alarm", "Off")
                        .build());
        String[] lines = {
            "a: Dim never longer than 3 s", "on violation of a raise alarm", "b: Dim never longer than 3001 ms"
        };

        assertThat(check(alarmed, lines).verdicts())
                .extracting(TimeVerdict::holds)
                .containsExactly(false, true);
    }

    private static List<Finding> hazards(ModelPair pair, String... lines) {
        return check(pair, lines).findings();
    }

    @Test
    void timersThatAreDueInOneInstantAreNamed() {
        ModelPair racing = new ModelPair(
                lamp("original").build(),
                lamp("new")
                        .transition("On", "after 5 s", "Off")
                        .transition("On", "after 5000 ms", "Off")
                        .build());
        assertThat(hazards(racing)).singleElement().satisfies(finding -> {
            assertThat(finding.rule()).isEqualTo(Rule.TIMER_RACE);
            assertThat(finding.message())
                    .startsWith("after 5 s and after 5000 ms can be due in the same instant in On");
        });
        assertThat(hazards(LAMP)).isEmpty();
    }

    @Test
    void timeThatComesToAHaltIsNamed() {
        ModelPair halting = new ModelPair(
                lamp("original").build(),
                lamp("new")
                        .transition("On", "dim", "A")
                        .transition("A", "after 0 s", "B")
                        .transition("B", "after 0 ms", "A")
                        .build());
        assertThat(hazards(halting)).extracting(Finding::rule).containsExactly(Rule.TIME_DEADLOCK);
        assertThat(hazards(LAMP, "dim comes 1 s .. 2 s after state On", "at least 3 s between dim"))
                .extracting(Finding::rule)
                .containsExactly(Rule.TIME_DEADLOCK);
    }

    @Test
    void aStepThatIsOnItsWayWhenItsVisitEndsIsNamed() {
        State on = new State("On");
        Transition inside = new Transition(on, new Event("blink"), on, List.of(), true);
        ModelPair blinking = new ModelPair(
                lamp("original").transition("On", "blink", "On").build(),
                lamp("new")
                        .transition("On", "after 5 s", "Off")
                        .transition(inside, "")
                        .build());

        assertThat(hazards(blinking, "takes blink 1 s .. 2 s", "queue 0", "at least 1 s between presses"))
                .singleElement()
                .satisfies(finding -> {
                    assertThat(finding.rule()).isEqualTo(Rule.STEP_OUTLIVES_VISIT);
                    assertThat(finding.message())
                            .startsWith("blink can still be on its way to the device when after 5 s is due in On");
                });
    }

    @Test
    void aModelThatIsTooLargeIsRefusedWithTheFigure() {
        assertThat(check(LAMP, "takes press 1 ms .. 1 h", "Dim never longer than 1 h")
                        .undecided())
                .singleElement(InstanceOfAssertFactories.STRING)
                .startsWith("lamp.txt, line 2: 'Dim never longer than 1 h' cannot be decided: there are more than ")
                .contains("ticks of 1 ms", "write lengths of time");
    }

    @Test
    void whatTheDeviceDoesByItselfHappensToo() {
        ModelPair robot = new ModelPair(
                StateMachine.named("original")
                        .initial("On")
                        .transition("On", "Spot", "Spot")
                        .transition("Spot", "endSpot", "On")
                        .build(),
                StateMachine.named("new")
                        .initial("On")
                        .transition("On", "Spot", "Spot")
                        .transition("Spot", "endSpot", "On")
                        .build());
        TimeRules rules = PropertyFile.parse(
                        "r.txt", "endSpot comes 30 s .. 60 s after device Spot\nSpot never longer than 60 s", robot)
                .time();
        TimeReport report = TimeCheck.run(CheckInput.of(robot).withOwnEvents(Set.of("endSpot")), rules, "r.txt");
        assertThat(report.verdicts())
                .singleElement()
                .hasToString("'Spot never longer than 60 s' holds: 30 s at best, 1 min at worst");
    }
}
