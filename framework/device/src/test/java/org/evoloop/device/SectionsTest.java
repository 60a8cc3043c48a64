package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.evoloop.config.Options;
import org.evoloop.converter.DeviceLink;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.evolution.Values;
import org.evoloop.function.Reading;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Functions, guards and effects of a device file, and what each of them refuses. */
class SectionsTest {
    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
                On --> On : level
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
                On --> On : level
                On --> Slow : slow [night] / chime
                Slow --> Off : power
                Slow --> On : finished
                Off --> Off : look [hot]
                Off --> Off : ask [many]
            ```
            """;

    private static final String LAMP = """
            converter: lamp
            models: {original: m.md#original, new: m.md#new}
            connections: {lamp: {lines: "tcp://127.0.0.1:1"}, panel: {lines: "tcp://127.0.0.1:2"}}
            device:
              send: {power: {to: lamp, line: P}, level: {to: lamp, line: L, cost: 3}}
              state: [{from: lamp, values: {is on: "On"}}]
              do-not-pass: ["On"]
            functions:
              Slow:
                steps: [{send: level}, {wait: 10 s}, {say: half}, {to: panel, line: half}, {wait: 10 s}, {finish: finished}]
                at: [{time: "06:30", send: level}]
                on-exit: [{to: panel, line: done}, {run: ["true"]}]
            guards:
              night: {between: ["22:00", "06:00"]}
              hot: {reading: temperature, above: 20, below: 30}
              many: {value: count, above: 3}
            effects:
              chime: {run: [aplay, chime.wav]}
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void draw() throws IOException {
        Files.writeString(folder.resolve("m.md"), MODELS);
    }

    private DeviceFile read(String text) throws IOException {
        return DeviceFile.read(Files.writeString(folder.resolve("lamp.yaml"), text), Options.of());
    }

    @Test
    void aFunctionDoesItsStepsOneAfterAnother() throws IOException {
        DeviceFile lamp =
                read(LAMP.replace("night: {between: [\"22:00\", \"06:00\"]}", "night: {value: n, below: 1}") + """
                scenarios:
                  not at night:
                    - {press: power}
                    - {press: slow, state: "On"}
                """);
        assertThat(lamp.scenarios().get(0).run(lamp)).isEmpty();
        DeviceFile always = read(LAMP.replace("[\"22:00\", \"06:00\"]", "[\"00:00\", \"00:00\"]") + """
                scenarios:
                  slowly:
                    - {press: power, sent: [power]}
                    - {press: slow, state: Slow, sent: [level]}
                    - {after: 19 s, state: Slow}
                    - {after: 1 s, state: "On", sent: []}
                """);
        always.guards().attach(new ManualClock(), List.of());
        assertThat(always.scenarios().get(0).run(always)).isEmpty();
    }

    @Test
    void aGuardHoldsByTimeReadingOrValue() throws IOException {
        DeviceFile lamp = read(LAMP);
        ManualClock clock = new ManualClock();
        List<Reading> readings = new ArrayList<>();
        lamp.guards().attach(clock, List.of(new Links(List.of(new DeviceLink() {
            @Override
            public boolean isUp() {
                return true;
            }

            @Override
            public List<Reading> readings() {
                return readings;
            }

            @Override
            public String describe() {
                return "here";
            }
        }))));
        var hot = lamp.guards().all().get("hot");
        var many = lamp.guards().all().get("many");
        assertThat(hot).isNotNull();
        assertThat(many).isNotNull();
        assertThat(hot.test(Values.NONE)).isFalse();
        readings.add(Reading.of("temperature", 25.0, "°C"));
        assertThat(hot.test(Values.NONE)).isTrue();
        readings.set(0, Reading.of("temperature", 30.0, "°C"));
        assertThat(hot.test(Values.NONE)).isFalse();
        assertThat(many.test(Values.NONE)).isFalse();
        assertThat(many.test(new Values(Map.of("count", 4.0)))).isTrue();
        assertThat(many.test(new Values(Map.of("count", "4")))).isFalse();
    }

    @Test
    void severalConnectionsAreOneLink() {
        Links links = new Links(List.of(link(true, "a"), link(false, "b")));
        assertThat(links.isUp()).isFalse();
        assertThat(links.describe()).isEqualTo("a; b");
        assertThat(links.downSince()).isEmpty();
    }

    private static DeviceLink link(boolean up, String name) {
        return new DeviceLink() {
            @Override
            public boolean isUp() {
                return up;
            }

            @Override
            public String describe() {
                return name;
            }
        };
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{send: level}, {wait: 10 s} | {send: level, wait: 10 s} | lamp.yaml:10: functions.Slow.steps needs only one of send, raise, finish, wait, say, run, to",
                "{say: half} | {sya: half} | lamp.yaml:10: functions.Slow.steps needs one of send, raise, finish, wait, say, run, to",
                "{finish: finished} | {finish: finishd} | lamp.yaml:10: the new model has no transition for 'finishd' in Slow; did you mean finished?",
                "06:30 | 6 o'clock | lamp.yaml:11: time: '6 o'clock' is no time of day; write it as 07:30",
                "{to: panel, line: done} | {send: level} | lamp.yaml:12: when a state has been left, its function can only act outside",
                "to: panel, line: half | to: pannel, line: half | lamp.yaml:10: there is no connection 'pannel'; did you mean panel?",
                "between: [\"22:00\", \"06:00\"] | between: [\"22:00\"] | lamp.yaml:14: guards.night.between takes two times of day",
                "between: [\"22:00\", \"06:00\"] | between: [\"22:00\", \"6\"] | lamp.yaml:14: '6' is no time of day; write it as 07:30",
                "above: 20, below: 30 | abov: 20 | lamp.yaml:15: guards.hot needs above or below, or both",
                "above: 3 | above: three | lamp.yaml:16: above: 'three' is no number",
                "{value: count, above: 3} | {above: 3} | lamp.yaml:16: guards.many needs one of between, reading, value",
                "many: | mny: | lamp.yaml:16: 'mny' is not a guard of the models; did you mean many?",
                "chime: {run | chim: {run | lamp.yaml:18: 'chim' is not an effect of the new model; did you mean chime?",
                "cost: 3 | cost: 0 | lamp.yaml:5: cost: '0' is no whole number from 1 to",
                "{to: lamp, line: P} | {line: P} | lamp.yaml:5: device.send.power needs to, the name of a connection; there is lamp, panel",
                "{to: lamp, line: P} | {to: lamp} | lamp.yaml:5: device.send.power needs line",
                "{to: lamp, line: P} | [P] | lamp.yaml:5: how power is sent is a list; write a text or a mapping",
                "do-not-pass: [\"On\"] | do-not-pass: [\"Onn\"] | lamp.yaml:7: 'Onn' is not a state of the original model; did you mean On?",
                "{from: lamp, values: {is on: \"On\"}} | {from: lamp} | lamp.yaml:6: device.state needs values",
            })
    void whatIsWrongIsSaidInItsLine(String right, String wrong, String message) {
        assertThat(LAMP).contains(right);
        assertThatThrownBy(() -> read(LAMP.replace(right, wrong)))
                .isInstanceOf(DeviceFileException.class)
                .satisfies(refused -> assertThat(
                                refused.getMessage().replace(folder + "/", "").lines())
                        .anySatisfy(line -> assertThat(line).startsWith(message)));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "does: [{values: {a: b}}] | 'a' is no request; write one such as POST /boost",
                "send: {x: {call: POST /}} | connection a only receives; send over another one",
                "readings: {t: {json: /x}} | connection a, of the kind webhooks, has no readings",
            })
    void aConnectionSaysWhatItCannotDo(String device, String message) {
        String text = "converter: x\nconnections: {a: {webhooks: 8090}}\ndevice: {" + device + "}\n";
        assertThatThrownBy(() -> read(text)).hasMessageContaining(message);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "state: {is on: 'On'}, does: {is on: lit} | lamp.yaml:3: 'is on' is also in device.state, in line 3, and would",
                "state: {json: /w, ranges: {Low: ..10, High: 5..}} | lamp.yaml:3: the ranges ..10 and 5.. overlap",
            })
    void whatWouldBeHeardAsSomethingElseIsRefused(String device, String message) throws IOException {
        String text =
                "converter: x\nconnections: {a: {mqtt: 'mqtt://h', command-topic: c, state-topic: s}}\ndevice: {send: {x: X}, "
                        + device + "}\n";
        assertThatThrownBy(() -> read(text)).hasMessageContaining(message);
        assertThat(read(text.replace("{is on: lit}", "{is lit: lit}").replace("..10", "..5")))
                .isNotNull();
    }

    /** Which keys the device has beside them depends on the connection that is missing. */
    @Test
    void whatFollowsFromAMissingConnectionIsNotSaidToo() {
        String text = """
                converter: x
                connections: {broker: {mqtt: "mqtt://a", command-topic: a}, panel: {program: [cat]}}
                device:
                  send: {power: {payload: P}}
                  confirmed: {within: 1 s}
                """;
        assertThatThrownBy(() -> read(text))
                .satisfies(
                        refused -> assertThat(refused.getMessage().lines())
                                .singleElement()
                                .asString()
                                .endsWith(
                                        "lamp.yaml:4: device.send.power needs to, the name of a connection; there is broker, panel"));
    }

    @Test
    void aFileThatIsNoneIsRefusedWithItsName() throws IOException {
        assertThatThrownBy(() -> DeviceFile.read(folder, Options.of())).hasMessageContaining("is a directory");
        Path binary = Files.write(folder.resolve("b.yaml"), new byte[] {(byte) 0xff, (byte) 0xfe});
        assertThatThrownBy(() -> DeviceFile.read(binary, Options.of())).hasMessageContaining("is not text in UTF-8");
        Path large = Files.writeString(folder.resolve("l.yaml"), "#".repeat(1 << 19));
        assertThatThrownBy(() -> DeviceFile.read(large, Options.of())).hasMessageContaining("larger than 256 kB");
        assertThatThrownBy(() -> read("a: ".repeat(3) + "[".repeat(200))).isInstanceOf(DeviceFileException.class);
        assertThatThrownBy(() -> read("converter: !x y\n")).hasMessageContaining("tags (!) are not supported");
        assertThatThrownBy(() -> read("converter: x\n---\na: b\n")).hasMessageContaining("a second document begins");
        assertThatThrownBy(() -> read("? [a]\n: b\n")).hasMessageContaining("a name is expected before the colon");
    }
}
