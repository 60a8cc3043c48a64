package org.evoloop.xmi.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.xmi.dialect.DrawnChart;
import org.evoloop.xmi.dialect.Problems;

/**
 * Writes a chart as a state diagram of Mermaid. A state belongs to the last region that names it there, so a transition
 * between regions is written outside of all of them. An end belongs to the region in whose lines {@code [*]} is.
 *
 * <p>Threading: for one thread.
 */
@SuppressWarnings("ReferenceEquality") // two regions may look alike
public final class MermaidWriter {
    private final DrawnChart chart;
    /** The junctions that only give a transition a further guard. */
    private final Set<String> chained = new HashSet<>();

    private final List<Arc> arcs = new ArrayList<>();
    private final Map<String, String> ids = new HashMap<>();
    private final Set<String> taken = new HashSet<>();
    private final Map<String, Integer> numbers = new HashMap<>();
    /** The transitions to write in each region, those of its start and to its end from deeper states first. */
    private final IdentityHashMap<Region, List<Arc>> first = new IdentityHashMap<>();

    private final IdentityHashMap<Region, List<Arc>> inside = new IdentityHashMap<>();
    private final List<Arc> outside = new ArrayList<>();
    private final StringBuilder text = new StringBuilder();

    private MermaidWriter(DrawnChart chart) {
        this.chart = chart;
        Map<String, Integer> incoming = new HashMap<>();
        chart.arcs().forEach(arc -> incoming.merge(arc.target(), 1, Integer::sum));
        for (Vertex vertex : chart.vertices()) {
            List<Arc> leaving = chart.leaving(vertex.key());
            if (vertex instanceof Pseudostate point
                    && point.kind() == Kind.JUNCTION
                    && incoming.getOrDefault(point.key(), 0) == 1
                    && leaving.size() == 1
                    && leaving.get(0).triggers().isEmpty()) {
                chained.add(point.key());
            }
        }
        for (Arc arc : chart.arcs()) {
            if (!chained.contains(arc.source())) {
                arcs.add(whole(arc));
            }
        }
    }

    /** The transition with what follows it behind junctions that only lengthen it. */
    private Arc whole(Arc arc) {
        Arc whole = arc;
        for (int passed = 0; chained.contains(whole.target()) && passed < chained.size(); passed++) {
            Arc next = chart.leaving(whole.target()).get(0);
            List<String> guards = Stream.of(whole.guard(), next.guard())
                    .filter(guard -> !guard.isEmpty())
                    .toList();
            whole = new Arc(
                    arc.place(),
                    arc.source(),
                    next.target(),
                    arc.triggers(),
                    String.join(Words.BETWEEN_GUARDS, guards),
                    Stream.concat(whole.effects().stream(), next.effects().stream())
                            .toList(),
                    arc.kind(),
                    arc.spontaneous(),
                    arc.urgent(),
                    arc.order());
        }
        return whole;
    }

    /** What Mermaid cannot express, one line each; empty if {@link #write} expresses it all. */
    public static List<String> unsayable(DrawnChart chart) {
        return new MermaidWriter(chart).unsayable();
    }

    private List<String> unsayable() {
        List<String> reasons = new ArrayList<>();
        if (chart.chart().regions().size() > 1) {
            reasons.add("Mermaid has regions in states only; draw a state around those of the machine");
        }
        for (Vertex vertex : chart.vertices()) {
            if (vertex instanceof Pseudostate point && !isSayable(point)) {
                reasons.add("Mermaid has no " + DrawnChart.label(point) + "; PlantUML and SVG have");
            } else if (vertex instanceof FinalState end && !end.name().isEmpty()) {
                reasons.add("Mermaid's [*] has no name, as " + DrawnChart.label(end) + " does; remove the name");
            } else if (vertex instanceof FinalState end
                    && !(end.entry().isEmpty() && end.exit().isEmpty())) {
                reasons.add("in Mermaid nothing happens in a final state; move what it does to the transitions");
            }
        }
        for (Arc arc : arcs) {
            Region end = chart.vertex(arc.target()) instanceof FinalState ? chart.home(arc.target()) : null;
            if (end != null && !chart.isWithin(arc.source(), end)) {
                reasons.add("in Mermaid no transition leads to the end of a region from outside, as one of "
                        + DrawnChart.label(chart.vertex(arc.source())) + " does");
            }
        }
        chart.unused()
                .forEach(event -> reasons.add(
                        "Mermaid has no place for an event that is on no transition, " + Problems.quote(event)));
        return reasons;
    }

    private boolean isSayable(Pseudostate point) {
        Kind kind = point.kind();
        return chained.contains(point.key())
                || kind == Kind.INITIAL
                || kind == Kind.CHOICE
                || kind == Kind.FORK
                || kind == Kind.JOIN;
    }

    /** The text, whose title is the chart's name. */
    public static String write(DrawnChart chart) {
        return new MermaidWriter(chart).write();
    }

    private String write() {
        chart.chart().regions().forEach(this::name);
        distribute();
        line(0, "---");
        line(0, "title: " + title(chart.chart().name()));
        line(0, "---");
        line(0, "stateDiagram-v2");
        regions(chart.chart().regions(), 1);
        outside.forEach(arc -> arc(arc, 1));
        return text.toString();
    }

    private static String title(String name) {
        String plain = name.replaceAll("\\s", " ");
        return plain.matches("[\\p{L}\\p{N}_][\\p{L}\\p{N} _.()-]*")
                ? plain
                : "\"" + plain.replace("\\", "\\\\").replace("\"", "\\\"") + "\"";
    }

    private void name(Region region) {
        for (Vertex vertex : region.vertices()) {
            if (vertex instanceof ChartState || isNamed(vertex)) {
                ids.put(vertex.key(), free(vertex.name(), vertex instanceof ChartState ? "s" : "p"));
            }
            if (vertex instanceof ChartState state) {
                state.regions().forEach(this::name);
            }
        }
    }

    /** The name if it can be an id that is free, else one with a number. */
    private String free(String name, String otherwise) {
        if (Words.isId(name) && taken.add(name)) {
            return name;
        }
        String prefix = Words.isId(name) ? name + "_" : otherwise;
        String id = prefix + numbers.merge(prefix, 1, Integer::sum);
        while (!taken.add(id)) {
            id = prefix + numbers.merge(prefix, 1, Integer::sum);
        }
        return id;
    }

    private boolean isNamed(Vertex vertex) {
        return vertex instanceof Pseudostate point && point.kind() != Kind.INITIAL && !chained.contains(point.key());
    }

    /** Decides where each transition is written. */
    private void distribute() {
        Set<String> leaveTheirRegion = new HashSet<>();
        for (Arc arc : arcs) {
            Region source = chart.home(arc.source());
            Region target = chart.home(arc.target());
            Vertex from = chart.vertex(arc.source());
            boolean start = from instanceof Pseudostate point && point.kind() == Kind.INITIAL;
            boolean end = chart.vertex(arc.target()) instanceof FinalState;
            if (start || (end && source != target)) {
                first.computeIfAbsent(start ? source : target, any -> new ArrayList<>())
                        .add(arc);
            } else if (source == target && (end || !leaveTheirRegion.contains(arc.source()))) {
                inside.computeIfAbsent(source, any -> new ArrayList<>()).add(arc);
            } else {
                // All later ones of this source follow it, since their order counts.
                leaveTheirRegion.add(arc.source());
                outside.add(arc);
            }
        }
    }

    private void regions(List<Region> regions, int depth) {
        for (int i = 0; i < regions.size(); i++) {
            Region region = regions.get(i);
            if (i > 0) {
                line(depth, "--");
            }
            if (!region.name().isEmpty()) {
                line(depth, "%% region " + region.name().replaceAll("\\s", " "));
            }
            first.getOrDefault(region, List.of()).forEach(arc -> arc(arc, depth));
            Set<String> mentioned = new HashSet<>();
            Stream.of(first, inside)
                    .flatMap(all -> all.getOrDefault(region, List.of()).stream())
                    .forEach(arc -> mentioned.addAll(List.of(arc.source(), arc.target())));
            region.vertices().forEach(vertex -> vertex(vertex, mentioned.contains(vertex.key()), depth));
            inside.getOrDefault(region, List.of()).forEach(arc -> arc(arc, depth));
        }
    }

    private void vertex(Vertex vertex, boolean mentioned, int depth) {
        String id = ids.getOrDefault(vertex.key(), "");
        if (vertex instanceof Pseudostate point && !id.isEmpty()) {
            line(depth, "state " + id + " <<" + point.kind().name().toLowerCase(Locale.ROOT) + ">>");
        } else if (vertex instanceof ChartState state) {
            List<String> below = below(state);
            boolean plain =
                    state.name().equals(id) && below.isEmpty() && state.use().isNone();
            String shown = Words.name(state.use().mark(state.name()));
            if (!state.regions().isEmpty()) {
                // Mermaid has no other place for what such a state does.
                String name = shown
                        + below.stream()
                                .map(behavior -> "<br>" + behavior.replace("\"", "#quot;"))
                                .collect(Collectors.joining());
                line(depth, "state " + (plain ? id : "\"" + name + "\" as " + id) + " {");
                regions(state.regions(), depth + 1);
                line(depth, "}");
                return;
            }
            if (!plain) {
                line(depth, "state \"" + shown + "\" as " + id);
            } else if (!mentioned) {
                // Mermaid would look for the contents of "state ID" in the lines below.
                line(depth, id);
            }
            below.forEach(behavior -> line(depth, id + " : " + behavior));
        }
    }

    private static List<String> below(ChartState state) {
        List<String> below = new ArrayList<>();
        state.entry().forEach(behavior -> below.add("entry / " + Words.effect(behavior)));
        state.doActivities().forEach(behavior -> below.add("do / " + Words.effect(behavior)));
        state.exit().forEach(behavior -> below.add("exit / " + Words.effect(behavior)));
        state.deferred().forEach(event -> below.add("defer / " + Words.trigger(event)));
        state.internal().forEach(arc -> below.add(Words.inState(arc)));
        return below;
    }

    private void arc(Arc arc, int depth) {
        String label = Words.label(arc);
        line(depth, end(arc.source()) + " --> " + end(arc.target()) + (label.isEmpty() ? "" : " : " + label));
    }

    private String end(String key) {
        return ids.getOrDefault(key, "[*]");
    }

    private void line(int depth, String content) {
        text.append("    ".repeat(depth)).append(content).append('\n');
    }
}
