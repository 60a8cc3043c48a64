package org.evoloop.models.device;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import org.evoloop.device.DeviceFile;
import org.evoloop.device.DeviceProgram;
import org.evoloop.device.HomeSection;
import org.evoloop.device.Scenario;
import org.evoloop.mqtt.home.HomeTable;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.testkit.ConverterHarness;

/** Checks all of a device file that can be known without the device. */
final class DeviceCheck {
    private DeviceCheck() {}

    /**
     * Checks the models by their rules and properties, whether a converter can be built of them, and the scenarios.
     *
     * @param out for the results, a line for each scenario
     * @param models runs a command for models
     * @throws org.evoloop.config.ConfigException if the file's options do not go together
     * @return the exit status: 0 nothing is wrong, 1 a rule is broken or a scenario fails
     */
    static int run(Path path, PrintStream out, ToIntFunction<List<String>> models) {
        DeviceFile file = DeviceFile.read(path, DeviceProgram.options());
        DeviceProgram.options().read(List.of(), file.options(), System.getenv());
        List<String> check = new ArrayList<>(List.of("check"));
        check.addAll(file.references());
        file.properties().ifPresent(properties -> check.addAll(List.of("--properties", properties.toString())));
        // First, since it names the place in a model of what keeps a converter from being built.
        boolean good = file.references().isEmpty() || models.applyAsInt(check) == 0;
        Set<Event> controllerEvents = controllerEvents(file, out).orElse(null);
        if (controllerEvents == null) {
            return 1;
        }
        if (file.references().isEmpty() && file.scenarios().isEmpty()) {
            out.println("the wiring is right; there are neither models nor scenarios to check");
        }
        for (HomeSection.Table table : file.home().tables(file.models(), controllerEvents)) {
            good &= isAsItSays(table, path, out);
        }
        for (Scenario scenario : file.scenarios()) {
            String failure = scenario.run(file);
            out.println((failure.isEmpty() ? "passed: " : "FAILED: ") + scenario.name());
            if (!failure.isEmpty()) {
                good = false;
                out.println("  at:   " + path + ":" + failure);
            }
        }
        return good ? 0 : 1;
    }

    /** Prints what the commands of an entity do; whether none would do something else than its name says. */
    private static boolean isAsItSays(HomeSection.Table entity, Path path, PrintStream out) {
        List<HomeTable.Row> rows = entity.table().rows();
        out.println(entity.name() + " in Home Assistant:");
        String columns = "  %-" + width(rows, HomeTable.Row::state) + "s  %-" + width(rows, HomeTable.Row::shown)
                + "s  %-" + width(rows, HomeTable.Row::command) + "s  %s%n";
        for (HomeTable.Row row : rows) {
            out.printf(columns, row.state(), row.shown(), row.command(), row.text());
        }
        List<HomeTable.Row> wrong = rows.stream()
                .filter(row -> row.deed() == HomeTable.Deed.OTHERWISE)
                .toList();
        for (HomeTable.Row row : wrong) {
            out.println("  finding: " + path + ":" + entity.line() + ": " + entity.name() + ", " + row);
        }
        if (!wrong.isEmpty()) {
            out.println("  fix: refuse it there with never-in, or let it pass with may-pass");
        }
        return wrong.isEmpty();
    }

    private static int width(List<HomeTable.Row> rows, Function<HomeTable.Row, String> column) {
        return rows.stream().map(column).mapToInt(String::length).max().orElse(0) + 1;
    }

    /** The events that a controller may raise; empty if no converter can be built. */
    private static Optional<Set<Event>> controllerEvents(DeviceFile file, PrintStream out) {
        try (ConverterHarness converter = ConverterHarness.of(file.knowledge(file.models()))
                .with(file.simulated())
                .with(file.controller("Controls"))
                .start()) {
            return Optional.of(converter.converter().controllerEvents());
        } catch (ModelException unfit) {
            out.println("error: " + unfit.getMessage());
            return Optional.empty();
        }
    }
}
