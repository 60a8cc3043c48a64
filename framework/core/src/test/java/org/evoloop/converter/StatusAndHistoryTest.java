package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Outcome;
import org.evoloop.function.Reading;
import org.evoloop.loop.Component.Role;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.ComponentStatus.Activity;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.QueueStatus;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class StatusAndHistoryTest {
    private final Robot robot = new Robot();

    @AfterEach
    void close() {
        robot.close();
    }

    private void assertLast(
            String occurrence, Configuration before, Configuration after, Outcome outcome, String detail) {
        HistoryEntry last = robot.last();
        assertThat(last.occurrence()).hasToString(occurrence);
        assertThat(last)
                .extracting(HistoryEntry::before, HistoryEntry::after, HistoryEntry::outcome, HistoryEntry::detail)
                .containsExactly(before, after, outcome, detail);
    }

    @Test
    void everyOutcomeIsInTheHistoryWithItsReason() throws InterruptedException {
        robot.pass(Duration.ofSeconds(3)).panel("Clean", true);
        assertLast(
                "Clean (panel, the device acted)",
                at("Off", "Off"),
                at("On", "On"),
                Outcome.HANDLED,
                "Clean (by the device)");
        assertThat(robot.last().number()).isEqualTo(1);
        assertThat(robot.last().at()).isEqualTo(Instant.EPOCH.plusSeconds(3));

        robot.controller("Clean");
        assertLast("Clean (controller)", at("On", "On"), at("Clean", "Clean"), Outcome.HANDLED, "Clean");
        robot.controller("Clean");
        assertLast(
                "Clean (controller)",
                at("Clean", "Clean"),
                at("Clean", "SpotWait"),
                Outcome.HANDLED,
                "new function of SpotWait");
        robot.pass(Duration.ofSeconds(5));
        assertLast("timeout (function)", at("Clean", "SpotWait"), at("On", "On"), Outcome.HANDLED, "Clean");
        robot.controller("arriveSpot");
        assertLast("arriveSpot (controller)", at("On", "On"), at("On", "On"), Outcome.IGNORED, "not acceptable in On");
        robot.controller("Spot").controller("Clean");
        assertLast("Clean (controller)", at("On", "Move"), at("On", "Move"), Outcome.IGNORED, "not acceptable in Move");
        robot.panel("Spot", true);
        assertLast(
                "Spot (panel, the device acted)",
                at("On", "Move"),
                at("Spot", "Move"),
                Outcome.IGNORED,
                "not acceptable in Move");
        robot.arrives();
        assertLast("arriveSpot (function)", at("Spot", "Move"), at("Spot", "Spot"), Outcome.HANDLED, "");
        robot.device("endSpot");
        assertLast(
                "endSpot (device, the device acted)",
                at("Spot", "Spot"),
                at("On", "On"),
                Outcome.HANDLED,
                "endSpot (by the device)");
        robot.brokenCable = new IOException();
        robot.soundSteps = 0;
        robot.controller("Clean");
        assertLast("Clean (controller)", at("On", "On"), at("On", "On"), Outcome.FAILED, "Device.execute: IOException");

        assertThat(robot.converter.history())
                .extracting(HistoryEntry::number)
                .containsExactly(1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L, 9L, 10L, 11L);
        assertThat(robot.converter.status().events())
                .isEqualTo(new ConverterStatus.EventCounts(11, 7, 3, 0, 1, 0, 0, 0, 0));
    }

    @Test
    void anEventThatHasBecomeImpossibleFailsAndTheStatesTimerRunsAnew() throws InterruptedException {
        robot.controller("Clean").controller("Clean").panel("Clean", true).panel("Spot", true);
        assertLast(
                "Spot (panel, the device acted)",
                at("On", "SpotWait"),
                at("Spot", "SpotWait"),
                Outcome.IGNORED,
                "not acceptable in SpotWait");
        robot.pass(Duration.ofSeconds(5));
        assertLast(
                "timeout (function)",
                at("Spot", "SpotWait"),
                at("Spot", "SpotWait"),
                Outcome.FAILED,
                "event timeout leads to On, but with the device in Spot no events that can be sent take it there (sendable: Clean, Spot)");
        robot.device("endSpot").pass(Duration.ofMillis(4999));
        assertThat(robot.states()).isEqualTo(at("On", "SpotWait"));
        robot.pass(Duration.ofMillis(1));
        assertThat(robot.states()).isEqualTo(at("On", "On"));
    }

    @Test
    void theLastTwoHundredEventsAreRemembered() throws InterruptedException {
        for (int i = 0; i < 250; i++) {
            robot.controller("Clean");
            robot.pass(Duration.ofMillis(1));
        }
        List<HistoryEntry> history = robot.converter.history();
        assertThat(history).hasSize(200);
        assertThat(history.get(0).number()).isEqualTo(51);
        assertThat(history.get(199).number()).isEqualTo(250);
    }

    @Test
    void theStatusIsConsistent() throws InterruptedException {
        robot.controller("Clean").controller("Spot");
        robot.panel.press("Clean");
        robot.converter.observe(robot.panel);

        ConverterStatus status = robot.converter.status();

        assertThat(status.name()).isEqualTo("robot");
        assertThat(status.loop()).isEqualTo(LoopState.RUNNING);
        assertThat(status.states()).isEqualTo(at("On", "Move"));
        assertThat(status.queue()).isEqualTo(new QueueStatus(1, 8, 1, 3, 0, 0));
        assertThat(status.events()).isEqualTo(new ConverterStatus.EventCounts(3, 2, 0, 0, 0, 0, 0, 1, 0));
        assertThat(status.conversionTime()).isEqualTo(new ConverterStatus.ConversionTime(2, 0, 0, 0));
        assertThat(status.function()).isEqualTo(new ConverterStatus.RunningFunction("Move", "", "", List.of()));
        assertThat(status.link()).isNull();
        assertThat(status.components())
                .containsExactly(
                        new ComponentStatus("Panel", Role.MONITOR, "", Activity.ENDED, 0, ""),
                        new ComponentStatus("EventAnalyze", Role.ANALYZE, "", Activity.ENDED, 0, ""),
                        new ComponentStatus("EventPlan", Role.PLAN, "", Activity.ENDED, 0, ""),
                        new ComponentStatus("Device", Role.EXECUTE, "", Activity.ENDED, 0, ""));
    }

    @Test
    void theStatusReportsTheLink() {
        robot.converter.addLink(new DeviceLink() {
            @Override
            public boolean isUp() {
                return true;
            }

            @Override
            public String describe() {
                return "a cable, in good shape";
            }
        });
        assertThat(robot.converter.status().link())
                .isEqualTo(new ConverterStatus.LinkStatus(true, "a cable, in good shape", List.of()));
    }

    @Test
    void readingsOfADeviceThatIsGoneAreNotShown() {
        List<Reading> readings = List.of(Reading.of("battery", 93, "%"));

        assertThat(new ConverterStatus.LinkStatus(true, "a cable", readings).readings())
                .isEqualTo(readings);
        assertThat(new ConverterStatus.LinkStatus(false, "it is pulled", readings).readings())
                .isEmpty();
    }

    @Test
    void whileTheLoopIsClosedOrTheLinkIsDownTheStatesAreTheLastKnown() {
        Optional<Instant> closed = Optional.of(robot.clock.wallTime());
        robot.clock.advance(Duration.ofSeconds(5));
        robot.converter.stop();
        Optional<Instant> stopped = Optional.of(robot.clock.wallTime());
        robot.clock.advance(Duration.ofSeconds(5));
        assertThat(robot.converter.status().lastKnownSince()).isEqualTo(stopped).isNotEqualTo(closed);
        robot.converter.start();
        assertThat(robot.converter.status().lastKnownSince()).isEmpty();

        robot.converter.addLink(new DeviceLink() {
            @Override
            public boolean isUp() {
                return false;
            }

            @Override
            public Optional<Instant> downSince() {
                return stopped;
            }

            @Override
            public String describe() {
                return "a cable, torn";
            }
        });
        assertThat(robot.converter.status().lastKnownSince()).isEqualTo(stopped);
        robot.converter.stop();
        assertThat(robot.converter.status().lastKnownSince())
                .as("the earlier of the two")
                .isEqualTo(stopped);
    }
}
