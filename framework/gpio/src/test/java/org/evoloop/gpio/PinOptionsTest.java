package org.evoloop.gpio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;
import org.junit.jupiter.api.Test;

/** Pins that are named by a program's options. */
class PinOptionsTest {
    private static final Option<List<Integer>> BUTTON = PinOptions.pins("button", "17", "N", "a button");
    private static final Option<List<Integer>> RELAYS = PinOptions.pins("relays", "23,24", "A,B", "two relays");

    private static Settings read(String... arguments) {
        return Options.named("pump", "Pumps.")
                .and(PinOptions.of(List.of(BUTTON, RELAYS)))
                .read(List.of(arguments), Map.of());
    }

    @Test
    void eachOptionNamesItsPins() {
        Settings settings = read("--button", "2", "--relays", "3,27");

        assertThat(settings.get(BUTTON)).contains(List.of(2));
        assertThat(settings.get(RELAYS)).contains(List.of(3, 27));
    }

    @Test
    void whatIsNoPinOrGivenTwiceIsRefused() {
        assertThatThrownBy(() -> read("--button", "x", "--relays", "23"))
                .hasMessageContaining("--button takes a GPIO number, as in --button 17; not 'x'")
                .hasMessageContaining("--relays takes 2 GPIO numbers, as in --relays 23,24; not '23'");
        assertThatThrownBy(() -> read("--button", "28"))
                .hasMessage(
                        "--button takes a GPIO number, as in --button 17, and the header has GPIO 2 to 27; not '28'");
        assertThatThrownBy(() -> read("--button", "24", "--relays", "23,24"))
                .hasMessage("--relays has GPIO 24, which is used already; give each a pin of its own");
    }

    @Test
    void noPinIsTouchedUnlessAnOptionNamesOne() throws IOException {
        assertThat(PinOptions.open(read(), List.of(BUTTON, RELAYS))).isEmpty();
    }
}
