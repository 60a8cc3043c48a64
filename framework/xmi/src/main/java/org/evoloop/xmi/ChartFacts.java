package org.evoloop.xmi;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.statemachine.ModelException;
import org.jspecify.annotations.Nullable;

/**
 * What a chart says, without its places in the file and without an order, to compare it before and after an edit. States
 * are called by their names, or by their keys where several have one name.
 */
final class ChartFacts {
    static final ChartFacts NONE = new ChartFacts(List.of(), List.of(), Map.of());

    private final Set<StateFact> states;
    private final Map<ArcFact, Integer> arcs;
    /** The lines of the transitions. */
    private final Map<ArcFact, Set<Integer>> lines;

    /** @param behavior all that it does, as text */
    private record StateFact(String name, String parent, int region, DeviceUse use, String behavior) {}

    private record ArcFact(
            String source, String target, List<String> triggers, String guard, List<String> effects, Arc.Kind kind) {}

    private ChartFacts(Iterable<StateFact> states, List<ArcFact> arcs, Map<ArcFact, Set<Integer>> lines) {
        this.states = new HashSet<>();
        states.forEach(this.states::add);
        this.arcs = new HashMap<>();
        arcs.forEach(arc -> this.arcs.merge(arc, 1, Integer::sum));
        this.lines = lines;
    }

    static ChartFacts of(Statechart chart) {
        return new Reading(chart).facts();
    }

    private static final class Reading {
        private final List<StateFact> states = new ArrayList<>();
        private final List<ArcFact> arcs = new ArrayList<>();
        private final Map<ArcFact, Set<Integer>> lines = new HashMap<>();
        private final Map<String, Integer> uses = new HashMap<>();
        private final Map<String, String> labels = new HashMap<>();
        private final Statechart chart;

        Reading(Statechart chart) {
            this.chart = chart;
        }

        ChartFacts facts() {
            count(chart.regions());
            label(chart.regions(), "");
            states(chart.regions(), "");
            return new ChartFacts(states, arcs, lines);
        }

        private void count(List<Region> regions) {
            regions.forEach(region -> region.vertices().forEach(vertex -> {
                if (vertex instanceof ChartState state) {
                    uses.merge(state.name(), 1, Integer::sum);
                    count(state.regions());
                }
            }));
        }

        private void label(List<Region> regions, String parent) {
            for (int i = 0; i < regions.size(); i++) {
                for (Vertex vertex : regions.get(i).vertices()) {
                    if (vertex instanceof ChartState state) {
                        boolean unique = uses.getOrDefault(state.name(), 0) == 1;
                        labels.put(state.key(), unique ? state.name() : state.key());
                        state.connections().forEach(point -> labels.put(point.key(), point.name()));
                        label(state.regions(), label(state.key()));
                    } else if (vertex instanceof Pseudostate point && isNamed(point)) {
                        labels.put(point.key(), point.key());
                    } else {
                        String kind = vertex instanceof Pseudostate point
                                ? point.kind().name()
                                : "FINAL";
                        labels.put(vertex.key(), kind + " in region " + i + " of " + parent);
                    }
                }
            }
        }

        private static boolean isNamed(Pseudostate point) {
            return point.kind() == Kind.CHOICE || point.kind() == Kind.FORK || point.kind() == Kind.JOIN;
        }

        private String label(String key) {
            return labels.getOrDefault(key, key);
        }

        private void states(List<Region> regions, String parent) {
            for (int i = 0; i < regions.size(); i++) {
                for (Vertex vertex : regions.get(i).vertices()) {
                    if (vertex instanceof ChartState state) {
                        String name = label(state.key());
                        String behavior = state.entry() + " " + state.exit() + " " + state.doActivities() + " "
                                + state.deferred();
                        states.add(new StateFact(name, parent, i, state.use(), behavior));
                        state.internal().forEach(this::arc);
                        states(state.regions(), name);
                    }
                }
                regions.get(i).arcs().forEach(this::arc);
            }
        }

        private void arc(Arc arc) {
            List<String> triggers = arc.triggers().stream()
                    .map(trigger -> arc.keywords(trigger) + trigger)
                    .toList();
            ArcFact fact = new ArcFact(
                    label(arc.source()), label(arc.target()), triggers, arc.guard(), arc.effects(), arc.kind());
            arcs.add(fact);
            lines.computeIfAbsent(fact, first -> new HashSet<>())
                    .add(arc.place().line());
        }
    }

    private List<ArcFact> allArcs() {
        List<ArcFact> all = new ArrayList<>();
        arcs.forEach((arc, times) -> {
            for (int i = 0; i < times; i++) {
                all.add(arc);
            }
        });
        return all;
    }

    private ChartFacts with(Iterable<StateFact> newStates, List<ArcFact> newArcs) {
        return new ChartFacts(newStates, newArcs, lines);
    }

    private ChartFacts mapped(UnaryOperator<StateFact> state, UnaryOperator<ArcFact> arc) {
        return with(
                states.stream().map(state).toList(), allArcs().stream().map(arc).toList());
    }

    private Predicate<ArcFact> in(int line) {
        return arc -> lines.getOrDefault(arc, Set.of()).contains(line);
    }

    boolean hasState(String name) {
        return states.stream().anyMatch(state -> state.name().equals(name));
    }

    ChartFacts withState(String name, String parent, ChartFacts after) {
        List<StateFact> all = new ArrayList<>(states);
        all.add(new StateFact(name, parent, 0, DeviceUse.NONE, "[] [] [] []"));
        String start = Kind.INITIAL.name() + " in region 0 of " + parent;
        List<ArcFact> changed = allArcs();
        if (changed.stream().noneMatch(arc -> arc.source().equals(start))) {
            after.allArcs().stream()
                    .filter(arc -> arc.source().equals(start) && arc.target().equals(name))
                    .forEach(changed::add);
        }
        return with(all, changed);
    }

    /** One transition more; what its label says is that of the text. */
    ChartFacts withOneMore(String source, String target, ChartFacts after) {
        List<ArcFact> more = after.allArcs();
        allArcs().forEach(more::remove);
        List<ArcFact> all = allArcs();
        if (!more.isEmpty()
                && more.stream().anyMatch(arc -> arc.source().equals(source))
                && more.stream().anyMatch(arc -> arc.target().equals(target))) {
            all.addAll(more);
        }
        return with(states, all);
    }

    ChartFacts renamed(String from, String to) {
        UnaryOperator<String> name = old -> old.equals(from)
                ? to
                : old.endsWith(" of " + from) && old.contains(" in region ")
                        ? old.substring(0, old.length() - from.length()) + to
                        : old;
        return mapped(
                state -> new StateFact(
                        name.apply(state.name()),
                        name.apply(state.parent()),
                        state.region(),
                        state.use(),
                        state.behavior()),
                arc -> new ArcFact(
                        name.apply(arc.source()),
                        name.apply(arc.target()),
                        arc.triggers(),
                        arc.guard(),
                        arc.effects(),
                        arc.kind()));
    }

    ChartFacts withDeviceRenamed(String from, String to) {
        return mapped(state -> state.use().device().equals(from) ? used(state, to) : state, arc -> arc);
    }

    ChartFacts withDevice(String name, String device) {
        return mapped(state -> state.name().equals(name) ? used(state, device) : state, arc -> arc);
    }

    private static StateFact used(StateFact state, String device) {
        DeviceUse use = new DeviceUse(device, state.use().sends());
        return new StateFact(state.name(), state.parent(), state.region(), use, state.behavior());
    }

    /** The transitions of one line with other labels, those of {@code after}. */
    ChartFacts relabelled(int line, ChartFacts after) {
        List<ArcFact> all = allArcs();
        all.removeIf(in(line));
        List<ArcFact> there = after.allArcs().stream().filter(after.in(line)).toList();
        List<ArcFact> here = allArcs().stream().filter(in(line)).toList();
        boolean same = !here.isEmpty()
                && !there.isEmpty()
                && here.get(0).kind() == there.get(0).kind()
                && ends(here).equals(ends(there))
                && effects(here).equals(effects(there));
        all.addAll(same ? there : here);
        return with(states, all);
    }

    /** The states at both ends of a chain of transitions. */
    private static Set<String> ends(List<ArcFact> chain) {
        Set<String> ends = new HashSet<>();
        chain.forEach(arc -> ends.addAll(List.of(arc.source(), arc.target())));
        ends.removeIf(end -> end.startsWith(Kind.JUNCTION.name() + " in region"));
        return ends;
    }

    private static Set<String> effects(List<ArcFact> chain) {
        Set<String> effects = new HashSet<>();
        chain.forEach(arc -> effects.addAll(arc.effects()));
        return effects;
    }

    ChartFacts startingIn(String state, ChartFacts after) {
        StateFact fact = states.stream()
                .filter(each -> each.name().equals(state))
                .findFirst()
                .orElseThrow(() -> new ModelException("there is no state named " + state));
        String start = Kind.INITIAL.name() + " in region " + fact.region() + " of " + fact.parent();
        List<ArcFact> all = allArcs();
        all.removeIf(arc -> arc.source().equals(start));
        after.allArcs().stream()
                .filter(arc -> arc.source().equals(start) && arc.target().equals(state))
                .forEach(all::add);
        return with(states, all);
    }

    ChartFacts retargeted(int line, String source, String target) {
        Predicate<ArcFact> meant = in(line);
        return mapped(
                state -> state,
                arc -> !meant.test(arc)
                        ? arc
                        : new ArcFact(
                                source.isEmpty() ? arc.source() : source,
                                target.isEmpty() ? arc.target() : target,
                                arc.triggers(),
                                arc.guard(),
                                arc.effects(),
                                arc.kind()));
    }

    ChartFacts without(int line) {
        List<ArcFact> all = allArcs();
        all.removeIf(in(line));
        return with(states, all);
    }

    ChartFacts withoutState(String name) {
        Set<String> gone = new HashSet<>(Set.of(name));
        boolean more = true;
        while (more) {
            more = states.stream()
                    .filter(state -> gone.contains(state.parent()))
                    .map(StateFact::name)
                    .anyMatch(gone::add);
        }
        List<ArcFact> all = allArcs();
        all.removeIf(arc -> isIn(arc.source(), gone) || isIn(arc.target(), gone));
        return with(
                states.stream().filter(state -> !gone.contains(state.name())).toList(), all);
    }

    private static boolean isIn(String label, Set<String> states) {
        return states.stream()
                .anyMatch(state ->
                        label.equals(state) || (label.contains(" in region ") && label.endsWith(" of " + state)));
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof ChartFacts that && states.equals(that.states) && arcs.equals(that.arcs);
    }

    @Override
    public int hashCode() {
        return states.hashCode();
    }

    @Override
    public String toString() {
        return states + " " + arcs;
    }
}
