package org.evoloop.models.device;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToIntFunction;
import org.evoloop.device.DeviceFile;
import org.evoloop.device.DeviceProgram;
import org.evoloop.device.Scenario;
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
        if (!canBeBuilt(file, out)) {
            return 1;
        }
        List<String> check = new ArrayList<>(List.of("check"));
        check.addAll(file.references());
        file.properties().ifPresent(properties -> check.addAll(List.of("--properties", properties.toString())));
        boolean good = file.references().isEmpty() || models.applyAsInt(check) == 0;
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

    private static boolean canBeBuilt(DeviceFile file, PrintStream out) {
        try {
            ConverterHarness.of(file.knowledge(file.models()))
                    .with(file.simulated())
                    .start()
                    .close();
            return true;
        } catch (ModelException unfit) {
            out.println("error: " + unfit.getMessage());
            return false;
        }
    }
}
