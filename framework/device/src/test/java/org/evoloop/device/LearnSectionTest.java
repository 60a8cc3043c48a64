package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.awaitility.Awaitility;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.evolution.Step;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a device file says about learning, and a converter of it that assumes nothing. */
class LearnSectionTest {
    @TempDir
    private Path folder;

    private DeviceFile read(String address, String learn) throws IOException {
        Path file = folder.resolve("lamp.yaml");
        Files.writeString(file, """
                converter: lamp
                connections: {lamp: {lines: "%s"}}
                device:
                  send: {power: P, clear: C}
                  state: {is on: "On", is off: "Off"}
                  does: {tripped: trip}
                learn:
                %s
                """.formatted(address, learn.indent(2)));
        return DeviceFile.read(file, DeviceProgram.options());
    }

    @Test
    void allRulesAreRead() throws IOException {
        LearnSection learn = read("tcp://127.0.0.1:1", """
                home: "Off"
                reset: power
                settle: 2 s
                never: [clear]
                never-in: {"On": [power]}
                presses-an-hour: 60
                stop-above: {temperature: 80.5}
                between: ["08:00", "20:00"]
                """).learning();

        assertThat(learn.home()).isEqualTo("Off");
        assertThat(learn.reset()).containsExactly("power");
        assertThat(learn.settle()).isEqualTo(Duration.ofSeconds(2));
        assertThat(learn.never()).containsExactly("clear");
        assertThat(learn.neverIn()).isEqualTo(Map.of("On", Set.of("power")));
        assertThat(learn.pressesAnHour()).contains(60);
        assertThat(learn.stops()).isEqualTo(Map.of("temperature", 80.5));
        assertThat(learn.hours()).isEqualTo(List.of(LocalTime.of(8, 0), LocalTime.of(20, 0)));
    }

    @Test
    void aResetMayBeByStateAndTakeItsTime() throws IOException {
        LearnSection learn = read("tcp://127.0.0.1:1", """
                home: "Off"
                reset: {"On": [clear, power]}
                home-within: 2 min
                """).learning();

        assertThat(learn.reset()).isEmpty();
        assertThat(learn.resetIn()).isEqualTo(Map.of("On", List.of("clear", "power")));
        assertThat(learn.homeWithin()).isEqualTo(Duration.ofMinutes(2));
    }

    @Test
    void aStateThatTheDeviceDoesNotReportIsNoHomeAndHasNoRule() {
        assertThatThrownBy(() -> read("tcp://127.0.0.1:1", """
                        home: Of
                        reset: {Onn: [power, blow]}
                        never-in: {Dim: power}
                        """))
                .isInstanceOf(DeviceFileException.class)
                .hasMessageContaining("lamp.yaml:8: 'Of' is not a state that the device reports; did you mean Off")
                .hasMessageContaining("lamp.yaml:9: 'Onn' is not a state that the device reports; did you mean On")
                .hasMessageContaining("lamp.yaml:9: 'blow' is not an event that is sent to the device")
                .hasMessageContaining("lamp.yaml:10: 'Dim' is not a state that the device reports");
    }

    @Test
    void aHomeNeedsAWayAndAWayByStateNeedsAHome() {
        assertThatThrownBy(() -> read("tcp://127.0.0.1:1", "home: \"Off\""))
                .hasMessageContaining("learn has a home, and nothing that brings the device there");
        assertThatThrownBy(() -> read("tcp://127.0.0.1:1", "reset: {\"On\": power}"))
                .hasMessageContaining("learn.reset is by state, so learn needs home: STATE");
    }

    @Test
    void everyMistakeIsNamedWithItsLine() {
        assertThatThrownBy(() -> read("tcp://127.0.0.1:1", """
                        reset: [powr, clear]
                        never: clear
                        stop-above: {temperature: hot}
                        between: ["25:00"]
                        nver: power
                        """))
                .isInstanceOf(DeviceFileException.class)
                .hasMessageContaining("lamp.yaml:8")
                .hasMessageContaining("'powr' is not an event that is sent to the device; did you mean power")
                .hasMessageContaining("'clear' is sent for the reset, and learn.never forbids it")
                .hasMessageContaining("'hot' is no number")
                .hasMessageContaining("25:00")
                .hasMessageContaining("nver");
    }

    @Test
    void aConverterThatAssumesNothingFollowsWhatTheDeviceReports() throws IOException {
        EventExecute none = new EventExecute("None") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("nothing");
            }

            @Override
            protected void send(Step step) {}
        };
        PushMonitor buttons = new PushMonitor("Buttons");
        try (LineDevice lamp = new LineDevice(line -> line.equals("P") ? "is off" : "");
                SystemClock clock = new SystemClock()) {
            DeviceFile file = read(lamp.address(), "home: \"Off\"\nreset: power");
            try (DeviceConverter opened =
                    DeviceConverter.open(file, file.free("nothing"), clock, buttons, new EventAnalyze(), none)) {
                Awaitility.await().until(lamp::isConnected);
                assertThat(file.sent()).containsExactlyInAnyOrder("power", "clear");
                assertThat(opened.converter().status().states().original().name())
                        .isEqualTo("On");
                Awaitility.await().until(() -> buttons.submit("power").join().isHandled());
                Awaitility.await()
                        .until(() -> opened.converter()
                                .status()
                                .states()
                                .original()
                                .name()
                                .equals("Off"));
            }
        }
    }
}
