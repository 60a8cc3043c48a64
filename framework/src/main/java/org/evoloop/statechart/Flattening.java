package org.evoloop.statechart;

import java.util.List;
import java.util.Map;
import org.evoloop.statemachine.StateMachine;

/** The flat machine that a statechart is equivalent to. */
public final class Flattening {
    private final StateMachine machine;

    private Flattening(StateMachine machine) {
        this.machine = machine;
    }

    public static Flattening of(Statechart chart) {
        var b = StateMachine.named(chart.name());
        Map<String, Vertex> byKey = new java.util.LinkedHashMap<>();
        for (Region r : chart.regions())
            for (Vertex v : r.vertices()) {
                byKey.put(v.key(), v);
                if (v instanceof Vertex.ChartState) b.state(v.name());
            }
        for (Region r : chart.regions())
            for (Arc a : r.arcs()) {
                Vertex s = byKey.get(a.source()), t = byKey.get(a.target());
                if (s == null || t == null) throw new org.evoloop.statemachine.ModelException("not flat");
                if (s instanceof Vertex.Pseudostate) b.initial(t.name());
                else
                    for (String e : a.triggers())
                        b.transition(s.name(), e, t.name(), a.place().toString());
            }
        return new Flattening(b.build());
    }

    public static StateMachine flatten(Statechart chart) {
        return of(chart).machine();
    }

    public List<Problem> problems() {
        return List.of();
    }

    public StateMachine machine() {
        return machine;
    }
}
