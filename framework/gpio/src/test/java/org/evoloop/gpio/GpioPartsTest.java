package org.evoloop.gpio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import com.pi4j.Pi4J;
import com.pi4j.context.Context;
import com.pi4j.io.gpio.digital.DigitalOutput;
import com.pi4j.io.gpio.digital.DigitalState;
import com.pi4j.plugin.mock.provider.gpio.digital.MockDigitalInput;
import com.pi4j.plugin.mock.provider.gpio.digital.MockDigitalInputProvider;
import com.pi4j.plugin.mock.provider.gpio.digital.MockDigitalOutputProvider;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.LightBulb;
import org.evoloop.Machines;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A button and a relay on Pi4J's mocked pins, with a converter between them. */
class GpioPartsTest {
    private static final Duration PATIENCE = Duration.ofSeconds(20);
    private static final Duration PRESS = Duration.ofMillis(200);

    private final ManualClock clock = new ManualClock();
    private final Context mock = Pi4J.newContextBuilder()
            .add(MockDigitalInputProvider.newInstance(), MockDigitalOutputProvider.newInstance())
            .build();
    private final Pins pins = Pins.of(mock);

    @TempDir
    private Path folder;

    @AfterEach
    void close() {
        pins.close();
        clock.close();
    }

    private void contact(int pin, boolean closed) {
        MockDigitalInput input = mock.getIO("switch-" + pin);
        input.mockState(closed ? DigitalState.LOW : DigitalState.HIGH);
    }

    @Test
    void aPressIsAnEventAndAnEventIsAPress() {
        List<String> levels = new CopyOnWriteArrayList<>();
        try (SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock))) {
            GpioMonitor monitor = new GpioMonitor("Wall", pins, clock);
            contactsOpen(monitor);
            GpioExecute execute = new GpioExecute("Lamp", pins, clock, Map.of("switch", 23), PRESS);
            DigitalOutput relay = mock.getIO("output-23");
            relay.addListener(change -> levels.add(change.state().name()));
            converter.addMonitor(monitor);
            converter.addExecute(execute);
            converter.addKnowledge(LightBulb.withoutTimeout());
            converter.build();
            converter.start();

            bounce(17, true);
            await().atMost(PATIENCE).until(() -> levels.equals(List.of("HIGH")));
            await().atMost(PATIENCE).until(() -> clock.pendingTasks() > 0);
            clock.advance(PRESS);
            await().atMost(PATIENCE).until(() -> levels.equals(List.of("HIGH", "LOW")));
            assertThat(converter.status().states().original().name()).isEqualTo("off");
            await().atMost(PATIENCE).until(() -> clock.pendingTasks() > 0);
            clock.advance(PRESS);
            await().atMost(PATIENCE)
                    .until(() -> converter.status().states().original().name().equals("on"));

            bounce(17, false);
            bounce(27, true);
            await().atMost(PATIENCE)
                    .until(() -> converter.status().states().original().name().equals("off"));
            assertThat(levels).hasSize(2);
        }
    }

    @Test
    void aPinIsHeldAndAnotherShowsTheState() {
        try (SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock))) {
            Duration slow = Duration.ofMillis(100);
            PushMonitor wall = new PushMonitor("Wall");
            GpioMonitor monitor =
                    new GpioMonitor("Sensor", pins, clock).debounce(slow).found(17, "on", "off");
            contact(17, false);
            clock.advance(slow);
            GpioExecute execute =
                    new GpioExecute("Lamp", pins, clock).hold("heat", 23, true).hold("cool", 23, false);
            DigitalOutput relay = mock.getIO("output-23");
            converter.addMonitor(monitor);
            converter.addMonitor(wall);
            converter.addExecute(execute);
            StateMachine heater = Machines.machine("heater", "off heat -> on", "on cool -> off");
            converter.addKnowledge(new StateKnowledge(new ModelPair(heater, heater)) {
                @Override
                protected void registerNewFunctions() {}
            });
            converter.build();
            converter.start();
            wall.press("heat");
            awaitState(converter, "on");
            assertThat(relay.isHigh()).isTrue();
            clock.advance(PRESS);
            assertThat(relay.isHigh()).isTrue();
            wall.press("cool");
            awaitState(converter, "off");
            assertThat(relay.isHigh()).isFalse();

            contact(17, true);
            clock.advance(slow.minusMillis(1));
            assertThat(converter.status().states().original().name()).isEqualTo("off");
            clock.advance(Duration.ofMillis(1));
            awaitState(converter, "on");
            contact(17, false);
            clock.advance(slow);
            awaitState(converter, "off");
        }
    }

    @Test
    void aSensedStateIsKnownFromTheBeginning() {
        try (SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock))) {
            GpioMonitor monitor = new GpioMonitor("Sensor", pins, clock).found(17, "on", "on");
            converter.addMonitor(monitor);
            converter.addExecute(new GpioExecute("Lamp", pins, clock).hold("switch", 23, true));
            converter.addKnowledge(LightBulb.withoutTimeout());
            converter.build();
            converter.start();
            awaitState(converter, "on");
        }
    }

    private static void awaitState(SystemEventConverter converter, String state) {
        await().atMost(PATIENCE)
                .until(() -> converter.status().states().original().name().equals(state));
    }

    private void contactsOpen(GpioMonitor monitor) {
        monitor.controller(17, "switch").device(27, "switch");
        contact(17, false);
        contact(27, false);
        clock.advance(GpioMonitor.SETTLED);
    }

    /** Bounces like a real contact before it settles. */
    private void bounce(int pin, boolean closed) {
        for (int i = 0; i < 5; i++) {
            contact(pin, closed);
            clock.advance(Duration.ofMillis(1));
            contact(pin, !closed);
            clock.advance(Duration.ofMillis(1));
        }
        contact(pin, closed);
        clock.advance(GpioMonitor.SETTLED);
    }

    @Test
    void whatIsTooShortForAContactIsNone() {
        List<Boolean> closed = new CopyOnWriteArrayList<>();
        Contact contact = new Contact(clock, GpioMonitor.SETTLED, false, closed::add);
        contact.changed(true);
        clock.advance(GpioMonitor.SETTLED.minusMillis(1));
        contact.changed(false);
        clock.advance(PRESS);
        assertThat(closed).isEmpty();
        contact.changed(true);
        clock.advance(GpioMonitor.SETTLED);
        contact.changed(false);
        contact.changed(true);
        clock.advance(PRESS);
        assertThat(closed).containsExactly(true);
        contact.changed(false);
        clock.advance(GpioMonitor.SETTLED);
        assertThat(closed).containsExactly(true, false);
    }

    @Test
    void aPinIsOneOfTheHeadersAndUsedOnce() {
        new OutputPin(pins, 5).set(true);
        assertThat(mock.<DigitalOutput>getIO("output-5").isHigh()).isTrue();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new OutputPin(pins, 5))
                .withMessage("GPIO 5 is used twice; give each a pin of its own");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new OutputPin(pins, 40))
                .withMessage("there is no GPIO 40; the header has GPIO 2 to 27");
    }

    @Test
    void onAnotherComputerOneMessageSaysSo() throws IOException {
        Path model = folder.resolve("model");
        assertThatThrownBy(() -> Pins.requireRaspberryPi(model))
                .isInstanceOf(IOException.class)
                .hasMessage(
                        "this computer has no GPIO pins: it is no Raspberry Pi; run it on one, or leave the pins out");
        Files.writeString(model, "Banana Pro\0");
        assertThatThrownBy(() -> Pins.requireRaspberryPi(model))
                .hasMessageContaining("a Banana Pro, not a Raspberry " + "Pi");
        Files.writeString(model, "Raspberry Pi 4 Model B Rev 1.4\0");
        Pins.requireRaspberryPi(model);
    }
}
