package org.evoloop.device;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Problems;
import org.evoloop.device.file.Section;
import org.evoloop.evolution.ModelPair;
import org.evoloop.program.ProgramModels;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;

/**
 * The models of a device file.
 *
 * @param known null if the file names none, or they cannot be used
 * @param references the original and the new model; none if the file names none
 * @param properties the file of the new model's properties; null if the file names none
 */
record ModelReader(
        @Nullable ModelPair known,
        List<ModelReference> references,
        @Nullable Path properties) {
    /** Reads the section {@code models} of {@code file}. */
    static ModelReader read(Section file, Problems problems) {
        Section models = file.section("models").orElse(null);
        if (models == null) {
            return new ModelReader(null, List.of(), null);
        }
        Optional<Node.Text> original = models.need("original");
        Optional<Node.Text> evolved = models.need("new");
        Optional<Node.Text> properties = models.text("properties");
        models.done();
        StateMachine drawn =
                original.map(reference -> machine(reference, problems)).orElse(null);
        StateMachine wanted =
                evolved.map(reference -> machine(reference, problems)).orElse(null);
        if (drawn == null || wanted == null) {
            // What names could be right is not known.
            problems.throwIfAny();
            throw new IllegalStateException("a problem is missing");
        }
        ModelPair pair = new ModelPair(drawn, wanted);
        try {
            pair.requireValid();
        } catch (ModelException invalid) {
            models.problem(String.valueOf(invalid.getMessage()));
        }
        return new ModelReader(
                pair,
                List.of(
                        reference(original.orElseThrow(), problems.file()),
                        reference(evolved.orElseThrow(), problems.file())),
                properties.map(written -> properties(written, pair, problems)).orElse(null));
    }

    /** Read already now, so that what is wrong in it is said beside what is wrong in the device file. */
    private static Path properties(Node.Text written, ModelPair pair, Problems problems) {
        Path properties = problems.file().resolveSibling(written.value());
        if (!Files.isRegularFile(properties)) {
            problems.at(written, "there is no file " + written.value() + " of properties beside this file");
            return properties;
        }
        try {
            ProgramModels.time(properties, pair);
        } catch (ModelException unusable) {
            problems.at(written, String.valueOf(unusable.getMessage()));
        }
        return properties;
    }

    private static @Nullable StateMachine machine(Node.Text reference, Problems problems) {
        try {
            return reference(reference, problems.file()).load();
        } catch (ModelException | IllegalArgumentException unusable) {
            problems.at(reference, String.valueOf(unusable.getMessage()));
            return null;
        }
    }

    private static ModelReference reference(Node.Text written, Path file) {
        return ModelReference.parse(file.resolveSibling(written.value()).toString());
    }
}
