package org.evoloop.models;

import java.util.List;
import org.evoloop.models.chart.FlatChart;
import org.evoloop.statechart.Statechart;
import org.evoloop.xmi.ModelReference;
import org.evoloop.xmi.XmiFile;

/** Reads what the command line names. */
final class ModelReader {
    private ModelReader() {}

    /** The machine that {@code reference} names, or all of the file's. */
    static List<Statechart> charts(ModelReference reference) {
        if (reference.machine().isPresent()) {
            return List.of(FlatChart.of(reference.load()));
        }
        return XmiFile.read(reference.file()).machines().stream()
                .map(machine -> FlatChart.of(machine.toStateMachine()))
                .toList();
    }
}
