package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import com.pi4j.Pi4J;
import com.pi4j.context.Context;
import com.pi4j.io.gpio.digital.DigitalOutput;
import com.pi4j.io.gpio.digital.DigitalState;
import com.pi4j.plugin.mock.provider.gpio.digital.MockDigitalInput;
import com.pi4j.plugin.mock.provider.gpio.digital.MockDigitalInputProvider;
import com.pi4j.plugin.mock.provider.gpio.digital.MockDigitalOutputProvider;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.gpio.GpioMonitor;
import org.evoloop.gpio.PinOptions;
import org.evoloop.gpio.Pins;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;

/** The light bulb with Pi4J's mocked pins. */
class WiringTest {
    private final ManualClock clock = new ManualClock();
    private final Context mock = Pi4J.newContextBuilder()
            .add(MockDigitalInputProvider.newInstance(), MockDigitalOutputProvider.newInstance())
            .build();

    private static Settings options(String... arguments) {
        return Options.named("lamp", "Wired.")
                .and(PinOptions.of(List.of(LightBulb.SWITCH_PIN, LightBulb.LAMP_PINS)))
                .read(List.of(arguments), Map.of());
    }

    private void contact(boolean closed) {
        MockDigitalInput input = mock.getIO("switch-17");
        input.mockState(closed ? DigitalState.LOW : DigitalState.HIGH);
        clock.advance(GpioMonitor.SETTLED);
    }

    private void awaitLamps(boolean daylight, boolean warm) {
        await().atMost(Duration.ofSeconds(20)).untilAsserted(() -> {
            assertThat(mock.<DigitalOutput>getIO("output-23").isHigh()).isEqualTo(daylight);
            assertThat(mock.<DigitalOutput>getIO("output-24").isHigh()).isEqualTo(warm);
        });
    }

    @Test
    void aButtonAndTwoLampsAreTheWholeLightBulb() {
        ModelFile machines = ModelFile.read(Path.of("../models/light-bulb.xml"));
        ModelPair models = new ModelPair(machines.pick("original"), machines.pick("new"));
        LightBulb lamp = new LightBulb();
        try (Pins pins = Pins.of(mock);
                SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock))) {
            converter.addExecute(lamp.execute());
            lamp.wire(pins, options("--switch-pin", "17", "--lamp-pins", "23,24"), converter);
            converter.addKnowledge(lamp.knowledge(models));
            converter.build();
            converter.start();
            contact(false);
            awaitLamps(false, false);
            contact(true);
            awaitLamps(true, false);
            contact(false);
            contact(true);
            await().atMost(Duration.ofSeconds(20))
                    .until(() -> converter.status().states().evolved().name().equals("wait"));
            awaitLamps(true, false);
            contact(false);
            contact(true);
            awaitLamps(false, true);
            contact(false);
            contact(true);
            awaitLamps(false, false);
        }
    }

    @Test
    void whatIsNoPinIsRefused() {
        assertThatThrownBy(() -> options("--switch-pin", "x"))
                .hasMessageContaining("--switch-pin takes a GPIO number, as in --switch-pin 17; not 'x'");
        assertThatThrownBy(() -> options("--lamp-pins", "23"))
                .hasMessageContaining("--lamp-pins takes 2 GPIO numbers, as in --lamp-pins 23,24; not '23'");
        assertThatThrownBy(() -> options("--switch-pin", "28", "--lamp-pins", "23,1"))
                .hasMessageContaining("--switch-pin 17, and the header has GPIO 2 to 27; not '28'")
                .hasMessageContaining("--lamp-pins 23,24, and the header has GPIO 2 to 27; not '23,1'");
        assertThatThrownBy(() -> options("--lamp-pins", "23,23"))
                .hasMessage("--lamp-pins has GPIO 23, which is used already; give each a pin of its own");
        assertThatThrownBy(() -> options("--switch-pin", "24", "--lamp-pins", "23,24"))
                .hasMessage("--lamp-pins has GPIO 24, which is used already; give each a pin of its own");
    }
}
