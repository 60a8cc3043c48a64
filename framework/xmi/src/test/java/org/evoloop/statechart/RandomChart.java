package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;

/** Random statecharts with every construct, small enough to be read when a test fails. */
public final class RandomChart {
    static final List<String> EVENTS = List.of("a", "b", "c", "tm(1s)", "tm(2s)");
    static final List<String> GUARDS = List.of("g", "h");

    private final Random random;
    private final int size;
    private final List<ChartState> states = new ArrayList<>();
    private final List<String> targets = new ArrayList<>();
    private final List<Arc> arcs = new ArrayList<>();
    /** Joins, and the forks that are in the top region. */
    private final List<Vertex> extras = new ArrayList<>();
    /** The forks that are in no region yet. */
    private final List<Vertex> forks = new ArrayList<>();

    private final List<Runnable> later = new ArrayList<>();
    private int keys;

    private RandomChart(Random random, int size) {
        this.random = random;
        this.size = size;
    }

    /** @param size the number of states after which no state gets substates */
    public static Statechart draw(Random random, int size) {
        return new RandomChart(random, size).draw();
    }

    private Statechart draw() {
        Region top = region(0);
        later.forEach(Runnable::run);
        for (ChartState state : List.copyOf(states)) {
            for (int i = random.nextInt(3); i > 0; i--) {
                arc(state.key(), one(targets), triggers(), guard(), kind());
            }
        }
        return new Statechart(
                "random",
                Place.NONE,
                List.of(new Region("", Place.NONE, with(top.vertices(), with(forks, extras)), arcs)),
                List.of());
    }

    private static List<Vertex> with(List<Vertex> some, List<Vertex> others) {
        List<Vertex> all = new ArrayList<>(some);
        all.addAll(others);
        return all;
    }

    private Region region(int depth) {
        List<Vertex> vertices = new ArrayList<>();
        List<String> inner = new ArrayList<>();
        for (int i = 1 + random.nextInt(3); i > 0; i--) {
            ChartState state = state(depth);
            vertices.add(state);
            inner.add(state.key());
        }
        if (chance(50)) {
            vertices.addAll(forks);
            forks.clear();
        }
        if (chance(30)) {
            FinalState end = new FinalState(key("end"), "", Place.NONE);
            vertices.add(end);
            inner.add(end.key());
            targets.add(end.key());
        }
        if (chance(15)) {
            branching(vertices, targets);
        }
        if (chance(10)) {
            inner.add(branching(vertices, List.copyOf(inner)));
        }
        if (depth > 0 && chance(25)) {
            Kind kind = chance(50) ? Kind.DEEP_HISTORY : Kind.SHALLOW_HISTORY;
            String history = pseudostate(vertices, kind);
            targets.add(history);
            targets.add(history);
            if (chance(50)) {
                later.add(() -> arc(history, one(inner), List.of(), "", Arc.Kind.EXTERNAL));
            }
        }
        if (chance(3)) {
            targets.add(pseudostate(vertices, Kind.TERMINATE));
        }
        String initial = pseudostate(vertices, Kind.INITIAL);
        later.add(() -> arc(initial, one(inner), List.of(), "", Arc.Kind.EXTERNAL));
        java.util.Collections.shuffle(vertices, random);
        return new Region("", Place.NONE, vertices, List.of());
    }

    private ChartState state(int depth) {
        String key = key("s");
        List<Region> regions = new ArrayList<>();
        List<Pseudostate> connections = new ArrayList<>();
        if (depth < 3 && keys < 3 * size && chance(45)) {
            for (int i = chance(40) ? 2 : 1; i > 0; i--) {
                regions.add(region(depth + 1));
            }
            if (chance(20)) {
                List<Region> entered = chance(50) ? regions : List.of(one(regions));
                connections.add(point(
                        Kind.ENTRY_POINT,
                        entered.stream().map(region -> inside(List.of(region))).toList()));
            }
            if (chance(20)) {
                Pseudostate exit = point(Kind.EXIT_POINT, List.of(targets));
                connections.add(exit);
                List<String> sources = inside(regions);
                later.add(() -> arc(one(sources), exit.key(), triggers(), guard(), Arc.Kind.EXTERNAL));
            }
        }
        ChartState state = new ChartState(
                key,
                key.toUpperCase(java.util.Locale.ROOT),
                Place.NONE,
                chance(60) ? List.of("enter " + key) : List.of(),
                chance(60) ? List.of("exit " + key) : List.of(),
                chance(10) ? List.of("do " + key) : List.of(),
                chance(20)
                        ? List.of(new Arc(
                                Place.NONE,
                                key,
                                key,
                                List.of(one(EVENTS)),
                                guard(),
                                List.of("internal " + key),
                                Arc.Kind.INTERNAL))
                        : List.of(),
                chance(10) ? List.of(one(List.of("a", "b", "c"))) : List.of(),
                regions,
                connections);
        states.add(state);
        targets.add(key);
        if (regions.size() == 2) {
            if (chance(60)) {
                fork(regions);
            }
            if (chance(60)) {
                join(regions);
            }
        }
        return state;
    }

    private void fork(List<Region> regions) {
        String fork = pseudostate(forks, Kind.FORK);
        targets.add(fork);
        later.add(() ->
                regions.forEach(region -> arc(fork, one(inside(List.of(region))), List.of(), "", Arc.Kind.EXTERNAL)));
    }

    private void join(List<Region> regions) {
        String join = pseudostate(extras, Kind.JOIN);
        List<String> triggers = chance(50) ? List.of() : List.of(one(EVENTS));
        later.add(() -> {
            regions.forEach(region -> {
                List<String> sources = region.vertices().stream()
                        .filter(ChartState.class::isInstance)
                        .map(Vertex::key)
                        .toList();
                arc(one(sources), join, triggers, guard(), Arc.Kind.EXTERNAL);
            });
            arc(join, one(targets), List.of(), "", Arc.Kind.EXTERNAL);
        });
    }

    /** @param goals for each of its transitions */
    private Pseudostate point(Kind kind, List<List<String>> goals) {
        Pseudostate point = new Pseudostate(key("p"), "", Place.NONE, kind);
        if (kind == Kind.ENTRY_POINT) {
            targets.add(point.key());
        }
        later.add(() -> goals.forEach(some -> arc(point.key(), one(some), List.of(), "", Arc.Kind.EXTERNAL)));
        return point;
    }

    private String branching(List<Vertex> vertices, List<String> goals) {
        String choice = pseudostate(vertices, chance(50) ? Kind.CHOICE : Kind.JUNCTION);
        targets.add(choice);
        boolean safe = chance(70);
        later.add(() -> {
            arc(choice, one(goals), List.of(), one(GUARDS), Arc.Kind.EXTERNAL);
            if (safe) {
                arc(choice, one(goals), List.of(), chance(50) ? "else" : "", Arc.Kind.EXTERNAL);
            }
        });
        return choice;
    }

    private static List<String> inside(List<Region> regions) {
        return regions.stream()
                .flatMap(region -> region.vertices().stream())
                .filter(ChartState.class::isInstance)
                .map(Vertex::key)
                .toList();
    }

    private String pseudostate(List<Vertex> vertices, Kind kind) {
        Pseudostate pseudostate = new Pseudostate(key("p"), "", Place.NONE, kind);
        vertices.add(pseudostate);
        return pseudostate.key();
    }

    private void arc(String source, String target, List<String> triggers, String guard, Arc.Kind kind) {
        String key = key("t");
        List<String> effects = chance(70) ? List.of("effect " + key) : List.of();
        arcs.add(new Arc(new Place(key, 0), source, target, triggers, guard, effects, kind));
    }

    private List<String> triggers() {
        if (chance(12)) {
            return List.of();
        }
        String first = one(EVENTS);
        String second = one(EVENTS);
        return chance(15) && !first.equals(second) ? List.of(first, second) : List.of(first);
    }

    private String guard() {
        return chance(25) ? one(GUARDS) : "";
    }

    private Arc.Kind kind() {
        return chance(15) ? Arc.Kind.LOCAL : Arc.Kind.EXTERNAL;
    }

    private String key(String prefix) {
        return prefix + ++keys;
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    private <T> T one(List<T> some) {
        return some.get(random.nextInt(some.size()));
    }
}
