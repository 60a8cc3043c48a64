package org.evoloop.lightbulb;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.gpio.GpioMonitor;
import org.evoloop.gpio.OutputPin;
import org.evoloop.gpio.Pins;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/** The pins of a Raspberry Pi with a real switch and two real lamps; no pins without these options. */
final class Wiring implements AutoCloseable {
    private static final Option<List<Integer>> SWITCH_PIN = Option.value(
            "switch-pin",
            "N",
            "On a Raspberry Pi: a button between GPIO N and ground is the wall switch, too (default: no pin is touched).",
            text -> numbers(text, 1, "--switch-pin takes a GPIO number, as in --switch-pin 17"));

    private static final Option<List<Integer>> LAMP_PINS = Option.value(
            "lamp-pins",
            "A,B",
            "On a Raspberry Pi: lamps at GPIO A and GPIO B are the daylight and the warm light (default: no pin is touched).",
            text -> numbers(text, 2, "--lamp-pins takes two GPIO numbers, as in --lamp-pins 23,24"));

    /** The options that name the pins. */
    static final Options OPTIONS = Options.of(SWITCH_PIN, LAMP_PINS).checking((settings, mistakes) -> {
        Set<Integer> taken = new HashSet<>(settings.get(SWITCH_PIN).orElse(List.of()));
        for (int pin : settings.get(LAMP_PINS).orElse(List.of())) {
            if (!taken.add(pin)) {
                mistakes.add("--lamp-pins has GPIO " + pin + ", which is used already; give each a pin of its own");
            }
        }
    });

    private static final Pattern NUMBER = Pattern.compile("[0-9]{1,2}");

    private final List<Integer> switchPin;
    private final List<Integer> lampPins;
    private @Nullable Pins pins;

    /** Takes the pins from the program's options. */
    Wiring(Settings settings) {
        switchPin = settings.get(SWITCH_PIN).orElse(List.of());
        lampPins = settings.get(LAMP_PINS).orElse(List.of());
    }

    private static List<Integer> numbers(String given, int count, String wanted) {
        List<String> numbers = List.of(given.split(",", -1));
        if (numbers.size() != count || !numbers.stream().allMatch(NUMBER.asMatchPredicate())) {
            throw new IllegalArgumentException(wanted + "; not '" + given + "'");
        }
        List<Integer> pins = numbers.stream().map(Integer::valueOf).toList();
        if (pins.stream().anyMatch(pin -> pin < Pins.LOWEST || pin > Pins.HIGHEST)) {
            throw new IllegalArgumentException(wanted + ", and the header has GPIO " + Pins.LOWEST + " to "
                    + Pins.HIGHEST + "; not '" + given + "'");
        }
        return pins;
    }

    /**
     * Makes the switch report to {@code converter} when it closes, and the lamps show what {@code lamp} does.
     *
     * @throws IOException if this computer has no pins
     */
    void connect(SystemEventConverter converter, Lamp lamp, Clock clock) throws IOException {
        if (!switchPin.isEmpty() || !lampPins.isEmpty()) {
            Pins opened = Pins.open();
            pins = opened;
            connect(converter, lamp, clock, opened);
        }
    }

    void connect(SystemEventConverter converter, Lamp lamp, Clock clock, Pins opened) {
        if (!switchPin.isEmpty()) {
            converter.addMonitor(new GpioMonitor("SwitchPin", opened, clock).controller(switchPin.get(0), "switch"));
        }
        if (!lampPins.isEmpty()) {
            List<OutputPin> lamps =
                    lampPins.stream().map(pin -> new OutputPin(opened, pin)).toList();
            lamp.shownBy((daylight, warm) -> {
                lamps.get(0).set(daylight);
                lamps.get(1).set(warm);
            });
        }
    }

    /** Switches both lamps off and releases the pins. */
    @Override
    public void close() {
        if (pins != null) {
            pins.close();
        }
    }
}
