package org.evoloop.models;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.Drawing;
import org.evoloop.statechart.Statechart;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelReference;
import org.evoloop.xmi.XmiFile;
import org.evoloop.xmi.XmiMachine;

/** Reads what the command line names. */
final class ModelReader {
    private ModelReader() {}

    /**
     * Machines as drawn.
     *
     * @param problems of the machines that cannot be read, a message each
     */
    record Drawn(List<Statechart> charts, List<String> problems) {}

    /**
     * The machine that {@code reference} names, or all of the file's.
     *
     * @throws ModelException if the file or the machine cannot be read
     */
    static Drawn drawn(String reference) {
        ModelReference named = ModelReference.parse(reference);
        if (named.machine().isPresent()) {
            return new Drawn(List.of(named.find().statechart()), List.of());
        }
        XmiFile file = XmiFile.read(named.file());
        if (file.machines().isEmpty()) {
            return new Drawn(List.of(file.findOnly().statechart()), List.of());
        }
        List<Statechart> charts = new ArrayList<>();
        List<String> problems = new ArrayList<>();
        for (XmiMachine machine : file.machines()) {
            try {
                charts.add(machine.statechart());
            } catch (ModelException unusable) {
                problems.add(unusable.getMessage());
            }
        }
        return new Drawn(charts, problems);
    }

    /**
     * The machine that {@code reference} names, to find places in.
     *
     * @param machine what the pair made of it
     */
    static Drawing drawing(String reference, StateMachine machine) {
        ModelReference named = ModelReference.parse(reference);
        XmiMachine found = named.find();
        return new Drawing(named.file().toString(), found.statechart(), found.flattening(), machine);
    }

    /** The two machines of an evolution, flat; whether they are one is for others to say. */
    static ModelPair pair(String original, String evolved) {
        return new ModelPair(
                ModelReference.parse(original).load(),
                ModelReference.parse(evolved).load());
    }
}
