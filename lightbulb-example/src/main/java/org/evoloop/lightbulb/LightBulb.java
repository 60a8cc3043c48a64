package org.evoloop.lightbulb;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.evoloop.config.Option;
import org.evoloop.config.Settings;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.gpio.GpioMonitor;
import org.evoloop.gpio.OutputPin;
import org.evoloop.gpio.PinOptions;
import org.evoloop.gpio.Pins;
import org.evoloop.program.Program;
import org.evoloop.program.ProgramSetup;

/** A lamp whose firmware knows only {@code switch}, and the converter that gives it a second light with a filter. */
public final class LightBulb {
    static final Option<List<Integer>> SWITCH_PIN =
            PinOptions.pins("switch-pin", "17", "N", "a button between GPIO N and ground is the wall switch, too");
    static final Option<List<Integer>> LAMP_PINS = PinOptions.pins(
            "lamp-pins", "23,24", "A,B", "lamps at GPIO A and GPIO B are the daylight and the warm light");

    private List<OutputPin> realLamps = List.of();
    private boolean on;
    private boolean filtered;

    public static void main(String[] arguments) {
        System.exit(Program.named("lightbulb", "Runs the converter of a lamp whose firmware knows one event, switch.")
                .models("models/light-bulb.xml", LightBulb.class)
                .options(PinOptions.of(List.of(SWITCH_PIN, LAMP_PINS)))
                .converter("lamp", new LightBulb()::assemble)
                .run(arguments));
    }

    private void assemble(ProgramSetup setup) {
        PushMonitor wallSwitch = new PushMonitor("WallSwitch");
        setup.converter().addMonitor(wallSwitch);
        setup.converter().addExecute(execute());
        setup.knowledge(this::knowledge);
        setup.command(ConsoleCommand.press("switch", "operates the wall switch", wallSwitch, words -> "switch"));
        setup.onOpen(() -> open(setup));
    }

    EventExecute execute() {
        return EventExecute.of("LampExecute", Set.of("switch"), step -> change(() -> on = !on));
    }

    StateKnowledge knowledge(ModelPair models) {
        return new StateKnowledge(models) {
            @Override
            protected void registerNewFunctions() {
                timer("wait", "timeout", Duration.ofSeconds(2));
                function("incandescentOn", visit -> {
                    change(() -> filtered = true);
                    visit.onEnd(() -> change(() -> filtered = false));
                });
            }
        };
    }

    private void open(ProgramSetup setup) throws IOException {
        PinOptions.open(setup.settings(), List.of(SWITCH_PIN, LAMP_PINS))
                .ifPresent(pins -> wire(setup.closing(pins), setup.settings(), setup.converter()));
        // A real lamp would still be on if the previous program was killed.
        on = setup.converter().status().states().original().name().equals("on");
        light();
    }

    void wire(Pins pins, Settings settings, SystemEventConverter converter) {
        settings.get(SWITCH_PIN)
                .map(pin -> new GpioMonitor("SwitchPin", pins, converter.clock()).controller(pin.get(0), "switch"))
                .ifPresent(converter::addMonitor);
        realLamps = settings.get(LAMP_PINS).orElse(List.of()).stream()
                .map(pin -> new OutputPin(pins, pin))
                .toList();
    }

    private synchronized void change(Runnable act) {
        act.run();
        light();
        String colour = !on ? "90" : filtered ? "38;5;214" : "97";
        System.out.println(Console.isOnTerminal() ? "\033[" + colour + "m" + this + "\033[0m" : this);
    }

    private void light() {
        for (int lamp = 0; lamp < realLamps.size(); lamp++) {
            realLamps.get(lamp).set(on && filtered == (lamp == 1));
        }
    }

    @Override
    public String toString() {
        return !on ? "( ) dark" : filtered ? "(*) incandescent" : "(*) daylight";
    }
}
