package org.evoloop.device.connection;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.Connection;
import org.evoloop.device.FileModels;
import org.evoloop.device.Outward;
import org.evoloop.device.Parts;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.gpio.GpioExecute;
import org.evoloop.gpio.GpioMonitor;
import org.evoloop.gpio.OutputPin;
import org.evoloop.gpio.Pins;
import org.jspecify.annotations.Nullable;

/** Switches and relays on pins, made of a {@link GpioMonitor} and a {@link GpioExecute}. */
final class GpioFileConnection extends Connection {
    private static final Duration PRESS = Duration.ofMillis(200);

    private final Duration debounce;
    private final GpioKind.Source source;
    private final FileModels models;
    private final List<Consumer<GpioMonitor>> contacts = new ArrayList<>();
    private final List<Consumer<GpioExecute>> outputs = new ArrayList<>();
    private final Map<Integer, Use> uses = new HashMap<>();

    private final Map<Integer, OutputPin> lamps = new HashMap<>();
    private boolean tellsState;
    private volatile @Nullable Pins opened;

    /** What a pin is for; several events, or several functions, may use one output. */
    private enum Use {
        CONTACT,
        EVENT,
        LAMP
    }

    /** @param debounce null for the usual one */
    GpioFileConnection(String name, @Nullable Duration debounce, GpioKind.Source source, FileModels models) {
        super(name, "gpio");
        this.debounce = debounce == null ? GpioMonitor.SETTLED : debounce;
        this.source = source;
        this.models = models;
    }

    private OptionalInt pin(Section rule, String key, Use use) {
        rule.require(key);
        Optional<Integer> number = rule.number(key, Pins.LOWEST, Pins.HIGHEST);
        number.ifPresent(pin -> {
            Use before = uses.put(pin, use);
            if (before != null && (before == Use.CONTACT || before != use)) {
                rule.problem("GPIO " + pin + " is used twice; give each a pin of its own");
            }
        });
        return number.map(OptionalInt::of).orElse(OptionalInt.empty());
    }

    @Override
    public void send(Node.Text event, Section how) {
        String form = how.oneOf(List.of("pulse", "hold")).orElse("");
        if (form.equals("pulse")) {
            Duration press = how.period("for").orElse(PRESS);
            pin(how, form, Use.EVENT)
                    .ifPresent(pin -> outputs.add(execute -> execute.pulse(event.value(), pin, press)));
        } else if (form.equals("hold")) {
            boolean high = isHigh(how);
            pin(how, form, Use.EVENT).ifPresent(pin -> outputs.add(execute -> execute.hold(event.value(), pin, high)));
        }
    }

    private static boolean isHigh(Section how) {
        how.require("level");
        return how.value("level", text -> switch (text) {
                    case "high" -> true;
                    case "low" -> false;
                    default -> throw new IllegalArgumentException("'" + text + "' is neither high nor low");
                })
                .orElse(false);
    }

    @Override
    public void state(Section rule) {
        String closed = rule.text("closed").map(models::deviceState).orElse("");
        String open = rule.text("open").map(models::deviceState).orElse("");
        if (closed.isEmpty() && open.isEmpty()) {
            rule.problem(rule.name() + " needs closed or open, the state in which the contact is so");
        }
        contact(rule, (monitor, pin) -> monitor.found(pin, closed, open));
        tellsState = true;
    }

    /** A contact moves while the pulse of an event lasts. */
    @Override
    public boolean tellsWhileSending() {
        return tellsState;
    }

    @Override
    public void does(Section rule) {
        event(rule, models::devicesOwn, GpioMonitor::device);
    }

    @Override
    public void press(Section rule) {
        event(rule, models::pressed, GpioMonitor::controller);
    }

    /** Adds a contact to a monitor. */
    private interface Adding {
        GpioMonitor to(GpioMonitor monitor, int pin, String event);
    }

    private void event(Section rule, Function<Node.Text, String> known, Adding adding) {
        String event = rule.need("event").map(known).orElse("");
        contact(rule, (monitor, pin) -> adding.to(monitor, pin, event));
    }

    private void contact(Section rule, BiConsumer<GpioMonitor, Integer> adding) {
        Duration lasting = rule.duration("debounce").orElse(debounce);
        pin(rule, "contact", Use.CONTACT)
                .ifPresent(pin -> contacts.add(monitor -> {
                    monitor.debounce(lasting);
                    adding.accept(monitor, pin);
                }));
    }

    @Override
    public @Nullable Outward outward(Section action) {
        boolean high = isHigh(action);
        OptionalInt pin = pin(action, "hold", Use.LAMP);
        return pin.isEmpty() ? null : values -> lamp(pin.getAsInt()).set(high);
    }

    private OutputPin lamp(int pin) {
        synchronized (lamps) {
            return lamps.computeIfAbsent(pin, number -> new OutputPin(requireNonNull(opened), number));
        }
    }

    @Override
    protected Parts make(SystemEventConverter converter) throws IOException {
        Pins pins = source.open();
        opened = pins;
        try {
            return on(pins, converter);
        } catch (RuntimeException refused) {
            pins.close();
            throw refused;
        }
    }

    private Parts on(Pins pins, SystemEventConverter converter) {
        GpioMonitor monitor = new GpioMonitor(name(), pins, converter.clock());
        contacts.forEach(each -> each.accept(monitor));
        List<GpioExecute> executes = new ArrayList<>();
        if (!outputs.isEmpty()) {
            GpioExecute execute = new GpioExecute(name() + "Execute", pins, converter.clock());
            outputs.forEach(each -> each.accept(execute));
            executes.add(execute);
        }
        return new Parts(List.of(monitor), executes, null, () -> {}, pins::close);
    }
}
