package org.evoloop.models.evolution;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.chart.FlatMachineChart;
import org.evoloop.models.diagram.ChartDiagram;
import org.evoloop.models.diagram.Diagram;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.statechart.Arc;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/** Both models in one picture. */
public final class DifferenceDiagram {
    private DifferenceDiagram() {}

    public static Diagram of(ModelPair pair) {
        ModelDifference difference = ModelDifference.of(pair);
        Map<Arc, Tone> arcTones = new HashMap<>();
        List<Transition> all = new ArrayList<>();
        add(difference.transitions().kept(), Tone.PLAIN, all, arcTones);
        add(difference.transitions().added(), Tone.ADDED, all, arcTones);
        difference.rerouted().forEach(both -> {
            add(List.of(both.after()), Tone.REROUTED, all, arcTones);
            add(List.of(both.before()), Tone.FORMER, all, arcTones);
        });
        add(difference.transitions().removed(), Tone.REMOVED, all, arcTones);
        Map<String, Tone> vertexTones = new HashMap<>();
        difference.states().added().forEach(state -> vertexTones.put(FlatMachineChart.key(state), Tone.ADDED));
        difference.states().removed().forEach(state -> vertexTones.put(FlatMachineChart.key(state), Tone.REMOVED));
        difference.uses().stream()
                .filter(changed -> !pair.isNew(changed.state()))
                .forEach(changed -> vertexTones.put(FlatMachineChart.key(changed.state()), Tone.REROUTED));
        List<State> states = Stream.concat(pair.evolved().states().stream(), difference.states().removed().stream())
                .toList();
        return ChartDiagram.of(
                FlatMachineChart.of(
                        pair.original().name() + " \u2192 " + pair.evolved().name(),
                        pair.evolved().initial(),
                        states,
                        all,
                        state -> pair.evolved().hasState(state) ? pair.evolved() : pair.original(),
                        List.of()),
                vertex -> vertexTones.getOrDefault(vertex.key(), Tone.PLAIN),
                arc -> arcTones.getOrDefault(arc, Tone.PLAIN));
    }

    /** Internal transitions are drawn as loops, so that they can have a colour. */
    private static void add(List<Transition> some, Tone tone, List<Transition> all, Map<Arc, Tone> tones) {
        for (Transition transition : some) {
            Transition drawn = new Transition(
                    transition.source(), transition.event(), transition.target(), transition.effects(), false);
            all.add(drawn);
            tones.put(FlatMachineChart.arc(drawn), tone);
        }
    }
}
