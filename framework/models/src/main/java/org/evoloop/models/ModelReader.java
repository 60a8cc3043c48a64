package org.evoloop.models;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.Drawing;
import org.evoloop.statechart.Statechart;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelReference;
import org.evoloop.xmi.XmiMachine;
import picocli.CommandLine.Model.CommandSpec;

/** Reads the models named on the command line. */
final class ModelReader {
    private ModelReader() {}

    /**
     * Machines as drawn.
     *
     * @param notes one message for each thing the author should know
     * @param problems one message for each machine that cannot be read
     */
    record Drawn(List<Statechart> charts, List<String> notes, List<String> problems) {}

    /**
     * The machine that {@code reference} names, or all machines of the file.
     *
     * @throws ModelException if the file or the machine cannot be read
     */
    static Drawn drawn(String reference) {
        ModelReference named = ModelReference.parse(reference);
        if (named.machine().isPresent()) {
            return only(named.find());
        }
        ModelFile file = ModelFile.read(named.file());
        if (file.machines().isEmpty()) {
            return only(file.findOnly());
        }
        List<Statechart> charts = new ArrayList<>();
        List<String> notes = new ArrayList<>();
        List<String> problems = new ArrayList<>();
        for (XmiMachine machine : file.machines()) {
            try {
                charts.add(machine.statechart());
                notes.addAll(machine.notes());
            } catch (ModelException unusable) {
                problems.add(unusable.getMessage());
            }
        }
        return new Drawn(charts, notes, problems);
    }

    private static Drawn only(XmiMachine machine) {
        return new Drawn(List.of(machine.statechart()), machine.notes(), List.of());
    }

    /** The flat machine that {@code reference} names. Notes for its author are printed by {@code command}. */
    static StateMachine flat(ModelReference reference, CommandSpec command) {
        XmiMachine machine = reference.find();
        StateMachine flat = machine.toStateMachine();
        machine.notes().forEach(note -> Output.note(command, note));
        return flat;
    }

    /**
     * The drawing of the machine that {@code reference} names, to locate its elements.
     *
     * @param machine the same machine in the pair
     */
    static Drawing drawing(ModelReference reference, StateMachine machine) {
        XmiMachine found = reference.find();
        return new Drawing(reference.file().toString(), found.statechart(), found.flattening(), machine);
    }

    /** Reads both machines of an evolution and flattens them. Whether they are a valid pair is not checked here. */
    static ModelPair pair(ModelReference original, ModelReference evolved, CommandSpec command) {
        return new ModelPair(flat(original, command), flat(evolved, command));
    }
}
