package org.evoloop.lightbulb;

import java.io.IOException;
import java.util.Iterator;
import java.util.List;
import java.util.regex.Pattern;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.gpio.GpioMonitor;
import org.evoloop.gpio.Output;
import org.evoloop.gpio.Pins;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/** The pins of a Raspberry Pi at which a real switch and two real lamps are; without options none. */
final class Wiring implements AutoCloseable {
    static final String USAGE = "[--switch-pin N] [--lamp-pins DAYLIGHT,WARM]";

    private static final Pattern NUMBER = Pattern.compile("[0-9]{1,2}");

    private List<Integer> switchPin = List.of();
    private List<Integer> lampPins = List.of();
    private @Nullable Pins pins;

    /**
     * Takes its options out of a command line.
     *
     * @throws IllegalArgumentException if one has no or wrong numbers
     */
    static Wiring takeFrom(List<String> arguments) {
        Wiring wiring = new Wiring();
        for (Iterator<String> rest = arguments.iterator(); rest.hasNext(); ) {
            String option = rest.next();
            if (option.equals("--switch-pin")) {
                wiring.switchPin = numbers(option, 1, "a GPIO number, as in --switch-pin 17", rest);
            } else if (option.equals("--lamp-pins")) {
                wiring.lampPins = numbers(option, 2, "two GPIO numbers, as in --lamp-pins 23,24", rest);
            }
        }
        return wiring;
    }

    private static List<Integer> numbers(String option, int count, String wanted, Iterator<String> rest) {
        rest.remove();
        String given = rest.hasNext() ? rest.next() : "";
        List<String> numbers = List.of(given.split(",", -1));
        if (numbers.size() != count || !numbers.stream().allMatch(NUMBER.asMatchPredicate())) {
            throw new IllegalArgumentException(option + " takes " + wanted + "; not '" + given + "'");
        }
        rest.remove();
        return numbers.stream().map(Integer::valueOf).toList();
    }

    /**
     * Has the switch tell {@code converter} when it closes, and the lamps show what {@code lamp} does.
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
            List<Output> lamps =
                    lampPins.stream().map(pin -> new Output(opened, pin)).toList();
            lamp.shownBy((daylight, warm) -> {
                lamps.get(0).set(daylight);
                lamps.get(1).set(warm);
            });
        }
    }

    /** Both lamps are dark afterwards. */
    @Override
    public void close() {
        if (pins != null) {
            pins.close();
        }
    }
}
