package org.evoloop.device;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.DeviceLink;
import org.evoloop.mqtt.MqttOptions;
import org.evoloop.mqtt.home.HomeSetting;
import org.evoloop.page.PageOptions;
import org.evoloop.program.Program;
import org.evoloop.program.ProgramModels;
import org.evoloop.program.ProgramSetup;
import org.evoloop.service.ServiceOptions;
import org.evoloop.statemachine.Event;
import org.evoloop.testkit.SimulatedDevice;

/**
 * Runs a device file as a program, with the options that every program has.
 *
 * <p>Threading: {@link #run} is for the process's main thread.
 *
 * @since 0.1
 */
public final class DeviceProgram {
    private static final Option<Boolean> SIMULATE = Option.flag(
            "simulate",
            "Plays the device by its model, or by a simulation that a connection has, and opens no other connection.");

    private final DeviceFile file;

    private DeviceProgram(DeviceFile file) {
        this.file = file;
    }

    /** The options that a device file may have, as every program has them. */
    public static Options options() {
        return ServiceOptions.OPTIONS.and(PageOptions.OPTIONS, MqttOptions.OPTIONS);
    }

    /**
     * Runs the file's converter until it ends.
     *
     * @param arguments the options on the command line, which win over the file's
     * @return the exit status for the process
     * @throws org.evoloop.device.file.DeviceFileException with all mistakes in the file
     */
    public static int run(Path path, List<String> arguments) {
        return program(DeviceFile.read(path, options())).run(arguments.toArray(String[]::new));
    }

    /**
     * Prints how it is used.
     *
     * @return the exit status for the process
     */
    public static int help() {
        return Program.named("evoloop run FILE.yaml", "Runs the converter of a device file.")
                .options(Options.of(SIMULATE))
                .run("--help");
    }

    private static Program program(DeviceFile file) {
        ProgramModels models = file.programModels();
        return Program.named(file.name(), "Runs the converter of the device file " + file.path() + ".")
                .models(() -> models)
                .options(Options.of(SIMULATE))
                .options(file.options())
                .converter(file.name(), new DeviceProgram(file)::assemble);
    }

    private void assemble(ProgramSetup setup) throws IOException {
        setup.controller(file.controller("Console"));
        Reload reload = new Reload(file, setup.converter(), open(setup));
        setup.command(reload.command());
        setup.knowledge(reload::knowledge);
        List<HomeSetting> settings = file.day().addTo(setup.converter());
        setup.home(home -> {
            file.home().addTo(home);
            settings.forEach(home::setting);
        });
    }

    /** Adds what is at the other end; the links that were added. */
    private List<DeviceLink> open(ProgramSetup setup) throws IOException {
        List<DeviceLink> links;
        // What is only shown touches no device.
        if (setup.settings().isOnlyShown()) {
            links = play(setup);
        } else if (setup.settings().isOn(SIMULATE)) {
            // With what a connection has as a simulation, else by the model.
            links = Wiring.simulate(file, setup.converter(), parts -> add(parts, setup))
                    .orElseGet(() -> play(setup));
        } else {
            MqttOptions.broker(setup.settings())
                    .map(broker -> broker.id(file.name()))
                    .ifPresent(id -> file.connections().forEach(connection -> connection.shownAs(id)));
            links = Wiring.add(file, setup.converter(), parts -> add(parts, setup));
            if (file.isNeverAsked()) {
                setup.command(FoundMonitor.command(setup.converter()));
            }
        }
        file.guards().attach(setup.clock(), links);
        return links;
    }

    private List<DeviceLink> play(ProgramSetup setup) {
        SimulatedDevice device = file.simulated();
        device.addTo(setup.converter(), setup.clock());
        Set<Event> own = file.devicesOwn();
        setup.command(ConsoleCommand.naming(
                "device EVENT",
                "what the simulated device does by itself",
                () -> own,
                (event, more) -> device.acts(event)));
        setup.onOpen(
                () -> device.put(setup.converter().status().states().original().name()));
        return List.of();
    }

    private static void add(Parts parts, ProgramSetup setup) {
        setup.closing(parts.close()::run);
        setup.onOpen(parts.open()::open);
        parts.commands().forEach(setup::command);
    }
}
