package org.evoloop.lightbulb;

import java.nio.file.Path;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.ModelException;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.evoloop.xmi.ModelFiles;
import org.evoloop.xmi.XmiFile;

/** Puts the converter together and runs its console; options: {@code [--models FILE]}. */
public final class Main {
    public static void main(String[] options) {
        try {
            System.exit(run(options));
        } catch (ModelException | IllegalArgumentException problem) {
            System.err.println("error: " + problem.getMessage());
            System.exit(2);
        }
    }

    private static int run(String[] options) {
        if (options.length != 0 && !(options.length == 2 && options[0].equals("--models"))) {
            throw new IllegalArgumentException("usage: java -jar lightbulb-example.jar [--models FILE]");
        }
        Path file = options.length == 2 ? Path.of(options[1]) : ModelFiles.find("models/light-bulb.xml", Main.class);
        XmiFile machines = XmiFile.read(file);
        ModelPair models = new ModelPair(machines.pick("original"), machines.pick("new"));

        Lamp lamp = new Lamp();
        PushMonitor wallSwitch = new PushMonitor("WallSwitch");
        try (Clock clock = new SystemClock()) {
            SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
            converter.addMonitor(wallSwitch);
            converter.addExecute(new LampExecute(lamp));
            converter.addKnowledge(new LampKnowledge(models, lamp));
            converter.build();

            Console console = new Console(converter, System.in, System.out, System.err);
            console.addCommand(ConsoleCommand.of(
                    "switch", "operates the wall switch", (arguments, out) -> wallSwitch.press("switch")));
            return console.run();
        }
    }
}
