package org.evoloop.statechart;

import java.util.ArrayList;
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
import org.jspecify.annotations.Nullable;

/**
 * Runs a statechart according to UML 2.5.1 (clause 14.2.3), vertex by vertex and without any preparation. Slow and
 * simple; shares with {@link Flattening} only the choices that its Javadoc states.
 */
final class Interpreter {
    private final Statechart chart;
    private final Drawing drawing;

    private final IdentityHashMap<Region, Vertex> current = new IdentityHashMap<>();
    private final IdentityHashMap<Region, List<Vertex>> memory = new IdentityHashMap<>();
    private final Set<String> done = new HashSet<>();
    private final List<String> complete = new ArrayList<>();
    private final Map<String, Integer> enteredAt = new HashMap<>();
    private boolean terminated;
    private String terminator = "";

    private List<String> actions = new ArrayList<>();
    private Predicate<String> guards = guard -> true;
    private int now;
    private boolean waits;

    Interpreter(Statechart chart) {
        this.chart = chart;
        this.drawing = new Drawing(chart);
    }

    /** The behaviours that ran when the machine started. */
    List<String> start(Predicate<String> guardValues) {
        begin(guardValues);
        chart.regions().forEach(region -> enter(region, Set.of()));
        runCompletions();
        return actions;
    }

    /** The behaviours that an event ran; null if no transition was enabled. */
    @Nullable
    List<String> dispatch(String event, Predicate<String> guardValues) {
        begin(guardValues);
        if (terminated) {
            return null;
        }
        if (event.startsWith("completion" + Drawing.OWNER)) {
            ChartState state = drawing.state(event.substring(event.indexOf(Drawing.OWNER) + 1));
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
            List<List<Arc>> chosen = withoutConflicts(
                    fires.stream().filter(fire -> !fire.isEmpty()).toList());
            if (chosen.isEmpty()) {
                waits = !fires.isEmpty();
                return null;
            }
            chosen.forEach(this::fire);
        }
        runCompletions();
        return actions;
    }

    private void begin(Predicate<String> guardValues) {
        actions = new ArrayList<>();
        waits = false;
        guards = guardValues;
        now++;
    }

    /** Whether the last event was deferred. */
    boolean waits() {
        return waits;
    }

    /** The innermost active vertices, in document order. */
    List<String> leaves() {
        if (terminated) {
            return List.of(terminator);
        }
        return drawing.order.stream()
                .filter(key -> isActive(drawing.vertex(key)))
                .filter(key -> !(drawing.vertex(key) instanceof ChartState state)
                        || state.regions().isEmpty())
                .toList();
    }

    /** Time triggers of active states, each with the number of the event on which its state was entered. */
    List<String> timers() {
        return activeStates()
                .flatMap(state -> drawing.leaving(state)
                        .flatMap(arc -> arc.triggers().stream())
                        .distinct()
                        .filter(Drawing::isTime)
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

    private Stream<ChartState> activeStates() {
        return drawing.order.stream()
                .map(drawing::vertex)
                .filter(this::isActive)
                .filter(ChartState.class::isInstance)
                .map(ChartState.class::cast);
    }

    private boolean isActive(Vertex vertex) {
        return current.get(drawing.home(vertex)) == vertex;
    }

    private boolean waits(ChartState state) {
        return drawing.leaving(state).anyMatch(arc -> arc.triggers().isEmpty());
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

    /** The transitions that could be taken, and an empty list for each state that defers the event. */
    private List<List<Arc>> enabled(Region region, String event) {
        if (!(current.get(region) instanceof ChartState state)) {
            return List.of();
        }
        List<List<Arc>> inner = new ArrayList<>();
        state.regions().forEach(child -> inner.addAll(enabled(child, event)));
        if (!inner.isEmpty()) {
            return inner;
        }
        String trigger = event.contains(Drawing.OWNER) ? event.substring(0, event.indexOf(Drawing.OWNER)) : event;
        boolean others = event.contains(Drawing.OWNER) && !event.endsWith(Drawing.OWNER + state.key());
        if (others) {
            return List.of();
        }
        List<List<Arc>> own =
                choose(drawing.leaving(state).filter(arc -> arc.triggers().contains(trigger)));
        return own.isEmpty() && state.deferred().contains(event) ? List.of(List.of()) : own;
    }

    /** The path of the first enabled arc: guarded arcs first, then plain arcs, then else. */
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
        Vertex target = drawing.vertex(arc.target());
        boolean branches = drawing.is(target, Kind.JOIN)
                || ((drawing.is(target, Kind.CHOICE) || drawing.is(target, Kind.JUNCTION))
                        && drawing.leaving(target)
                                .noneMatch(branch -> branch.guard().isEmpty()));
        return arc.guard().isEmpty() && !branches ? 1 : 0;
    }

    private boolean isTrue(Arc arc) {
        return arc.guard().isEmpty() || arc.guard().equals("else") || guards.test(arc.guard());
    }

    private @Nullable List<Arc> extend(Arc arc, List<Arc> before) {
        List<Arc> path = Stream.concat(before.stream(), Stream.of(arc)).toList();
        Vertex target = drawing.vertex(arc.target());
        if (!(target instanceof Pseudostate pseudostate)) {
            return path;
        }
        switch (pseudostate.kind()) {
            case CHOICE, JUNCTION -> {
                List<Arc> branches = drawing.leaving(target)
                        .filter(this::isTrue)
                        .sorted(Comparator.comparingInt(this::rank))
                        .toList();
                return branches.isEmpty() ? null : extend(branches.get(0), path);
            }
            case JOIN -> {
                boolean ready = drawing.entering(target)
                        .allMatch(segment -> isActive(drawing.vertex(segment.source()))
                                && isTrue(segment)
                                && (!segment.triggers().isEmpty() || isFinished(drawing.state(segment.source()))));
                return ready ? extend(drawing.leaving(target).findFirst().orElseThrow(), path) : null;
            }
            case ENTRY_POINT, EXIT_POINT -> {
                List<Arc> next = drawing.leaving(target).toList();
                return next.size() != 1 ? path : extend(next.get(0), path);
            }
            default -> {
                return path;
            }
        }
    }

    /** An internal transition conflicts only with those that leave its state. */
    private List<List<Arc>> withoutConflicts(List<List<Arc>> fires) {
        List<List<Arc>> kept = new ArrayList<>();
        Set<String> taken = new HashSet<>();
        Set<String> internal = new HashSet<>();
        for (List<Arc> fire : fires) {
            boolean stays = fire.get(0).kind() == Arc.Kind.INTERNAL;
            Set<String> exits = exits(fire);
            if (stays
                    ? !taken.contains(fire.get(0).source())
                    : exits.stream().noneMatch(key -> taken.contains(key) || internal.contains(key))) {
                kept.add(fire);
                taken.addAll(exits);
                internal.addAll(stays ? Set.of(fire.get(0).source()) : Set.of());
            }
        }
        return kept;
    }

    private Set<String> exits(List<Arc> fire) {
        return fire.stream()
                .filter(arc -> arc.kind() != Arc.Kind.INTERNAL)
                .flatMap(arc -> exits(arc).stream())
                .collect(Collectors.toSet());
    }

    private Set<String> exits(Arc arc) {
        Set<String> exits = new HashSet<>();
        String loop = Drawing.loop(arc);
        if (loop != null) {
            drawing.order.stream()
                    .filter(key ->
                            isActive(drawing.vertex(key)) && drawing.isInside(drawing.state(loop), drawing.vertex(key)))
                    .forEach(exits::add);
            return exits;
        }
        Region scope = drawing.scope(arc);
        for (String key : drawing.order) {
            if (isActive(drawing.vertex(key)) && Drawing.contains(drawing.around(drawing.vertex(key)), scope)) {
                exits.add(key);
            }
        }
        Vertex target = drawing.vertex(arc.target());
        if (drawing.is(target, Kind.EXIT_POINT) && isActive(drawing.border(target))) {
            ChartState border = drawing.border(target);
            exits.add(border.key());
            drawing.order.stream()
                    .filter(key -> isActive(drawing.vertex(key)) && drawing.isInside(border, drawing.vertex(key)))
                    .forEach(exits::add);
        }
        return exits;
    }

    // Execution

    private void fire(List<Arc> path) {
        Set<ChartState> opened = new LinkedHashSet<>();
        for (Arc arc : path) {
            if (terminated) {
                return;
            }
            Vertex target = drawing.vertex(arc.target());
            if (arc.kind() == Arc.Kind.INTERNAL) {
                actions.addAll(arc.effects());
                return;
            }
            String loop = Drawing.loop(arc);
            if (loop != null) {
                List<Region> inside = drawing.state(loop).regions();
                inside.forEach(region -> exit(current.get(region)));
                actions.addAll(arc.effects());
                inside.forEach(region -> enter(region, Set.of()));
                return;
            }
            Region scope = drawing.scope(arc);
            exit(current.get(scope));
            if (drawing.is(target, Kind.JOIN)) {
                drawing.entering(target).forEach(segment -> actions.addAll(segment.effects()));
                continue;
            }
            actions.addAll(arc.effects());
            if (drawing.is(target, Kind.FORK)) {
                enter(scope, split(target));
            } else if (drawing.is(target, Kind.TERMINATE)) {
                terminated = true;
                terminator = target.key();
                current.clear();
                complete.clear();
            } else if (drawing.is(target, Kind.EXIT_POINT)) {
                exit(drawing.border(target));
            } else if (drawing.is(target, Kind.ENTRY_POINT)) {
                ChartState border = drawing.border(target);
                open(drawing.around(border), scope, opened);
                activate(border);
                opened.add(border);
                if (drawing.leaving(target).count() > 1) {
                    Set<Vertex> targets = split(target);
                    border.regions().forEach(region -> enter(region, targets));
                }
            } else if (drawing.is(target, Kind.CHOICE) || drawing.is(target, Kind.JUNCTION)) {
                open(drawing.around(target), scope, opened);
            } else {
                boolean around = target instanceof ChartState outer && Drawing.contains(outer.regions(), scope);
                enter(scope, around ? Set.of() : Set.of(target));
            }
        }
        for (ChartState state : opened) {
            if (isActive(state)) {
                state.regions().forEach(region -> enter(region, Set.of()));
            }
        }
    }

    private Set<Vertex> split(Vertex fork) {
        drawing.leaving(fork).forEach(branch -> actions.addAll(branch.effects()));
        return drawing.leaving(fork)
                .map(branch -> drawing.vertex(branch.target()))
                .collect(Collectors.toSet());
    }

    /** Enters only the states between a region and the innermost of some regions. */
    private void open(List<Region> regions, Region scope, Set<ChartState> opened) {
        boolean inside = false;
        for (int i = 0; i < regions.size() - 1; i++) {
            inside |= regions.get(i) == scope;
            ChartState owner = drawing.ownerOf(regions.get(i + 1));
            if (inside && !isActive(owner)) {
                activate(owner);
                opened.add(owner);
            }
        }
    }

    private void exit(@Nullable Vertex vertex) {
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
        current.remove(drawing.home(vertex));
        done.remove(vertex.key());
        complete.remove(vertex.key());
        enteredAt.remove(vertex.key());
    }

    private List<Vertex> activeIn(Region region) {
        return drawing.order.stream()
                .map(drawing::vertex)
                .filter(vertex -> isActive(vertex) && Drawing.contains(drawing.around(vertex), region))
                .toList();
    }

    private void enter(Region region, Set<Vertex> targets) {
        if (terminated) {
            return;
        }
        for (Vertex vertex : region.vertices()) {
            boolean leads = targets.contains(vertex)
                    || vertex instanceof ChartState state
                            && targets.stream().anyMatch(target -> drawing.isInside(state, target));
            if (!leads) {
                continue;
            }
            if (drawing.is(vertex, Kind.SHALLOW_HISTORY) || drawing.is(vertex, Kind.DEEP_HISTORY)) {
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
                .filter(vertex -> drawing.is(vertex, Kind.INITIAL))
                .findFirst()
                .orElseThrow();
        fire(path(drawing.leaving(initial).findFirst().orElseThrow()));
    }

    private void restore(Region region, Vertex history) {
        exit(current.get(region));
        List<Vertex> remembered = memory.get(region);
        if (remembered == null) {
            drawing.leaving(history).findFirst().ifPresentOrElse(arc -> fire(path(arc)), () -> byDefault(region));
        } else if (drawing.is(history, Kind.DEEP_HISTORY)) {
            enter(region, new HashSet<>(remembered));
        } else {
            enter(
                    region,
                    remembered.stream()
                            .filter(vertex -> region.vertices().contains(vertex))
                            .collect(Collectors.toSet()));
        }
    }

    private List<Arc> path(Arc first) {
        List<Arc> path = extend(first, List.of());
        if (path == null) {
            throw new IllegalStateException("no branch holds behind " + first);
        }
        return path;
    }

    private void activate(Vertex vertex) {
        current.put(drawing.home(vertex), vertex);
        enteredAt.put(vertex.key(), now);
        if (vertex instanceof ChartState state) {
            actions.addAll(state.entry());
            if (state.regions().isEmpty()) {
                checkComplete(state);
            }
        } else if (drawing.around(vertex).size() > 1) {
            checkComplete(drawing.ownerOf(drawing.home(vertex)));
        }
    }

    private void runCompletions() {
        for (int round = 0; !complete.isEmpty(); round++) {
            if (round > 10_000) {
                throw new IllegalStateException("endless completion");
            }
            ChartState state = drawing.state(complete.remove(0));
            choose(drawing.leaving(state).filter(arc -> arc.triggers().isEmpty()))
                    .forEach(this::fire);
        }
    }
}
