package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart.Semantics;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.dialect.DrawnChart;
import org.evoloop.xmi.dialect.Problems;

/**
 * Writes a chart as an SCXML document. A way through choices and junctions becomes a transition for each branch, one
 * through a fork a transition with several targets.
 *
 * <p>Threading: for one thread.
 */
public final class ScxmlWriter {
    /** What SCXML takes for the id of a state without further ado. */
    private static final Pattern ID = Pattern.compile("[\\p{L}_][\\p{L}\\p{N}_.-]*");

    private static final int MAX_WAYS = 1_000;

    private static final Pattern WHEN = Pattern.compile("when (.*)", Pattern.DOTALL);

    private final DrawnChart chart;
    private final Map<String, String> ids = new HashMap<>();
    private final Set<String> taken = new HashSet<>();
    private int made;
    private final StringBuilder text = new StringBuilder();

    /** A way from a state through pseudostates. */
    private record Way(Arc first, List<String> guards, List<String> effects, List<String> targets) {
        Way through(Arc arc, List<String> ends) {
            return new Way(
                    first,
                    Stream.concat(guards.stream(), Stream.of(arc.guard()))
                            .filter(guard -> !guard.isEmpty())
                            .distinct()
                            .toList(),
                    Stream.concat(effects.stream(), arc.effects().stream()).toList(),
                    ends);
        }

        String guard() {
            List<String> all =
                    guards.stream().filter(guard -> !guard.equals("else")).toList();
            return all.isEmpty() ? (guards.isEmpty() ? "" : "else") : all.get(0);
        }

        /** UML tries those with a guard first, and the branch for all else last. */
        int rank() {
            return guards.isEmpty() ? 1 : guards.get(0).equals("else") ? 2 : 0;
        }
    }

    private ScxmlWriter(DrawnChart chart) {
        this.chart = chart;
    }

    /** What SCXML cannot express, one line each; further differences show when the document is read again. */
    public static List<String> unsayable(DrawnChart chart) {
        List<String> reasons = new ArrayList<>();
        for (Vertex vertex : chart.vertices()) {
            if (vertex instanceof Pseudostate point && !isSayable(point.kind())) {
                reasons.add("SCXML has no " + DrawnChart.label(point));
            } else if (vertex instanceof ChartState state) {
                if (!state.deferred().isEmpty()) {
                    reasons.add("SCXML has no deferred events, and " + DrawnChart.label(state) + " defers "
                            + String.join(", ", state.deferred()));
                }
                if (!state.doActivities().isEmpty()) {
                    reasons.add("SCXML has no name for what " + DrawnChart.label(state) + " does, "
                            + Problems.quote(state.doActivities().get(0)));
                }
                state.internal().forEach(arc -> events(arc, reasons));
            }
        }
        chart.arcs().forEach(arc -> events(arc, reasons));
        chart.unused()
                .forEach(event -> reasons.add(
                        "SCXML has no place for an event that is on no transition, " + Problems.quote(event)));
        return reasons;
    }

    private static boolean isSayable(Kind kind) {
        return switch (kind) {
            case INITIAL, SHALLOW_HISTORY, DEEP_HISTORY, FORK, CHOICE, JUNCTION -> true;
            case JOIN, ENTRY_POINT, EXIT_POINT, TERMINATE -> false;
        };
    }

    private static void events(Arc arc, List<String> reasons) {
        for (String trigger : arc.triggers()) {
            boolean condition = WHEN.matcher(trigger).matches();
            if (!condition && ScxmlEvents.descriptors(trigger).size() != 1 && !ScxmlEvents.isTime(trigger)) {
                reasons.add("SCXML separates events by blanks, and one is called " + Problems.quote(trigger));
            }
        }
    }

    /** The document, whose name is the chart's. */
    public static String write(DrawnChart chart) {
        return new ScxmlWriter(chart).write();
    }

    private String write() {
        List<Region> regions = chart.chart().regions();
        regions.forEach(this::name);
        line(0, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
        line(
                0,
                "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" xmlns:ev=\"urn:evoloop\" version=\"1.0\""
                        + attribute("name", chart.chart().name()) + ">");
        if (regions.size() == 1) {
            region(regions.get(0), 1);
        } else {
            line(1, "<parallel" + attribute("id", free("", "regions")) + ">");
            regions.forEach(region -> child(region, 2));
            line(1, "</parallel>");
        }
        line(0, "</scxml>");
        return text.toString();
    }

    private void name(Region region) {
        for (Vertex vertex : region.vertices()) {
            if (!(vertex instanceof Pseudostate point) || isHistory(point)) {
                ids.put(vertex.key(), free(vertex.name(), vertex instanceof ChartState ? "state" : "final"));
            }
            if (vertex instanceof ChartState state) {
                state.regions().forEach(this::name);
            }
        }
    }

    /** The name if it can be an id that is free, else one with a number. */
    private String free(String name, String otherwise) {
        String id = name.isEmpty() ? otherwise : name;
        while (!ID.matcher(id).matches() || !taken.add(id)) {
            id = otherwise + "." + ++made;
        }
        return id;
    }

    private static boolean isHistory(Vertex vertex) {
        return vertex instanceof Pseudostate point
                && (point.kind() == Kind.SHALLOW_HISTORY || point.kind() == Kind.DEEP_HISTORY);
    }

    /** The contents of a region. */
    private void region(Region region, int depth) {
        for (Vertex vertex : region.vertices()) {
            if (isInitial(vertex)) {
                for (Way way : ways(vertex.key())) {
                    line(depth, "<initial>");
                    transition(way, depth + 1, "");
                    line(depth, "</initial>");
                }
            }
        }
        region.vertices().forEach(vertex -> vertex(vertex, depth));
    }

    private static boolean isInitial(Vertex vertex) {
        return vertex instanceof Pseudostate point && point.kind() == Kind.INITIAL;
    }

    /** A region of a parallel state: its only state, or one around its contents. */
    private void child(Region region, int depth) {
        List<Vertex> others = region.vertices().stream()
                .filter(vertex ->
                        !isInitial(vertex) && !(vertex instanceof Pseudostate point && point.kind() == Kind.FORK))
                .toList();
        boolean plain = region.vertices().stream()
                .filter(ScxmlWriter::isInitial)
                .flatMap(initial -> chart.leaving(initial.key()).stream())
                .allMatch(arc -> arc.effects().isEmpty()
                        && others.stream().anyMatch(vertex -> vertex.key().equals(arc.target())));
        if (others.size() == 1 && others.get(0) instanceof ChartState && plain) {
            vertex(others.get(0), depth);
            return;
        }
        line(depth, "<state" + attribute("id", free(region.name(), "region")) + ">");
        region(region, depth + 1);
        line(depth, "</state>");
    }

    private void vertex(Vertex vertex, int depth) {
        if (vertex instanceof ChartState state) {
            state(state, depth);
        } else if (vertex instanceof FinalState end) {
            line(depth, "<final" + identity(end) + ">");
            int contents = text.length();
            actions("onentry", end.entry(), depth + 1);
            actions("onexit", end.exit(), depth + 1);
            end("final", depth, contents);
        } else if (isHistory(vertex)) {
            boolean deep = ((Pseudostate) vertex).kind() == Kind.DEEP_HISTORY;
            line(depth, "<history" + identity(vertex) + attribute("type", deep ? "deep" : "shallow") + ">");
            int contents = text.length();
            ways(vertex.key()).forEach(way -> transition(way, depth + 1, ""));
            end("history", depth, contents);
        }
    }

    private void state(ChartState state, int depth) {
        boolean parallel = state.regions().size() > 1;
        String element = parallel ? "parallel" : "state";
        line(
                depth,
                "<" + element + identity(state)
                        + attribute("ev:device", state.use().device())
                        + attribute("ev:sends", String.join(" ", state.use().sends())) + ">");
        int contents = text.length();
        actions("onentry", state.entry(), depth + 1);
        actions("onexit", state.exit(), depth + 1);
        List<Way> ways = new ArrayList<>();
        state.internal().forEach(arc -> ways.add(way(arc, List.of(arc.target()))));
        ways.addAll(ways(state.key()));
        if (chart.chart().semantics() == Semantics.UML) {
            ways.sort(Comparator.comparingInt(Way::rank));
        } else {
            ways.sort(Comparator.comparingInt(way -> way.first().order()));
        }
        ways.forEach(way -> transition(way, depth + 1, state.regions().isEmpty() ? "" : state.key()));
        for (Region region : state.regions()) {
            if (parallel) {
                child(region, depth + 1);
            } else {
                region(region, depth + 1);
            }
        }
        end(element, depth, contents);
    }

    /** Ends an element whose contents, if it has any, begin at this index. */
    private void end(String element, int depth, int contents) {
        if (text.length() == contents) {
            text.replace(contents - ">\n".length(), contents, "/>\n");
        } else {
            line(depth, "</" + element + ">");
        }
    }

    private static Way way(Arc arc, List<String> targets) {
        return new Way(arc, List.of(), List.of(), List.of()).through(arc, targets);
    }

    /** Every way that begins at the vertex. */
    private List<Way> ways(String key) {
        List<Way> ways = new ArrayList<>();
        chart.leaving(key).forEach(arc -> follow(way(arc, List.of(arc.target())), Set.of(), ways));
        return ways;
    }

    /** @param passed the choices and junctions on the way, which is not followed in a circle */
    private void follow(Way way, Set<String> passed, List<Way> ways) {
        String end = way.targets().get(0);
        if (ways.size() > MAX_WAYS) {
            throw new ModelException("SCXML needs a transition for each way through choices, and from "
                    + DrawnChart.label(chart.vertex(way.first().source())) + " there are more than " + MAX_WAYS);
        }
        if (!(chart.vertex(end) instanceof Pseudostate point) || isHistory(point) || passed.contains(end)) {
            ways.add(way);
        } else if (point.kind() == Kind.FORK) {
            List<Arc> branches = chart.leaving(end);
            Way forked = way;
            for (Arc branch : branches) {
                forked = forked.through(
                        branch, branches.stream().map(Arc::target).toList());
            }
            ways.add(forked);
        } else {
            Set<String> further = Stream.concat(passed.stream(), Stream.of(end)).collect(Collectors.toSet());
            chart.leaving(end).stream()
                    .map(branch -> way.through(branch, List.of(branch.target())))
                    .sorted(Comparator.comparingInt(Way::rank))
                    .forEach(next -> follow(next, further, ways));
        }
    }

    /** @param done the key of the state whose end a transition without an event waits for; empty if it does not wait */
    private void transition(Way way, int depth, String done) {
        Arc arc = way.first();
        if (way.guards().stream().filter(guard -> !guard.equals("else")).count() > 1) {
            throw new ModelException("SCXML has one condition at a transition, and a way from "
                    + DrawnChart.label(chart.vertex(arc.source())) + " has several, ["
                    + String.join("] [", way.guards()) + "]");
        }
        if (arc.triggers().isEmpty()) {
            element(way, List.of(), depth, done);
        }
        // The attributes are those of all events of a transition.
        arc.triggers().stream()
                .collect(Collectors.groupingBy(arc::keywords, LinkedHashMap::new, Collectors.toList()))
                .values()
                .forEach(alike -> element(way, alike, depth, done));
    }

    private void element(Way way, List<String> triggers, int depth, String done) {
        Arc arc = way.first();
        String event =
                triggers.isEmpty() && !done.isEmpty() ? "done.state." + ids.get(done) : String.join(" ", triggers);
        String guard = way.guard();
        if (WHEN.matcher(event).matches() && guard.isEmpty()) {
            guard = event.substring("when ".length());
            event = "";
        }
        String targets = staysInside(arc)
                ? ""
                : way.targets().stream()
                        .map(target -> ids.getOrDefault(target, target))
                        .collect(Collectors.joining(" "));
        String begin = "<transition" + attribute("event", event) + attribute("cond", guard)
                + attribute("target", targets)
                + (arc.kind() == Arc.Kind.LOCAL && !targets.isEmpty() ? " type=\"internal\"" : "")
                + (arc.spontaneous().containsAll(triggers) && !triggers.isEmpty() ? " ev:spontaneous=\"true\"" : "")
                + (arc.urgent().containsAll(triggers) && !triggers.isEmpty() ? " ev:urgent=\"true\"" : "");
        if (way.effects().isEmpty()) {
            line(depth, begin + "/>");
            return;
        }
        line(depth, begin + ">");
        scripts(way.effects(), depth + 1);
        line(depth, "</transition>");
    }

    /** Whether it leaves nothing: it is internal, or local at a state with nothing in it. */
    private boolean staysInside(Arc arc) {
        return arc.kind() == Arc.Kind.INTERNAL
                || (arc.kind() == Arc.Kind.LOCAL
                        && arc.source().equals(arc.target())
                        && chart.vertex(arc.source()) instanceof ChartState state
                        && state.regions().isEmpty());
    }

    private void actions(String block, List<String> actions, int depth) {
        if (!actions.isEmpty()) {
            line(depth, "<" + block + ">");
            scripts(actions, depth + 1);
            line(depth, "</" + block + ">");
        }
    }

    private void scripts(List<String> actions, int depth) {
        actions.forEach(action -> line(depth, "<script>" + escape(action) + "</script>"));
    }

    /** The id, and the name if that is another. */
    private String identity(Vertex vertex) {
        String id = ids.getOrDefault(vertex.key(), "");
        // An end without a name is called so.
        String name = vertex instanceof FinalState && vertex.name().isEmpty() ? "final" : vertex.name();
        return attribute("id", id) + (name.isEmpty() || name.equals(id) ? "" : attribute("ev:" + ScxmlOwn.NAME, name));
    }

    private static String attribute(String name, String value) {
        return value.isEmpty() ? "" : " " + name + "=\"" + escape(value) + "\"";
    }

    private static String escape(String value) {
        return value.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;")
                .replace("\n", "&#10;")
                .replace("\t", "&#9;")
                .replace("\r", "&#13;");
    }

    private void line(int depth, String content) {
        text.append("  ".repeat(depth)).append(content).append('\n');
    }
}
