package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** Draws statecharts for tests; a vertex's name is its key, each state says when it is entered and left. */
final class Draw {
    private Draw() {}

    static Statechart chart(Region top, Arc... arcs) {
        Region all = new Region(top.name(), top.place(), top.vertices(), List.of(arcs));
        return new Statechart("chart", new Place("chart", 1), List.of(all), List.of());
    }

    static Region region(Vertex... vertices) {
        return new Region("", Place.NONE, List.of(vertices), List.of());
    }

    static ChartState state(String key, Region... regions) {
        return new ChartState(
                key,
                key,
                place(key),
                List.of("+" + key),
                List.of("-" + key),
                List.of(),
                List.of(),
                List.of(),
                List.of(regions),
                List.of());
    }

    static ChartState named(String key, String name, Region... regions) {
        ChartState state = state(key, regions);
        return new ChartState(
                key,
                name,
                state.place(),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                state.regions(),
                List.of());
    }

    static ChartState doing(String key, String activity, Region... regions) {
        return new ChartState(
                key,
                key,
                place(key),
                List.of(),
                List.of(),
                List.of(activity),
                List.of(),
                List.of(),
                List.of(regions),
                List.of());
    }

    static ChartState with(ChartState state, Pseudostate... connections) {
        return new ChartState(
                state.key(),
                state.name(),
                state.place(),
                state.entry(),
                state.exit(),
                state.doActivities(),
                state.internal(),
                state.deferred(),
                state.regions(),
                List.of(connections));
    }

    static Pseudostate pseudo(String key, Kind kind) {
        return new Pseudostate(key, key, place(key), kind);
    }

    static Pseudostate initial(String key) {
        return pseudo(key, Kind.INITIAL);
    }

    static FinalState end(String key) {
        return new FinalState(key, key, place(key));
    }

    /** {@code source target trigger [guard] / effect}, of which all but the first two may lack. */
    static Arc arc(String text) {
        return arc(text, Arc.Kind.EXTERNAL);
    }

    static Arc local(String text) {
        return arc(text, Arc.Kind.LOCAL);
    }

    private static Arc arc(String text, Arc.Kind kind) {
        List<String> effects = new ArrayList<>();
        String rest = text;
        if (rest.contains(" / ")) {
            effects.add(rest.substring(rest.indexOf(" / ") + 3));
            rest = rest.substring(0, rest.indexOf(" / "));
        }
        String guard = "";
        if (rest.endsWith("]")) {
            guard = rest.substring(rest.indexOf('[') + 1, rest.length() - 1);
            rest = rest.substring(0, rest.indexOf('[')).strip();
        }
        List<String> words = List.of(rest.split(" "));
        return new Arc(place(text), words.get(0), words.get(1), words.subList(2, words.size()), guard, effects, kind);
    }

    private static Place place(String text) {
        return new Place("id-" + text.split(" ")[0], 7);
    }

    static List<String> lines(StateMachine machine) {
        return machine.transitions().stream().map(Draw::line).toList();
    }

    private static String line(Transition transition) {
        return transition
                + (transition.effects().isEmpty() ? "" : " / " + String.join(" ", transition.effects()))
                + (transition.internal() ? " internal" : "");
    }
}
