package org.evoloop.lightbulb;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.timing.TimeRules;
import org.evoloop.check.timing.TimeWatch;
import org.evoloop.config.Mistakes;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.console.NewModels;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.Journal;
import org.evoloop.journal.JournalException;
import org.evoloop.mqtt.HomeAssistant;
import org.evoloop.mqtt.MqttOptions;
import org.evoloop.page.Page;
import org.evoloop.page.PageOptions;
import org.evoloop.service.ErrorOutput;
import org.evoloop.service.Service;
import org.evoloop.service.ServiceOptions;
import org.evoloop.statemachine.ModelException;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelFiles;
import org.evoloop.xmi.ModelReference;

/** Builds the converter and runs its console. */
public final class Main {
    private static final Option<Path> MODELS = Option.file(
            "models", "FILE", "A file with the machines 'original' and 'new' (default: models/light-bulb.xml).");
    private static final Options OPTIONS = Options.named(
                    "lightbulb",
                    "Runs the converter of a lamp whose firmware knows one event, switch. It reads commands from standard input: type "
                            + "start, then switch (the wall switch; while the lamp is on, twice within 2 s for the second "
                            + "light), status, history, exit; help lists all commands.")
            .and(Options.of(MODELS), ServiceOptions.OPTIONS, PageOptions.OPTIONS, MqttOptions.OPTIONS, Wiring.OPTIONS)
            .checking(Main::check);

    /** Both models, all machines of their file, and the rules about time in the properties file beside it. */
    private record Models(ModelFile machines, ModelPair pair, TimeRules rules) {

        /** @throws ModelException if they cannot be used */
        static Models read(Path file) {
            ModelFile machines = ModelFile.read(file);
            ModelPair pair = new ModelPair(machines.pick("original"), machines.pick("new"));
            Path properties = new ModelReference(file, Optional.of("new")).beside(PropertyFile.ENDING);
            try {
                return new Models(
                        machines,
                        pair,
                        Files.exists(properties)
                                ? PropertyFile.parse(properties.toString(), Files.readString(properties), pair)
                                        .time()
                                : TimeRules.NONE);
            } catch (IOException unreadable) {
                throw new ModelException(properties + ": cannot be read: " + unreadable.getMessage(), unreadable);
            }
        }
    }

    /** What a start would refuse, but for what only devices, and other programs, can tell. */
    private static void check(Settings settings, Mistakes mistakes) {
        if (!settings.isOnlyShown() && settings.get(MODELS).isEmpty()) {
            return;
        }
        ModelPair models = mistakes.tried("models", Main::isUsersMistake, () -> {
            ModelPair read = Models.read(file(settings)).pair();
            if (settings.isOnlyShown()) {
                try (Clock clock = new SystemClock();
                        SystemEventConverter converter = LampConverter.of(
                                read, new PushMonitor("WallSwitch"), new Lamp(), ServiceOptions.of(settings), clock)) {
                    converter.build();
                }
            }
            return read;
        });
        Path journal = ServiceOptions.of(settings).journal();
        if (settings.isOnlyShown() && models != null && journal != null) {
            mistakes.tried("journal", Main::isUsersMistake, () -> {
                Journal.in(journal).check(models);
                return journal;
            });
        }
    }

    private static boolean isUsersMistake(Exception problem) {
        return problem instanceof ModelException
                || problem instanceof JournalException
                || problem instanceof IllegalArgumentException;
    }

    private static Path file(Settings settings) {
        return settings.get(MODELS).orElseGet(() -> ModelFiles.find("models/light-bulb.xml", Main.class));
    }

    public static void main(String[] arguments) {
        try {
            System.exit(run(OPTIONS.read(List.of(arguments), System.getenv())));
        } catch (ModelException | JournalException | IllegalArgumentException | IOException problem) {
            ErrorOutput.stream().println("error: " + problem.getMessage());
            System.exit(2);
        }
    }

    private static int run(Settings settings) throws IOException {
        OptionalInt answered = settings.answer(System.out, System.err);
        if (answered.isPresent()) {
            return answered.getAsInt();
        }
        ServiceOptions unattended = ServiceOptions.of(settings);
        Path file = file(settings);
        Models read = Models.read(file);
        ModelPair models = read.pair();

        Lamp lamp = new Lamp();
        PushMonitor wallSwitch = new PushMonitor("WallSwitch");
        try (Service service = Service.open(unattended);
                Clock clock = new SystemClock();
                Wiring wiring = new Wiring(settings)) {
            SystemEventConverter converter = LampConverter.of(models, wallSwitch, lamp, unattended, clock);
            wiring.connect(converter, lamp, clock);
            converter.watch((running, at, nanos) ->
                    running.equals(models) ? new TimeWatch(read.rules(), running, at, nanos) : null);
            Path journal = unattended.journal();
            if (journal != null) {
                converter.journal(Journal.in(journal));
            }
            converter.build();
            lamp.remains(converter.status().states().original().name().equals("on"));

            Console console = new Console(converter, System.in, System.out, System.err);
            console.addCommand(ConsoleCommand.of(
                    "switch", "operates the wall switch", (words, out) -> wallSwitch.press("switch")));
            console.evolvesBy(NewModels.offering(read.machines().references(), ModelFile::machine));
            Page.open(PageOptions.of(settings), console, System.err);
            MqttOptions.broker(settings).ifPresent(broker -> {
                HomeAssistant home = new HomeAssistant(console, broker).open();
                console.onEnd(reason -> home.close());
            });
            return service.run(console);
        }
    }
}
