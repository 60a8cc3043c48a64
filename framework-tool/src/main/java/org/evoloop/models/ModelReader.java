package org.evoloop.models;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.models.checking.Drawing;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.xmi.ModelReference;
import org.evoloop.xmi.XmiFile;
import org.evoloop.xmi.XmiMachine;

/** Reads what the command line names. */
final class ModelReader {
    private ModelReader() {}

    /**
     * The machine that {@code reference} names, or all of the file's.
     *
     * @throws ModelException if the file or one of these machines cannot be read; the message names all that is wrong
     */
    static List<Statechart> charts(String reference) {
        ModelReference named = ModelReference.parse(reference);
        if (named.machine().isPresent()) {
            return List.of(named.find().statechart());
        }
        XmiFile file = XmiFile.read(named.file());
        if (file.machines().isEmpty()) {
            return List.of(file.findOnly().statechart());
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
        if (!problems.isEmpty()) {
            throw new ModelException(String.join("\n", problems));
        }
        return charts;
    }

    /** What the simple states of a machine do while they last and when they are entered or left, as drawn. */
    static Map<State, List<String>> activities(String reference) {
        Statechart chart = ModelReference.parse(reference).find().statechart();
        ChartIndex index = new ChartIndex(chart);
        Map<State, List<String>> activities = new HashMap<>();
        for (ChartState state : index.states()) {
            activities.put(
                    new State(index.name(state.key())),
                    Stream.of(state.entry(), state.doActivities(), state.exit())
                            .flatMap(List::stream)
                            .toList());
        }
        return activities;
    }

    /** The machine that {@code reference} names, to find places in. */
    static Drawing drawing(String reference) {
        ModelReference named = ModelReference.parse(reference);
        return new Drawing(named.file().toString(), named.find().statechart());
    }

    /** The two machines of an evolution, flat; whether they are one is for others to say. */
    static ModelPair pair(String original, String evolved) {
        return new ModelPair(
                ModelReference.parse(original).load(),
                ModelReference.parse(evolved).load());
    }
}
