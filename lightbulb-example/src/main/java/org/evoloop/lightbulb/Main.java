package org.evoloop.lightbulb;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.Journal;
import org.evoloop.journal.JournalException;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.HomeAssistant;
import org.evoloop.page.Page;
import org.evoloop.page.PageOptions;
import org.evoloop.service.Service;
import org.evoloop.service.ServiceOptions;
import org.evoloop.statemachine.ModelException;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.evoloop.xmi.ModelFiles;
import org.evoloop.xmi.XmiFile;

/** Puts the converter together and runs its console; options: {@code [--models FILE]}, those of a service, the page's and pins. */
public final class Main {
    public static void main(String[] arguments) {
        try {
            System.exit(run(new ArrayList<>(List.of(arguments))));
        } catch (ModelException | JournalException | IllegalArgumentException | IOException problem) {
            System.err.println("error: " + problem.getMessage());
            System.exit(2);
        }
    }

    private static int run(List<String> arguments) throws IOException {
        ServiceOptions unattended = ServiceOptions.takeFrom(arguments);
        PageOptions shown = PageOptions.takeFrom(arguments);
        Wiring wiring = Wiring.takeFrom(arguments);
        boolean modelsNamed = arguments.size() == 2 && arguments.get(0).equals("--models");
        if (!arguments.isEmpty() && !modelsNamed) {
            throw new IllegalArgumentException("usage: java -jar lightbulb-example.jar [--models FILE] "
                    + ServiceOptions.USAGE + " " + PageOptions.USAGE + " " + Wiring.USAGE);
        }
        Path file = modelsNamed ? Path.of(arguments.get(1)) : ModelFiles.find("models/light-bulb.xml", Main.class);
        XmiFile machines = XmiFile.read(file);
        ModelPair models = new ModelPair(machines.pick("original"), machines.pick("new"));

        String mqtt = unattended.mqtt();
        BrokerAddress broker = mqtt == null ? null : BrokerAddress.parse(mqtt, System.getenv());
        Lamp lamp = new Lamp();
        PushMonitor wallSwitch = new PushMonitor("WallSwitch");
        try (Service service = Service.open(unattended);
                Clock clock = new SystemClock();
                wiring) {
            SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
            converter.addMonitor(wallSwitch);
            converter.addExecute(new LampExecute(lamp));
            wiring.connect(converter, lamp, clock);
            converter.addKnowledge(new LampKnowledge(models, lamp));
            Path journal = unattended.journal();
            if (journal != null) {
                converter.journal(Journal.in(journal));
            }
            converter.build();
            lamp.remains(converter.status().states().original().name().equals("on"));

            Console console = new Console(converter, System.in, System.out, System.err);
            console.addCommand(ConsoleCommand.of(
                    "switch", "operates the wall switch", (words, out) -> wallSwitch.press("switch")));
            Page.open(shown, console, System.err);
            if (broker != null) {
                HomeAssistant home = new HomeAssistant(converter, broker).open();
                console.onEnd(reason -> home.close());
            }
            return service.run(console);
        }
    }
}
