package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.config.Options;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.Watcher;
import org.evoloop.mqtt.home.HomeAssistant;
import org.evoloop.mqtt.home.HomeSetting;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The schedule and the quiet hours of a device file. */
@Timeout(60)
class DaySectionTest {
    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Docked
                Docked --> Cleaning : start
                Cleaning --> Docked : dock
                Cleaning --> Docked : «spontaneous» docks
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Docked
                Docked --> Cleaning : start
                Cleaning --> Docked : dock
                Cleaning --> Docked : docks
                Docked --> Waiting : clean
                Cleaning --> Cleaning : clean
                Waiting --> Cleaning : quietOver
                Waiting --> Cleaning : start
            ```
            """;

    private static final String ROBOT = """
            converter: robot
            models: {original: m.md#original, new: m.md#new}
            connections: {broker: {mqtt: "BROKER", command-topic: robot/set}}
            device: {send: {start: START, dock: DOCK}}
            functions: {Waiting: {until-quiet-ends: quietOver}}
            """;

    private static final String DAY = """
            schedule:
              start: ["06:00", "08:00", "23:00"]
            quiet: {between: ["22:00", "05:00"], refuse: [start]}
            """;

    private final ManualClock clock = new ManualClock();

    @TempDir
    private Path folder;

    private DeviceFile read(String broker, String more) throws IOException {
        Files.writeString(folder.resolve("m.md"), MODELS);
        Path file = Files.writeString(folder.resolve("robot.yaml"), ROBOT.replace("BROKER", broker) + more);
        return DeviceFile.read(file, Options.of());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "schedule: {strat: '09:00'} | 'strat' is not an event that can be scheduled; did you mean start?",
                "schedule: {docks: '09:00'} | 'docks' is not an event that can be scheduled",
                "schedule: {start: at noon} | schedule.start is at noon; give a time of day, alone or after the days, for",
                "schedule: {start: []} | 'start' needs times, such as [\"09:00\", \"MON,FRI 18:30\"]",
                "quiet: {between: ['22:00']} | quiet.between takes two times of day, such as [\"22:00\", \"06:00\"]",
                "quiet: {between: ['22:00', late]} | 'late' is no time of day; write it as 07:30",
                "quiet: {refuse: [start]} | quiet needs between",
                "quiet: {between: ['22:00', '05:00'], refuse: [strat]} | 'strat' is not an event that can be refused; did",
                "quiet: {betwen: ['22:00', '05:00']} | 'betwen' is not known in quiet; did you mean between?",
            })
    void whatIsWrongIsSaidWithItsLine(String section, String mistake) {
        Throwable refused = catchThrowable(() -> read("mqtt://127.0.0.1:1", section.strip() + "\n"));
        assertThat(refused).hasMessageContaining("robot.yaml:6: " + mistake);
    }

    @Test
    void quietHoursBelongToSomethingThatIsQuiet() {
        assertThat(catchThrowable(() -> read("mqtt://127.0.0.1:1", "")))
                .hasMessageContaining(
                        "robot.yaml:5: functions.Waiting waits for the end of the quiet hours, and there are"
                                + " none; add the section quiet: {between: [\"22:00\", \"07:00\"]}");
        Path file = folder.resolve("lamp.yaml");
        assertThat(catchThrowable(() -> DeviceFile.read(
                        Files.writeString(
                                file,
                                "converter: lamp\nconnections: {lamp: {lines: \"tcp://h:1\"}}\ndevice: {send: {on: ON}}\n"
                                        + "quiet: {between: [\"22:00\", \"07:00\"]}\n"),
                        Options.of())))
                .hasMessage(file + ":4: quiet refuses nothing, and nothing waits for its end; add refuse: [EVENT], or a"
                        + " function {until-quiet-ends: EVENT}");
    }

    @Test
    void scenariosFollowThem() throws IOException {
        DeviceFile robot = read("mqtt://127.0.0.1:1", """
                schedule: {start: "08:00", clean: "23:00"}
                quiet: {between: ["22:00", "05:00"], refuse: [start]}
                scenarios:
                  it starts in the morning, and not in the night:
                    - {until: "07:59", sent: []}
                    - {until: "08:00", sent: [start], state: Cleaning}
                    - {press: dock, sent: [dock]}
                    - {until: "22:00", press: start, sent: [], state: Docked}
                  what waits begins when the night is over:
                    - {until: "07:59"}
                    - {until: "22:30"}
                    - {press: dock, sent: [start, dock]}
                    - {until: "23:00", sent: [], state: Waiting}
                    - {until: "04:59", sent: [], state: Waiting}
                    - {until: "05:00", sent: [start], state: Cleaning}
                """);
        assertThat(robot.scenarios())
                .extracting(scenario -> scenario.run(robot))
                .containsOnly("");
    }

    private void until(String time) {
        ZonedDateTime now = clock.wallTime().atZone(ZoneId.systemDefault());
        ZonedDateTime next = now.with(LocalTime.parse(time));
        clock.advance(Duration.between(now, next.isAfter(now) ? next : next.plusDays(1)));
    }

    private static long starts(Watcher watcher) {
        return watcher.heard().stream().filter("robot/set START"::equals).count();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void itsOwnerChangesAndSkipsInHomeAssistant() throws Exception {
        String state = "evoloop/robot/state";
        try (Mosquitto broker = new Mosquitto(folder).start();
                Watcher watcher = new Watcher(broker)) {
            DeviceFile robot = read(broker.url(), DAY);
            List<Parts> parts = new ArrayList<>();
            SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("robot", clock));
            HomeAssistant home = null;
            try {
                until("05:30");
                List<HomeSetting> settings = robot.day().addTo(converter);
                Wiring.add(robot, converter, parts::add);
                converter.addKnowledge(robot.knowledge(robot.models()));
                converter.build();
                for (Parts each : parts) {
                    each.open().open();
                }
                converter.start();
                home = new HomeAssistant(converter, BrokerAddress.parse(broker.url()));
                settings.forEach(home::setting);
                home.open();
                watcher.awaitNewest(
                        state,
                        "\"settings\":{\"quiet_from\":\"22:00\",\"quiet_until\":\"05:00\",\"schedule\":\"ON\","
                                + "\"start_at\":\"06:00; 08:00; 23:00\",\"skip_the_next\":\"OFF\"");
                watcher.publish("evoloop/robot/setting/skip_the_next/set", "ON", false);
                watcher.awaitNewest(state, "\"skip_the_next\":\"ON\"");

                until("06:00");
                watcher.awaitNewest(state, "\"skip_the_next\":\"OFF\"");
                assertThat(starts(watcher)).isZero();
                until("08:00");
                watcher.awaitHeard("robot/set", "START");
                watcher.publish("evoloop/robot/press", "dock", false);
                watcher.awaitHeard("robot/set", "DOCK");

                until("23:00");
                watcher.awaitHeard("evoloop/robot/decision", "it is quiet until 05:00");
                watcher.publish("evoloop/robot/setting/quiet_from/set", "23:30", false);
                watcher.awaitNewest(state, "\"quiet_from\":\"23:30\"");
                assertThat(starts(watcher)).isEqualTo(1);
                watcher.publish("evoloop/robot/press", "start", false);
                await().untilAsserted(() -> assertThat(starts(watcher)).isEqualTo(2));
            } finally {
                if (home != null) {
                    home.close();
                }
                converter.close();
                parts.forEach(each -> each.close().run());
            }
        }
    }
}
