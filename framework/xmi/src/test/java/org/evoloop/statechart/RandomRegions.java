package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;

/** Random statecharts as somebody would draw them: regions, histories, and at most one transition per state and event. */
final class RandomRegions {
    private final Random random;
    private final Shape shape;
    private final List<String> targets = new ArrayList<>();
    private final List<Arc> arcs = new ArrayList<>();
    /** By state, the states of its region. */
    private final Map<String, List<String>> beside = new HashMap<>();

    private boolean orthogonal;
    private int keys;

    /**
     * What is drawn, in percent.
     *
     * @param transitions that a state has a transition on an event
     * @param far that a transition leads anywhere, rather than to a state of its region
     */
    record Shape(int transitions, int far) {}

    private RandomRegions(Random random, Shape shape) {
        this.random = random;
        this.shape = shape;
    }

    /** A chart with orthogonal regions. */
    static Statechart draw(Random random, Shape shape) {
        while (true) {
            RandomRegions drawing = new RandomRegions(random, shape);
            Region top = drawing.region(0);
            if (drawing.orthogonal) {
                drawing.beside.keySet().stream().sorted().forEach(drawing::transitions);
                return new Statechart(
                        "random",
                        Place.NONE,
                        List.of(new Region("", Place.NONE, top.vertices(), drawing.arcs)),
                        List.of());
            }
        }
    }

    private Region region(int depth) {
        List<Vertex> vertices = new ArrayList<>();
        List<String> states = new ArrayList<>();
        String initial = pseudostate(Kind.INITIAL, vertices);
        for (int i = 2 + random.nextInt(2); i > 0; i--) {
            String key = "s" + ++keys;
            states.add(key);
            beside.put(key, states);
            targets.add(key);
            List<Region> regions = new ArrayList<>();
            if (depth < 2 && chance(45)) {
                int count = chance(50) ? 2 + random.nextInt(2) : 1;
                orthogonal |= count > 1;
                for (int k = 0; k < count; k++) {
                    regions.add(region(depth + 1));
                }
            }
            vertices.add(new ChartState(
                    key,
                    "S" + key.substring(1),
                    Place.NONE,
                    List.of("enter " + key),
                    List.of("exit " + key),
                    List.of(),
                    List.of(),
                    List.of(),
                    regions,
                    List.of()));
        }
        if (depth > 0 && chance(20)) {
            targets.add(pseudostate(chance(50) ? Kind.DEEP_HISTORY : Kind.SHALLOW_HISTORY, vertices));
        }
        arc(initial, states.get(0), List.of(), Arc.Kind.EXTERNAL);
        return new Region("", Place.NONE, vertices, List.of());
    }

    private String pseudostate(Kind kind, List<Vertex> vertices) {
        String key = "p" + ++keys;
        vertices.add(new Pseudostate(key, "", Place.NONE, kind));
        return key;
    }

    private void transitions(String state) {
        for (String event : RandomChart.EVENTS.subList(0, 3)) {
            if (chance(shape.transitions())) {
                List<String> some = chance(shape.far()) ? targets : beside.getOrDefault(state, targets);
                String target = some.get(random.nextInt(some.size()));
                boolean internal = target.equals(state) && chance(50);
                arc(state, target, List.of(event), internal ? Arc.Kind.INTERNAL : Arc.Kind.EXTERNAL);
            }
        }
    }

    private void arc(String source, String target, List<String> triggers, Arc.Kind kind) {
        String key = "t" + ++keys;
        arcs.add(new Arc(new Place(key, 0), source, target, triggers, "", List.of("effect " + key), kind));
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }
}
