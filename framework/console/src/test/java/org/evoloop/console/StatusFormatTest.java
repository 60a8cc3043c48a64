package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.Drift;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.function.Reading;
import org.evoloop.loop.Component;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.QueueStatus;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** The status of a busy converter that has everything. */
class StatusFormatTest {
    private static final ConverterStatus BUSY = new ConverterStatus(
            "robot",
            LoopState.RUNNING,
            new Configuration(new State("On"), new State("Move")),
            "Move, the device in On",
            "",
            "",
            "",
            Drift.NONE,
            Optional.empty(),
            new QueueStatus(2, 8, 5, 40, 1, 3),
            new ConverterStatus.EventCounts(44, 30, 4, 2, 1, 1, 3, 2, 1),
            new ConverterStatus.ConversionTime(33, 180_499, 999_499, 12_340_000),
            List.of(
                    new ComponentStatus(
                            "Panel",
                            Component.Role.MONITOR,
                            "mapek-robot-monitor-Panel",
                            ComponentStatus.Activity.WAITING,
                            0,
                            ""),
                    new ComponentStatus(
                            "Motors",
                            Component.Role.EXECUTE,
                            "mapek-robot-execute-Motors",
                            ComponentStatus.Activity.STUCK,
                            2,
                            "Motors.execute: \"no\\answer\"\t\u00e9")),
            new ConverterStatus.RunningFunction(
                    "Move", "function-Move-7", "driving there", List.of(Reading.of("distance", 1.204, "m"))),
            List.of(
                    timer("tm(90s)", Duration.ofMillis(61_400)),
                    timer("tm(5min)", Duration.ofSeconds(270)),
                    timer("timeout", Duration.ofHours(3).plusMinutes(7))),
            List.of(new ConverterStatus.Fault("guard [full]", 1, "guard.full: no scales")),
            new ConverterStatus.LinkStatus(
                    true,
                    "/dev/ttyUSB0",
                    List.of(
                            Reading.of("battery", 93, "%"),
                            Reading.of("docked", false),
                            Reading.of("chargingSource", "home \"base\""))));

    private static ConverterStatus.RunningTimer timer(String event, Duration remaining) {
        return new ConverterStatus.RunningTimer(
                event, remaining, Instant.parse("2026-11-22T15:00:00Z").plus(remaining));
    }

    @Test
    void asTextInBrief() {
        Captured out = new Captured();

        StatusText.brief(BUSY, out.stream);

        assertThat(out.lines())
                .containsExactly(
                        "converter   robot, running",
                        "states      original On, new Move, the device in On",
                        "now         Move: driving there, distance 1.2 m",
                        "timers      tm(90s) in 61 s, tm(5min) in 4 min 30 s, timeout in 3 h 7 min",
                        "device      battery 93 %, charging source home \"base\"; not docked",
                        "link        up, /dev/ttyUSB0",
                        "trouble     Motors is stuck; guard.full: no scales; 1 event failed; 1 event dropped; "
                                + "see status --all and history");
    }

    @Test
    void asTextWithAllThatIsBehindIt() {
        Captured out = new Captured();

        StatusText.all(BUSY, out.stream);

        assertThat(out.lines())
                .startsWith("converter   robot, running", "states      original On, new Move, the device in On")
                .containsSubsequence(
                        "function    thread function-Move-7",
                        "queue       2 waiting, highest 5, room for 8 presses; 1 dropped, 3 refused",
                        "events      30 handled, 4 ignored, 2 stale, 1 failed, 1 in progress, of 44 observed",
                        "conversion  last 180 us, median 999 us, 99th percentile 12.3 ms",
                        "monitor     Panel   waiting  mapek-robot-monitor-Panel")
                .anyMatch(line -> line.startsWith("execute     Motors  stuck    mapek-robot-execute-Motors"
                        + "  2 failures, the last: Motors.execute: \"no\\answer\""))
                .endsWith("fault       guard [full]  1 failure: guard.full: no scales");
    }

    @Test
    void asJson() {
        assertThat(StatusJson.of(BUSY).toString())
                .startsWith(
                        "{\"name\":\"robot\",\"loop\":\"running\",\"originalState\":\"On\",\"newState\":\"Move\",\"system\":\"Move, the device in On\",\"evolution\":\"\",\"shadow\":\"\",\"doubt\":\"\",\"drift\":{\"acts\":0,\"unexplained\":0,\"text\":\"\",\"edges\":[]},\"lastKnownSince\":null,"
                                + "\"queue\":{\"depth\":2,\"capacity\":8,\"highest\":5,"
                                + "\"taken\":40,\"dropped\":1,\"refused\":3},"
                                + "\"events\":{\"observed\":44,\"handled\":30,\"ignored\":4,\"stale\":2,\"failed\":1,"
                                + "\"dropped\":1,\"refused\":3,\"waiting\":2,\"inProgress\":1},"
                                + "\"conversionTime\":{\"events\":33,\"lastNanos\":180499,\"medianNanos\":999499,"
                                + "\"percentile99Nanos\":12340000},\"components\":[")
                .contains("\"activity\":\"stuck\",\"failures\":2,"
                        + "\"lastFailure\":\"Motors.execute: \\\"no\\\\answer\\\"\\t\\u00E9\"}]")
                .endsWith("\"function\":{\"state\":\"Move\",\"thread\":\"function-Move-7\","
                        + "\"progress\":\"driving there\",\"readings\":{\"distance\":1.204}},"
                        + "\"timers\":[{\"event\":\"tm(90s)\",\"remainingMillis\":61400,\"due\":\"2026-11-22T15:01:01.400Z\"},"
                        + "{\"event\":\"tm(5min)\",\"remainingMillis\":270000,\"due\":\"2026-11-22T15:04:30Z\"},"
                        + "{\"event\":\"timeout\",\"remainingMillis\":11220000,\"due\":\"2026-11-22T18:07:00Z\"}],"
                        + "\"faults\":[{\"part\":\"guard [full]\",\"failures\":1,"
                        + "\"lastFailure\":\"guard.full: no scales\"}],"
                        + "\"link\":{\"up\":true,\"text\":\"/dev/ttyUSB0\","
                        + "\"readings\":{\"battery\":93,\"docked\":false,\"chargingSource\":\"home \\\"base\\\"\"}}}");
    }

    @Test
    void statesThatAreNotKeptUpToDateSaySo() {
        Captured out = new Captured();
        Instant since = Instant.parse("2026-11-22T15:04:05.123Z");
        ConverterStatus stopped = new ConverterStatus(
                BUSY.name(),
                LoopState.STOPPED,
                BUSY.states(),
                BUSY.system(),
                "",
                "",
                "",
                Drift.NONE,
                Optional.of(since),
                BUSY.queue(),
                BUSY.events(),
                BUSY.conversionTime(),
                BUSY.components(),
                BUSY.function(),
                BUSY.timers(),
                BUSY.faults(),
                BUSY.link());

        StatusText.brief(stopped, out.stream);

        assertThat(out.lines().get(1))
                .matches(
                        "states {6}original On, new Move, the device in On; last known, since 2026-11-2\\d \\d\\d:\\d\\d:05");
        assertThat(StatusJson.of(stopped).toString()).contains("\"lastKnownSince\":\"2026-11-22T15:04:05.123Z\"");
    }

    private static ConverterStatus running(
            ConverterStatus.RunningFunction function, ConverterStatus.@Nullable LinkStatus link) {
        return new ConverterStatus(
                BUSY.name(),
                LoopState.RUNNING,
                BUSY.states(),
                BUSY.system(),
                "",
                "",
                "",
                Drift.NONE,
                Optional.empty(),
                BUSY.queue(),
                BUSY.events(),
                BUSY.conversionTime(),
                List.of(),
                function,
                List.of(),
                List.of(),
                link);
    }

    @Test
    void whatAFunctionSaysStaysInItsLine() {
        Captured out = new Captured();
        ConverterStatus odd = running(
                new ConverterStatus.RunningFunction("Move", "", "half\nstates      forged\u2028\u001b[2J", List.of()),
                null);
        Configuration at = BUSY.states();
        Occurrence event = new Occurrence.Heard(new Event("Spot"), Values.of("note", "a\nb"), Source.CONTROLLER, 0, 0);

        StatusText.brief(odd, out.stream);
        StatusText.history(
                List.of(new HistoryEntry(
                        1, Instant.EPOCH, event, at, at, Outcome.FAILED, "500\r\nno", null, Duration.ZERO)),
                out.stream);

        assertThat(out.lines())
                .contains("now         Move: half?states      forged??[2J")
                .last()
                .asString()
                .endsWith("  Spot (controller, note=a?b)  in (On, Move)  failed: 500??no");
    }

    @Test
    void readingsOfADeviceThatIsGoneAreNotShown() {
        Captured out = new Captured();
        ConverterStatus gone = running(
                ConverterStatus.RunningFunction.NONE,
                new ConverterStatus.LinkStatus(false, "no cable", BUSY.link().readings()));

        StatusText.brief(gone, out.stream);

        assertThat(out.lines())
                .contains("now         waiting for the device", "device      unknown", "link        down, no cable");
        assertThat(out.text()).doesNotContain("battery");
    }

    @Test
    void durationsHaveTheUnitThatFits() {
        assertThat(StatusText.duration(0)).isEqualTo("0 us");
        assertThat(StatusText.duration(999_499)).isEqualTo("999 us");
        assertThat(StatusText.duration(999_500)).isEqualTo("1.0 ms");
        assertThat(StatusText.duration(999_400_000)).isEqualTo("999.4 ms");
        assertThat(StatusText.duration(999_500_000)).isEqualTo("1.0 s");
        assertThat(StatusText.duration(75_000_000_000L)).isEqualTo("75.0 s");
    }
}
