package org.evoloop.models.record;

import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.DryRun;
import org.evoloop.journal.DryRun.Broken;
import org.evoloop.models.chart.FlatMachineChart;
import org.evoloop.models.diagram.ChartDiagram;
import org.evoloop.models.diagram.Diagram;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.models.diagram.SvgWriter;
import org.evoloop.models.diagram.Table;
import org.evoloop.rehearsal.Difference;
import org.evoloop.rehearsal.Verdict;
import org.evoloop.statemachine.State;

/**
 * A replay as a picture: the other new model, with the decisions that differed noted in its states. A table below lists
 * both decisions for each event.
 */
public final class ReplayDiagram {
    private static final int MOST_NOTES = 6;
    private static final int MOST_ROWS = 200;
    private static final String ARROW = " \u2192 ";

    /** A table row with its time, by which the rows are sorted. */
    private record Line(Instant at, Table.Row row) {}

    private ReplayDiagram() {}

    /**
     * Draws the picture.
     *
     * @param pair the other models
     * @param file the properties that were watched
     */
    public static String write(ModelPair pair, DryRun.Result result, PropertyFile file, ZoneId zone) {
        String title = pair.evolved().name();
        Diagram machine = ChartDiagram.of(FlatMachineChart.of(pair.evolved()));
        List<Diagram.Node> nodes = machine.nodes().stream()
                .map(node -> pair.evolved().states().stream()
                        .filter(state -> FlatMachineChart.key(state).equals(node.key()))
                        .findFirst()
                        .map(state -> annotated(node, state, result))
                        .orElse(node))
                .toList();
        Diagram diagram = new Diagram(title, nodes, machine.edges());
        return SvgWriter.write(title, List.of(diagram), table(result, ReplayText.sum(result, file), zone));
    }

    private static Diagram.Node annotated(Diagram.Node node, State state, DryRun.Result result) {
        Map<String, Integer> counts = new LinkedHashMap<>();
        for (Difference each : result.differences()) {
            Verdict now = each.other();
            if (now != null && now.before().evolved().equals(state)) {
                counts.merge(note(each, now), 1, Integer::sum);
            }
        }
        List<String> notes = new ArrayList<>();
        counts.forEach((note, count) -> notes.add(note + (count == 1 ? "" : " (" + count + " times)")));
        boolean breaks = false;
        for (Broken each : result.broken()) {
            if (each.where().evolved().equals(state)) {
                breaks = true;
                notes.add(0, "breaks: " + each.property().name());
            }
        }
        Tone tone = breaks ? Tone.BROKEN : notes.isEmpty() ? Tone.PLAIN : Tone.OTHERWISE;
        List<String> shown = notes.size() <= MOST_NOTES ? notes : new ArrayList<>(notes.subList(0, MOST_NOTES));
        if (notes.size() > MOST_NOTES) {
            shown.add("and " + (notes.size() - MOST_NOTES) + " more, see below");
        }
        return new Diagram.Node(node.key(), node.shape(), node.name(), shown, node.children(), tone, node.data());
    }

    private static String note(Difference difference, Verdict now) {
        Verdict then = difference.recorded();
        return difference.occurrence().label()
                + ARROW
                + now.after().evolved()
                + (then == null
                        ? ", was no timer"
                        : ", was" + ARROW + then.after().evolved());
    }

    private static Table table(DryRun.Result result, String caption, ZoneId zone) {
        List<Line> lines = new ArrayList<>();
        for (Difference each : result.differences()) {
            String event = each.occurrence().toString();
            List<String> cells = List.of(ReplayText.time(each.at(), zone), event, each.then(), each.now());
            lines.add(new Line(each.at(), new Table.Row(Tone.OTHERWISE, cells)));
        }
        for (Broken each : result.broken()) {
            String breaks = "breaks '" + each.property().name() + "' in " + each.where();
            List<String> cells = List.of(ReplayText.time(each.at(), zone), each.by(), "", breaks);
            lines.add(new Line(each.at(), new Table.Row(Tone.BROKEN, cells)));
        }
        lines.sort(Comparator.comparing(Line::at));
        List<Table.Row> rows = new ArrayList<>();
        lines.stream().limit(MOST_ROWS).forEach(line -> rows.add(line.row()));
        if (lines.size() > MOST_ROWS) {
            String more = "and " + (lines.size() - MOST_ROWS) + " more";
            rows.add(new Table.Row(Tone.PLAIN, List.of(more, "", "", "--format text lists all")));
        }
        return new Table(caption, List.of("time", "event", "then: as recorded", "now: by the other models"), rows);
    }
}
