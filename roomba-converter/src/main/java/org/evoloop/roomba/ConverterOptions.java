package org.evoloop.roomba;

import java.nio.file.Path;
import java.time.Duration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelFiles;
import org.evoloop.xmi.ModelReference;
import org.evoloop.xmi.XmiFile;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The options of the command line that choose how the converter works. */
final class ConverterOptions {
    @Option(
            names = "--models",
            paramLabel = "FILE",
            description = "XMI file with the diagrams 'original' and 'new' (default: models/cleaning-robot.xml).")
    private @Nullable Path models;

    @Option(
            names = "--original",
            paramLabel = "FILE#NAME",
            description = "The device's model, by diagram name, machine name or id; with --new, instead of --models.")
    private @Nullable String original;

    @Option(
            names = "--new",
            paramLabel = "FILE#NAME",
            description = "The model that the owner wants; with --original, instead of --models.")
    private @Nullable String evolved;

    @Option(
            names = "--start-point",
            paramLabel = "X,Y",
            split = ",",
            defaultValue = "1000,500",
            description =
                    "Where Move drives to, in mm ahead and to the left of where the robot stands when the program "
                            + "starts (default: ${DEFAULT-VALUE}).")
    private double[] startPoint = {};

    @Option(
            names = "--spot-wait",
            paramLabel = "SECONDS",
            defaultValue = "5",
            description = "How long SpotWait waits for a second press (default: ${DEFAULT-VALUE}).")
    private double spotWaitSeconds;

    /**
     * The options, with the models read.
     *
     * @throws ModelException if a model cannot be used
     * @throws IllegalArgumentException if options are out of range or contradict each other
     */
    RoombaConverter.Options read() {
        if (startPoint.length != 2 || !Double.isFinite(startPoint[0]) || !Double.isFinite(startPoint[1])) {
            throw new IllegalArgumentException("--start-point takes two numbers, X,Y in mm, for example 1000,500");
        }
        if (!(spotWaitSeconds >= 0.1 && spotWaitSeconds <= 3600)) {
            throw new IllegalArgumentException(
                    "--spot-wait is " + spotWaitSeconds + ", allowed is 0.1 to 3600 seconds");
        }
        return new RoombaConverter.Options(
                pair(),
                StartPointSensor.byWheels(startPoint[0], startPoint[1]),
                MoveOptions.defaults(),
                Duration.ofMillis(Math.round(spotWaitSeconds * 1000)));
    }

    private ModelPair pair() {
        String originalReference = original;
        String evolvedReference = evolved;
        Path named = models;
        if (originalReference == null && evolvedReference == null) {
            Path file = named == null ? ModelFiles.find("models/cleaning-robot.xml", ConverterOptions.class) : named;
            XmiFile read = XmiFile.read(file);
            return new ModelPair(named(read.pick("original"), file), named(read.pick("new"), file));
        }
        if (originalReference == null || evolvedReference == null || named != null) {
            throw new IllegalArgumentException(
                    "--original and --new go together, and not with --models; give both or neither");
        }
        ModelReference from = ModelReference.parse(originalReference);
        ModelReference to = ModelReference.parse(evolvedReference);
        return new ModelPair(named(from.load(), from.file()), named(to.load(), to.file()));
    }

    /** The machine under a name that tells its file as well, for messages. */
    private static StateMachine named(StateMachine machine, Path file) {
        return machine.withName(file + "#" + machine.name());
    }
}
