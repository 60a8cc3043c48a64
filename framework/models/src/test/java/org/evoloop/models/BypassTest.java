package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What the controller's events do to the cleaning robot while its converter is down. */
class BypassTest {
    private static Tool bypass(String... options) {
        String models = Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml")
                .toString();
        List<String> arguments = new ArrayList<>(List.of("plan", models + "#original", models + "#new", "--bypass"));
        arguments.addAll(List.of("--spontaneous", "endSpot"));
        arguments.addAll(List.of(options));
        return Tool.run(arguments.toArray(String[]::new));
    }

    @Test
    void eachEventIsExplainedInEachPairOfStates() {
        Tool text = bypass();
        assertThat(text.err()).isEmpty();
        assertThat(text.status()).isZero();
        assertThat(text.out().lines())
                .contains(
                        "(Off, Off)  Clean:  the same: the device goes to On",
                        "(On, On)  Spot:  something else: the device goes to Spot; the converter would send nothing and be"
                                + " in (On, Move); found again as (Spot, Spot)",
                        "(On, Move)  Spot:  something else: the device goes to Spot; the converter would ignore it; found"
                                + " again as (Spot, Spot)",
                        "(On, Move)  arriveSpot:  unknown to the device, which stays in On; the converter would send Spot"
                                + " and be in (Spot, Spot); found again as (On, Move)",
                        "(Clean, SpotWait)  Clean:  something else: the device goes to On; the converter would send Clean,"
                                + " Spot and be in (Spot, Spot); found again as (On, On)",
                        "(Clean, SpotWait)  the function of SpotWait does not run: the device stays in Clean")
                .noneMatch(line -> line.contains("endSpot"))
                .endsWith("9 events in pairs of states: 2 the same, 5 something else, 0 ignored, 2 unknown");
    }

    @Test
    void whatOnlyTheDeviceItselfDoesIsNotPassedOn() {
        assertThat(bypass("--sendable", "Clean", "--spontaneous", "Spot").out())
                .contains("  Clean:")
                .doesNotContain("  Spot:");
    }

    @Test
    void whatTheDeviceKnowsElsewhereIsIgnored() {
        String roomba = Path.of(System.getProperty("evoloop.root"), "models", "roomba.xml")
                .toString();
        assertThat(Tool.run("plan", roomba + "#original", roomba + "#home", "--bypass")
                        .out())
                .contains(
                        "(Off, QuietHours)  Spot:  ignored by the device in Off; the converter would send nothing and be"
                                + " in (Off, Move); found again as (Off, QuietHours)\n")
                .contains("(Charged, SpotWait)  the function of SpotWait does not run, no timer runs for tm(5s): the"
                        + " device stays in Charged until charging or undocked or asleep\n");
    }

    @Test
    void programsReadIt() {
        JsonNode json = new JsonMapper().readTree(bypass("--format", "json").out());
        assertThat(json.path("bypass")).hasSize(9);
        JsonNode spot = json.path("bypass").get(1);
        assertThat(spot.path("event").asString()).isEqualTo("Spot");
        assertThat(spot.path("kind").asString()).isEqualTo("other");
        assertThat(spot.path("deviceState").asString()).isEqualTo("Spot");
        assertThat(spot.path("converter").path("newState").asString()).isEqualTo("Move");
        assertThat(spot.path("converter").path("events")).isEmpty();
        assertThat(spot.path("found").path("newState").asString()).isEqualTo("Spot");
        JsonNode stopped = json.path("stopped").get(0);
        assertThat(stopped.path("newState").asString()).isEqualTo("Move");
        assertThat(stopped.path("function").asBoolean()).isTrue();
    }
}
