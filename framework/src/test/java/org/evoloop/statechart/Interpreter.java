package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;

/**
 * Runs a statechart as UML 2.5.1 (clause 14.2.3) says, vertex by vertex and without any preparation. Slow and simple; it
 * shares nothing with {@link Flattening} but the choices that its Javadoc states.
 */
final class Interpreter {
    /** Of an event: the name of the state whose timer or activity it is follows behind the text. */
    static final String OWNER = "@";

    private final Statechart chart;
    private final Map<String, Vertex> byKey = new HashMap<>();
    private final Map<String, List<Region>> around = new HashMap<>();
    private final Map<String, ChartState> borderOf = new HashMap<>();
    private final List<Arc> arcs = new ArrayList<>();
    private final List<String> order = new ArrayList<>();

    private final Map<Region, Vertex> current = new IdentityHashMap<>();
    private final Map<Region, List<Vertex>> memory = new IdentityHashMap<>();
    private final Set<String> done = new HashSet<>();
    private final List<String> complete = new ArrayList<>();
    private final Map<String, Integer> enteredAt = new HashMap<>();
    private boolean terminated;
    private String terminator = "";

    private List<String> actions = new ArrayList<>();
    private Predicate<String> guards = guard -> true;
    private int now;

    Interpreter(Statechart chart) {
        this.chart = chart;
        chart.regions().forEach(region -> learn(region, List.of()));
    }

    private void learn(Region region, List<Region> outer) {
        List<Region> here = Stream.concat(outer.stream(), Stream.of(region)).toList();
        arcs.addAll(region.arcs());
        for (Vertex vertex : region.vertices()) {
            byKey.put(vertex.key(), vertex);
            around.put(vertex.key(), here);
            order.add(vertex.key());
            if (vertex instanceof ChartState state) {
                arcs.addAll(state.internal());
                state.connections().forEach(point -> {
                    byKey.put(point.key(), point);
                    around.put(point.key(), here);
                    borderOf.put(point.key(), state);
                });
                state.regions().forEach(inner -> learn(inner, here));
            }
        }
    }

    /** What ran when the machine started. */
    List<String> start(Predicate<String> guardValues) {
        begin(guardValues);
        chart.regions().forEach(region -> enter(region, Set.of()));
        runCompletions();
        return actions;
    }

    /** What an event made run; null if nothing was enabled. */
    List<String> dispatch(String event, Predicate<String> guardValues) {
        begin(guardValues);
        if (terminated) {
            return null;
        }
        if (event.startsWith("completion" + OWNER)) {
            ChartState state = state(event.substring(event.indexOf(OWNER) + 1));
            if (!isActive(state)
                    || done.contains(state.key())
                    || !waits(state)
                    || state.doActivities().isEmpty()) {
                return null;
            }
            done.add(state.key());
            checkComplete(state);
        } else {
            List<List<Arc>> fires = new ArrayList<>();
            chart.regions().forEach(region -> fires.addAll(enabled(region, event)));
            List<List<Arc>> chosen = withoutConflicts(fires);
            if (chosen.isEmpty()) {
                return null;
            }
            chosen.forEach(this::fire);
        }
        runCompletions();
        return actions;
    }

    private void begin(Predicate<String> guardValues) {
        actions = new ArrayList<>();
        guards = guardValues;
        now++;
    }

    /** The innermost active vertices, in document order. */
    List<String> leaves() {
        if (terminated) {
            return List.of(terminator);
        }
        return order.stream()
                .filter(key -> isActive(vertex(key)))
                .filter(key -> !(vertex(key) instanceof ChartState state)
                        || state.regions().isEmpty())
                .toList();
    }

    /** Time triggers of active states, each with the event's number at which its state was entered. */
    List<String> timers() {
        return activeStates()
                .flatMap(state -> leaving(state)
                        .flatMap(arc -> arc.triggers().stream())
                        .distinct()
                        .filter(Interpreter::isTime)
                        .map(text -> text + " since " + enteredAt.get(state.key())))
                .sorted()
                .toList();
    }

    List<String> activities() {
        return activeStates()
                .flatMap(state -> state.doActivities().stream())
                .sorted()
                .toList();
    }

    static boolean isTime(String trigger) {
        return trigger.startsWith("tm(");
    }

    private Stream<ChartState> activeStates() {
        return order.stream()
                .map(this::vertex)
                .filter(this::isActive)
                .filter(ChartState.class::isInstance)
                .map(ChartState.class::cast);
    }

    private Vertex vertex(String key) {
        return byKey.get(key);
    }

    private ChartState state(String key) {
        return (ChartState) byKey.get(key);
    }

    private boolean isActive(Vertex vertex) {
        List<Region> regions = around.get(vertex.key());
        return current.get(regions.get(regions.size() - 1)) == vertex;
    }

    private Stream<Arc> leaving(Vertex vertex) {
        return arcs.stream().filter(arc -> arc.source().equals(vertex.key()));
    }

    private Stream<Arc> entering(Vertex vertex) {
        return arcs.stream().filter(arc -> arc.target().equals(vertex.key()));
    }

    private boolean is(Vertex vertex, Kind kind) {
        return vertex instanceof Pseudostate pseudostate && pseudostate.kind() == kind;
    }

    private boolean waits(ChartState state) {
        return leaving(state).anyMatch(arc -> arc.triggers().isEmpty());
    }

    private boolean isFinished(ChartState state) {
        return (state.doActivities().isEmpty() || done.contains(state.key()))
                && state.regions().stream().allMatch(region -> current.get(region) instanceof FinalState);
    }

    private void checkComplete(ChartState state) {
        if (waits(state) && isFinished(state) && !complete.contains(state.key())) {
            complete.add(state.key());
        }
    }

    // Selection

    private List<List<Arc>> enabled(Region region, String event) {
        if (!(current.get(region) instanceof ChartState state)) {
            return List.of();
        }
        List<List<Arc>> inner = new ArrayList<>();
        state.regions().forEach(child -> inner.addAll(enabled(child, event)));
        if (!inner.isEmpty()) {
            return inner;
        }
        String trigger = event.contains(OWNER) ? event.substring(0, event.indexOf(OWNER)) : event;
        boolean others = event.contains(OWNER) && !event.endsWith(OWNER + state.key());
        return others
                ? List.of()
                : choose(leaving(state).filter(arc -> arc.triggers().contains(trigger)));
    }

    /** The path that the first of some arcs opens: guarded arcs, plain arcs, else. */
    private List<List<Arc>> choose(Stream<Arc> candidates) {
        for (Arc arc : candidates.sorted(Comparator.comparingInt(this::rank)).toList()) {
            List<Arc> path = isTrue(arc) ? extend(arc, List.of()) : null;
            if (path != null) {
                return List.of(path);
            }
        }
        return List.of();
    }

    private int rank(Arc arc) {
        if (arc.guard().equals("else")) {
            return 2;
        }
        Vertex target = vertex(arc.target());
        boolean branches = is(target, Kind.JOIN)
                || (is(target, Kind.CHOICE) || is(target, Kind.JUNCTION))
                        && leaving(target).noneMatch(branch -> branch.guard().isEmpty());
        return arc.guard().isEmpty() && !branches ? 1 : 0;
    }

    private boolean isTrue(Arc arc) {
        return arc.guard().isEmpty() || arc.guard().equals("else") || guards.test(arc.guard());
    }

    private List<Arc> extend(Arc arc, List<Arc> before) {
        List<Arc> path = Stream.concat(before.stream(), Stream.of(arc)).toList();
        Vertex target = vertex(arc.target());
        if (!(target instanceof Pseudostate pseudostate)) {
            return path;
        }
        switch (pseudostate.kind()) {
            case CHOICE, JUNCTION -> {
                List<Arc> branches = leaving(target)
                        .filter(this::isTrue)
                        .sorted(Comparator.comparingInt(this::rank))
                        .toList();
                return branches.isEmpty() ? null : extend(branches.get(0), path);
            }
            case JOIN -> {
                boolean ready = entering(target)
                        .allMatch(segment -> isActive(vertex(segment.source()))
                                && isTrue(segment)
                                && (!segment.triggers().isEmpty() || isFinished(state(segment.source()))));
                return ready ? extend(leaving(target).findFirst().orElseThrow(), path) : null;
            }
            case ENTRY_POINT, EXIT_POINT -> {
                List<Arc> next = leaving(target).toList();
                return next.isEmpty() ? path : extend(next.get(0), path);
            }
            default -> {
                return path;
            }
        }
    }

    private List<List<Arc>> withoutConflicts(List<List<Arc>> fires) {
        List<List<Arc>> kept = new ArrayList<>();
        Set<String> taken = new HashSet<>();
        for (List<Arc> fire : fires) {
            Set<String> exits = fire.stream()
                    .filter(arc -> arc.kind() != Arc.Kind.INTERNAL)
                    .flatMap(arc -> exits(arc).stream())
                    .collect(Collectors.toSet());
            if (exits.stream().noneMatch(taken::contains)) {
                kept.add(fire);
                taken.addAll(exits);
            }
        }
        return kept;
    }

    private Set<String> exits(Arc arc) {
        Set<String> exits = new HashSet<>();
        Region scope = scope(arc);
        for (String key : order) {
            if (isActive(vertex(key)) && contains(around.get(key), scope)) {
                exits.add(key);
            }
        }
        ChartState border = borderOf.get(arc.target());
        if (is(vertex(arc.target()), Kind.EXIT_POINT) && isActive(border)) {
            exits.add(border.key());
            order.stream()
                    .filter(key -> isActive(vertex(key)) && isInside(border, vertex(key)))
                    .forEach(exits::add);
        }
        return exits;
    }

    private static boolean contains(List<Region> regions, Region wanted) {
        return regions.stream().anyMatch(region -> region == wanted);
    }

    private boolean isInside(ChartState outer, Vertex inner) {
        return outer.regions().stream().anyMatch(region -> contains(around.get(inner.key()), region));
    }

    /** The region that a transition disturbs. */
    private Region scope(Arc arc) {
        Vertex target = vertex(arc.target());
        if (is(target, Kind.JOIN)) {
            return entering(target)
                    .map(segment -> common(around.get(segment.source()), around.get(target.key())))
                    .min(Comparator.comparingInt(region -> depth(region)))
                    .orElseThrow();
        }
        ChartState from = arc.kind() == Arc.Kind.LOCAL && vertex(arc.source()) instanceof ChartState state
                ? state
                : is(vertex(arc.source()), Kind.ENTRY_POINT) ? borderOf.get(arc.source()) : null;
        ChartState to = is(target, Kind.EXIT_POINT) ? borderOf.get(arc.target()) : null;
        for (Region region : from == null ? List.<Region>of() : from.regions()) {
            if (contains(around.get(target.key()), region)) {
                return region;
            }
        }
        for (Region region : to == null ? List.<Region>of() : to.regions()) {
            if (contains(around.get(arc.source()), region)) {
                return region;
            }
        }
        return common(around.get(arc.source()), around.get(arc.target()));
    }

    private int depth(Region region) {
        return around.values().stream()
                .filter(regions -> regions.get(regions.size() - 1) == region)
                .mapToInt(List::size)
                .findFirst()
                .orElse(0);
    }

    private static Region common(List<Region> some, List<Region> others) {
        Region last = some.get(0);
        for (int i = 0; i < Math.min(some.size(), others.size()) && some.get(i) == others.get(i); i++) {
            last = some.get(i);
        }
        return last;
    }

    // Execution

    private void fire(List<Arc> path) {
        Set<ChartState> opened = new LinkedHashSet<>();
        for (Arc arc : path) {
            if (terminated) {
                return;
            }
            Vertex target = vertex(arc.target());
            if (arc.kind() == Arc.Kind.INTERNAL) {
                actions.addAll(arc.effects());
                return;
            }
            Region scope = scope(arc);
            exit(current.get(scope));
            if (is(target, Kind.JOIN)) {
                entering(target).forEach(segment -> actions.addAll(segment.effects()));
                continue;
            }
            actions.addAll(arc.effects());
            if (is(target, Kind.FORK)) {
                List<Arc> branches = leaving(target).toList();
                branches.forEach(branch -> actions.addAll(branch.effects()));
                Region outermost = branches.stream()
                        .map(branch -> common(around.get(target.key()), around.get(branch.target())))
                        .min(Comparator.comparingInt(this::depth))
                        .orElseThrow();
                enter(
                        outermost,
                        branches.stream().map(branch -> vertex(branch.target())).collect(Collectors.toSet()));
            } else if (is(target, Kind.TERMINATE)) {
                terminated = true;
                terminator = target.key();
                current.clear();
                complete.clear();
            } else if (is(target, Kind.EXIT_POINT)) {
                exit(borderOf.get(target.key()));
            } else if (is(target, Kind.ENTRY_POINT)) {
                ChartState border = borderOf.get(target.key());
                open(around.get(border.key()), scope, opened);
                activate(border);
                opened.add(border);
            } else if (is(target, Kind.CHOICE) || is(target, Kind.JUNCTION)) {
                open(around.get(target.key()), scope, opened);
            } else {
                enter(scope, Set.of(target));
            }
        }
        for (ChartState state : opened) {
            if (isActive(state)) {
                state.regions().forEach(region -> enter(region, Set.of()));
            }
        }
    }

    /** Enters the states between a region and the innermost of some regions, and nothing else of them. */
    private void open(List<Region> regions, Region scope, Set<ChartState> opened) {
        boolean inside = false;
        for (int i = 0; i < regions.size() - 1; i++) {
            inside |= regions.get(i) == scope;
            ChartState owner = ownerOf(regions.get(i + 1));
            if (inside && !isActive(owner)) {
                activate(owner);
                opened.add(owner);
            }
        }
    }

    private ChartState ownerOf(Region region) {
        return byKey.values().stream()
                .filter(ChartState.class::isInstance)
                .map(ChartState.class::cast)
                .filter(state -> contains(state.regions(), region))
                .findFirst()
                .orElseThrow();
    }

    private void exit(Vertex vertex) {
        if (vertex == null || !isActive(vertex)) {
            return;
        }
        if (vertex instanceof ChartState state) {
            for (Region region : state.regions()) {
                if (current.get(region) instanceof FinalState) {
                    memory.remove(region);
                } else if (current.get(region) != null) {
                    memory.put(region, activeIn(region));
                }
            }
            for (Region region : state.regions()) {
                exit(current.get(region));
            }
            actions.addAll(state.exit());
        }
        List<Region> regions = around.get(vertex.key());
        current.remove(regions.get(regions.size() - 1));
        done.remove(vertex.key());
        complete.remove(vertex.key());
        enteredAt.remove(vertex.key());
    }

    private List<Vertex> activeIn(Region region) {
        return order.stream()
                .map(this::vertex)
                .filter(vertex -> isActive(vertex) && contains(around.get(vertex.key()), region))
                .toList();
    }

    private void enter(Region region, Set<Vertex> targets) {
        if (terminated) {
            return;
        }
        for (Vertex vertex : region.vertices()) {
            boolean leads = targets.contains(vertex)
                    || vertex instanceof ChartState state
                            && targets.stream().anyMatch(target -> isInside(state, target));
            if (!leads) {
                continue;
            }
            if (is(vertex, Kind.SHALLOW_HISTORY) || is(vertex, Kind.DEEP_HISTORY)) {
                restore(region, vertex);
                return;
            }
            if (current.get(region) != vertex) {
                exit(current.get(region));
                activate(vertex);
            }
            if (vertex instanceof ChartState state) {
                state.regions().forEach(inner -> enter(inner, targets));
            }
            return;
        }
        if (current.get(region) == null) {
            byDefault(region);
        }
    }

    private void byDefault(Region region) {
        Vertex initial = region.vertices().stream()
                .filter(vertex -> is(vertex, Kind.INITIAL))
                .findFirst()
                .orElseThrow();
        fire(extend(leaving(initial).findFirst().orElseThrow(), List.of()));
    }

    private void restore(Region region, Vertex history) {
        exit(current.get(region));
        List<Vertex> remembered = memory.get(region);
        if (remembered == null) {
            leaving(history).findFirst().ifPresentOrElse(arc -> fire(extend(arc, List.of())), () -> byDefault(region));
        } else if (is(history, Kind.DEEP_HISTORY)) {
            enter(region, new HashSet<>(remembered));
        } else {
            enter(
                    region,
                    remembered.stream()
                            .filter(vertex -> region.vertices().contains(vertex))
                            .collect(Collectors.toSet()));
        }
    }

    private void activate(Vertex vertex) {
        List<Region> regions = around.get(vertex.key());
        current.put(regions.get(regions.size() - 1), vertex);
        enteredAt.put(vertex.key(), now);
        if (vertex instanceof ChartState state) {
            actions.addAll(state.entry());
            if (state.regions().isEmpty()) {
                checkComplete(state);
            }
        } else if (regions.size() > 1) {
            checkComplete(ownerOf(regions.get(regions.size() - 1)));
        }
    }

    private void runCompletions() {
        for (int round = 0; !complete.isEmpty(); round++) {
            if (round > 10_000) {
                throw new IllegalStateException("endless completion");
            }
            ChartState state = state(complete.remove(0));
            choose(leaving(state).filter(arc -> arc.triggers().isEmpty())).forEach(this::fire);
        }
    }

    @Override
    public String toString() {
        return leaves() + " " + Arrays.toString(complete.toArray());
    }
}
