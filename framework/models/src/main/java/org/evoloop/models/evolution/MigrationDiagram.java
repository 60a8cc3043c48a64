package org.evoloop.models.evolution;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.ModelPair;
import org.evoloop.migration.Fate;
import org.evoloop.migration.Migration;
import org.evoloop.models.chart.FlatMachineChart;
import org.evoloop.models.diagram.ChartDiagram;
import org.evoloop.models.diagram.Diagram;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.models.diagram.SvgWriter;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** A swap's plan as a picture: the running new model, with the result of the swap in each of its states. */
public final class MigrationDiagram {
    private MigrationDiagram() {}

    public static String write(ModelPair before, ModelPair after, Migration migration) {
        String title = before.evolved().name() + " \u2192 " + after.evolved().name();
        Diagram running = ChartDiagram.of(FlatMachineChart.of(before.evolved()));
        List<Diagram.Node> nodes = running.nodes().stream()
                .map(node -> before.evolved().states().stream()
                        .filter(state -> FlatMachineChart.key(state).equals(node.key()))
                        .findFirst()
                        .map(state -> annotated(node, state, migration, after))
                        .orElse(node))
                .toList();
        return SvgWriter.write(title, List.of(new Diagram(title, nodes, running.edges())));
    }

    private static Diagram.Node annotated(Diagram.Node node, State state, Migration migration, ModelPair after) {
        Set<String> notes = new LinkedHashSet<>();
        FateKind worst = FateKind.MAPS;
        for (Migration.Line line : migration.lines()) {
            if (line.at().evolved().equals(state)) {
                FateKind kind = FateKind.of(line.fate());
                worst = kind.compareTo(worst) > 0 ? kind : worst;
                notes.add(note(line, after));
            }
        }
        Tone tone = worst.tone();
        return new Diagram.Node(
                node.key(), node.shape(), node.name(), List.copyOf(notes), node.children(), tone, node.data());
    }

    private static String note(Migration.Line line, ModelPair after) {
        State device = line.at().original();
        String with = device.equals(line.at().evolved()) ? "" : "device in " + device + ": ";
        if (line.fate() instanceof Fate.Maps maps) {
            String sent =
                    maps.steps().stream().map(step -> step.trigger().name()).collect(Collectors.joining(", "));
            return with + (sent.isEmpty() ? "" : "sends " + sent + " ") + "\u2192 " + after.describe(maps.to());
        } else if (line.fate() instanceof Fate.Waits waits) {
            return with + "waits for "
                    + waits.exits().stream().map(Event::toString).collect(Collectors.joining(" or "));
        }
        return with + "impossible";
    }
}
