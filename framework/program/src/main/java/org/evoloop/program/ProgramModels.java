package org.evoloop.program;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.timing.TimeRules;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelReference;

/**
 * The models of a program, as its files have them.
 *
 * <p>Threading: immutable.
 *
 * @param pair the device's model and the one that its owner wants
 * @param time the time requirements in the properties file beside the new model's; none if there is no such file
 * @param offered the models that can be chosen while the program runs, each as {@code FILE#NAME}
 * @since 0.1
 */
public record ProgramModels(ModelPair pair, TimeRules time, List<String> offered) {

    /** Models of these values. */
    public ProgramModels {
        offered = List.copyOf(offered);
    }

    /**
     * Reads the machines {@code original} and {@code new} of one file, all of whose machines are offered.
     *
     * @throws ModelException if they, or the properties beside them, cannot be used
     */
    public static ProgramModels in(Path file) {
        ModelFile machines = ModelFile.read(file);
        ModelPair pair = new ModelPair(machines.pick("original"), machines.pick("new"));
        return new ProgramModels(pair, time(new ModelReference(file, Optional.of("new")), pair), machines.references());
    }

    /**
     * Reads two machines. All machines in the new model's file are offered.
     *
     * @throws ModelException if they, or the properties beside the new one, cannot be used
     */
    public static ProgramModels of(ModelReference original, ModelReference evolved) {
        ModelPair pair = new ModelPair(original.load(), evolved.load());
        return new ProgramModels(
                pair, time(evolved, pair), ModelFile.read(evolved.file()).references());
    }

    private static TimeRules time(ModelReference evolved, ModelPair pair) {
        Path properties = evolved.beside(PropertyFile.ENDING);
        return Files.exists(properties) ? time(properties, pair) : TimeRules.NONE;
    }

    /**
     * The time requirements in a file of properties.
     *
     * @throws ModelException if it cannot be used
     */
    public static TimeRules time(Path properties, ModelPair pair) {
        try {
            return PropertyFile.parse(properties.toString(), Files.readString(properties), pair)
                    .time();
        } catch (IOException unreadable) {
            throw new ModelException(properties + ": cannot be read: " + unreadable.getMessage(), unreadable);
        }
    }
}
