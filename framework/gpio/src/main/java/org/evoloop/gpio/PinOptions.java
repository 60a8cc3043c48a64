package org.evoloop.gpio;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;

/**
 * Options of a program that name pins, by their GPIO numbers; no pin is touched unless its option is given.
 *
 * @since 0.1
 */
public final class PinOptions {
    private static final Pattern NUMBER = Pattern.compile("[0-9]{1,2}");

    private PinOptions() {}

    /**
     * An option that names one or more pins, such as {@code --lamp-pins 23,24}.
     *
     * @param name without dashes
     * @param example the numbers that a message gives as an example; the option takes as many
     * @param label the placeholder of the numbers in a usage line
     * @param purpose what is at these pins
     */
    public static Option<List<Integer>> pins(String name, String example, String label, String purpose) {
        int count = example.split(",").length;
        String wanted = "--" + name + " takes " + (count == 1 ? "a GPIO number" : count + " GPIO numbers")
                + ", as in --" + name + " " + example;
        return Option.value(
                name,
                label,
                "On a Raspberry Pi: " + purpose + " (default: no pin is touched).",
                text -> numbers(text, count, wanted));
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

    /** The options of a program that take pins, each of which may be given once. */
    public static Options of(List<Option<List<Integer>>> options) {
        return Options.of(options.toArray(Option<?>[]::new)).checking((settings, mistakes) -> {
            Set<Integer> taken = new HashSet<>();
            for (Option<List<Integer>> option : options) {
                for (int pin : settings.get(option).orElse(List.of())) {
                    if (!taken.add(pin)) {
                        mistakes.add("--" + option.name() + " has GPIO " + pin
                                + ", which is used already; give each a pin of its own");
                    }
                }
            }
        });
    }

    /**
     * Opens the pins of this computer if one of these options is given.
     *
     * @throws IOException as {@link Pins#open}
     */
    public static Optional<Pins> open(Settings settings, List<Option<List<Integer>>> options) throws IOException {
        boolean given = options.stream().anyMatch(option -> settings.get(option).isPresent());
        return given ? Optional.of(Pins.open()) : Optional.empty();
    }
}
