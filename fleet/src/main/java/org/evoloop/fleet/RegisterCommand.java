package org.evoloop.fleet;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Registers devices with a fleet. */
@Command(
        name = "register",
        description = "Registers devices with the fleet, in the initial states of their models.",
        mixinStandardHelpOptions = true,
        sortOptions = false)
final class RegisterCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ClusterOptions cluster;

    @Option(names = "--model", required = true, paramLabel = "VERSION", description = "The version of their models.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String model;

    @Parameters(arity = "1..*", paramLabel = "ID", description = "The devices.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private List<String> devices;

    @Override
    public Integer call() throws InterruptedException {
        devices.forEach(device -> ClusterOptions.requireName("a device's id", device));
        cluster.requireModels(model);
        Map<String, byte[]> records = new LinkedHashMap<>();
        devices.forEach(device -> records.put(device, Wire.device(model)));
        cluster.write(Topic.DEVICES, records);
        spec.commandLine().getOut().println(devices.size() + " written; rejected ones are in the dead letters");
        return 0;
    }
}
