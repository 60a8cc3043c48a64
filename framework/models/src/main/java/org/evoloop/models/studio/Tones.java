package org.evoloop.models.studio;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.Drawing;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.models.evolution.ModelDifference;
import org.evoloop.models.evolution.ModelDifference.Rerouted;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Vertex;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * What the new model adds, reroutes and removes, in the drawings of both. A drawn element that stands for several flat
 * ones has a tone if none of them is kept.
 */
final class Tones {
    static final Tones NONE = new Tones();

    /** In one map, since places of the same line in one file are those of one machine. */
    private final Map<Vertex, Tone> vertices = new HashMap<>();

    private final Map<Arc, Tone> arcs = new HashMap<>();

    private Tones() {}

    static Tones of(ModelPair pair, Drawing original, Drawing evolved) {
        ModelDifference difference = ModelDifference.of(pair);
        Tones tones = new Tones();
        tones.states(difference.states().added(), pair.evolved().states(), evolved, Tone.ADDED);
        tones.states(difference.states().removed(), pair.original().states(), original, Tone.REMOVED);
        List<Transition> rerouted =
                difference.rerouted().stream().map(Rerouted::after).toList();
        tones.transitions(rerouted, pair.evolved().transitions(), evolved, Tone.REROUTED);
        tones.transitions(difference.transitions().added(), pair.evolved().transitions(), evolved, Tone.ADDED);
        tones.transitions(difference.transitions().removed(), pair.original().transitions(), original, Tone.REMOVED);
        return tones;
    }

    private void states(Collection<State> some, Collection<State> all, Drawing drawing, Tone tone) {
        Set<State> toned = new HashSet<>(some);
        Set<Vertex> kept = new HashSet<>();
        all.stream()
                .filter(state -> !toned.contains(state))
                .forEach(state -> drawing.state(state).ifPresent(kept::add));
        toned.forEach(state -> drawing.state(state)
                .filter(vertex -> !kept.contains(vertex))
                .ifPresent(vertex -> vertices.put(vertex, tone)));
    }

    private void transitions(Collection<Transition> some, Collection<Transition> all, Drawing drawing, Tone tone) {
        Set<Transition> toned = new HashSet<>(some);
        Set<Arc> kept = new HashSet<>();
        all.stream()
                .filter(transition -> !toned.contains(transition))
                .forEach(transition -> drawing.transition(transition).ifPresent(kept::add));
        toned.forEach(transition -> drawing.transition(transition)
                .filter(arc -> !kept.contains(arc))
                .ifPresent(arc -> arcs.put(arc, tone)));
    }

    Tone of(Vertex vertex) {
        return vertices.getOrDefault(vertex, Tone.PLAIN);
    }

    Tone of(Arc arc) {
        return arcs.getOrDefault(arc, Tone.PLAIN);
    }

    /** As the page knows it; null for nothing special. */
    static @Nullable String word(Tone tone) {
        return switch (tone) {
            case ADDED -> "added";
            case REROUTED -> "rerouted";
            case REMOVED -> "gone";
            default -> null;
        };
    }
}
