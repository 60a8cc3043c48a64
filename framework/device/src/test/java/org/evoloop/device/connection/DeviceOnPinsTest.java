package org.evoloop.device.connection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import com.pi4j.Pi4J;
import com.pi4j.context.Context;
import com.pi4j.io.gpio.digital.DigitalOutput;
import com.pi4j.io.gpio.digital.DigitalOutputConfigBuilder;
import com.pi4j.io.gpio.digital.DigitalState;
import com.pi4j.plugin.mock.provider.gpio.digital.MockDigitalInput;
import com.pi4j.plugin.mock.provider.gpio.digital.MockDigitalInputProvider;
import com.pi4j.plugin.mock.provider.gpio.digital.MockDigitalOutputProvider;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.Connection;
import org.evoloop.device.FileModels;
import org.evoloop.device.Outward;
import org.evoloop.device.Parts;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Problems;
import org.evoloop.device.file.Section;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Values;
import org.evoloop.gpio.Pins;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A coffee machine on Pi4J's mocked pins, whose connection is read from a file. */
class DeviceOnPinsTest {
    private static final String FILE = """
            pins: {gpio: true, debounce: 30 ms}
            power: {pulse: 23, for: 300 ms}
            heat: {hold: 24, level: high}
            cool: {hold: 24, level: low}
            press: {contact: 17, event: power}
            does: {contact: 27, event: burnt, debounce: 80 ms}
            state: {contact: 22, closed: Hot, open: "Off"}
            lamp: {hold: 25, level: high}
            """;

    private static final StateMachine MODEL = StateMachine.named("coffee")
            .initial("Off")
            .transition("Off", "power", "On")
            .transition("On", "power", "Off")
            .transition("On", "heat", "Hot")
            .transition("Hot", "cool", "On")
            .transition("Hot", "burnt", "Off")
            .build();

    private final ManualClock clock = new ManualClock();
    private final Context mock = Pi4J.newContextBuilder()
            .add(MockDigitalInputProvider.newInstance(), MockDigitalOutputProvider.newInstance())
            .build();
    private final Problems problems = new Problems(Path.of("coffee.yaml"));
    private final ModelPair pair = new ModelPair(MODEL, MODEL.withName("new"));

    @AfterEach
    void close() {
        mock.shutdown();
        clock.close();
    }

    private Connection read(String text) {
        FileModels models = new FileModels("heater", pair, problems);
        Section file = Section.parse(text, problems);
        Connection pins = new GpioKind(() -> Pins.of(mock)).read("pins", section(file, "pins"), models);
        for (String event : List.of("power", "heat", "cool")) {
            pins.send(event(file, event), section(file, event));
        }
        pins.press(section(file, "press"));
        pins.does(section(file, "does"));
        pins.state(section(file, "state"));
        return pins;
    }

    private static Section section(Section file, String key) {
        return file.section(key).orElseThrow();
    }

    private static Node.Text event(Section file, String key) {
        return file.keys().stream()
                .filter(each -> each.value().equals(key))
                .findFirst()
                .orElseThrow();
    }

    private void contact(int pin, boolean closed, int lastingMillis) {
        MockDigitalInput input = mock.getIO("switch-" + pin);
        input.mockState(closed ? DigitalState.LOW : DigitalState.HIGH);
        clock.advance(Duration.ofMillis(lastingMillis));
    }

    private void awaitState(SystemEventConverter converter, String state) {
        await(state).until(() -> {
            clock.advance(Duration.ofMillis(100));
            return converter.status().states().original().name().equals(state);
        });
    }

    @Test
    void contactsPressAndTellTheStateAndEventsArePulsesAndLevels() throws Exception {
        Connection pins = read(FILE);
        Section file = Section.parse(FILE, problems);
        Outward lamp = pins.outward(section(file, "lamp"));
        assertThat(problems.all()).isEmpty();
        try (SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("coffee", clock))) {
            Parts parts = pins.assemble(converter);
            parts.monitors().forEach(converter::addMonitor);
            parts.executes().forEach(converter::addExecute);
            converter.addKnowledge(new StateKnowledge(pair) {
                @Override
                protected void registerNewFunctions() {}
            });
            List<String> levels = new ArrayList<>();
            mock.<DigitalOutput>getIO("output-23")
                    .addListener(change -> levels.add(change.state().name()));
            for (int pin : List.of(17, 22, 27)) {
                contact(pin, false, 100);
            }
            converter.build();
            converter.start();
            parts.open().open();

            contact(17, true, 10);
            contact(17, false, 100);
            assertThat(converter.history()).noneMatch(entry -> entry.toString().contains("power"));
            contact(17, true, 40);
            awaitState(converter, "On");
            assertThat(levels).containsExactly("HIGH", "LOW");
            contact(22, true, 40);
            awaitState(converter, "Hot");
            contact(27, true, 40);
            assertThat(converter.status().states().original().name()).isEqualTo("Hot");
            contact(27, true, 40);
            awaitState(converter, "Off");
            lamp.perform(Values.NONE);
            assertThat(mock.<DigitalOutput>getIO("output-25").isHigh()).isTrue();
        }
    }

    @Test
    void ifOneOfThePinsCannotBeUsedAllAreReleased() {
        Connection pins = read(FILE);
        mock.create(DigitalOutputConfigBuilder.newInstance(mock)
                .id("output-24")
                .address(24)
                .build());
        try (SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("coffee", clock))) {
            assertThatThrownBy(() -> pins.assemble(converter))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("GPIO 24");
        }
        assertThat(mock.isShutdown()).isTrue();
    }

    @Test
    void whatPinsCannotDoIsAMistakeInItsLine() {
        read("""
                pins: {gpio: true, debounce: soon}
                power: {pulse: 30}
                heat: {hold: 24}
                cool: {hold: 22, level: medium}
                press: {contact: 17}
                does: {contact: 17, event: burnt}
                state: {contact: 22}
                """);
        assertThat(problems.all())
                .anySatisfy(line -> assertThat(line).startsWith("coffee.yaml:1: debounce: 'soon' is no duration"))
                .anySatisfy(line ->
                        assertThat(line).startsWith("coffee.yaml:2: pulse: '30' is no whole number from 2 to 27"))
                .anySatisfy(line -> assertThat(line).startsWith("coffee.yaml:3: heat needs level"))
                .anySatisfy(
                        line -> assertThat(line).startsWith("coffee.yaml:4: level: 'medium' is neither high nor low"))
                .anySatisfy(line -> assertThat(line).startsWith("coffee.yaml:5: press needs event"))
                .anySatisfy(line -> assertThat(line).startsWith("coffee.yaml:6: GPIO 17 is used twice"))
                .anySatisfy(line -> assertThat(line).startsWith("coffee.yaml:7: state needs closed or open"))
                .anySatisfy(line -> assertThat(line).startsWith("coffee.yaml:7: GPIO 22 is used twice"));
    }
}
