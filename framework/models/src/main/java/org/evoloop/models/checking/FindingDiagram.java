package org.evoloop.models.checking;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Turn;
import org.evoloop.models.chart.FlatMachineChart;
import org.evoloop.models.diagram.ChartDiagram;
import org.evoloop.models.diagram.Diagram;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.models.diagram.Timing;
import org.evoloop.statechart.Arc;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** Findings as pictures: the machines, with the path to the finding and the affected element in colour. */
public final class FindingDiagram {
    private FindingDiagram() {}

    /** Both machines if the path runs through both, else only the affected one. */
    public static List<Diagram> of(ModelPair pair, Finding finding) {
        Stream<Diagram> original = Stream.of(draw(pair.original(), Element.ModelRole.ORIGINAL, finding));
        Stream<Diagram> evolved = Stream.of(draw(pair.evolved(), Element.ModelRole.NEW, finding));
        if (!finding.example().isEmpty()) {
            return Stream.concat(original, evolved).toList();
        }
        return (finding.element().side() == Element.ModelRole.ORIGINAL ? original : evolved).toList();
    }

    /** The timing diagrams, for findings in which time matters. */
    public static List<Timing> timings(List<Finding> findings) {
        return findings.stream()
                .filter(finding -> !finding.timed().isEmpty())
                .map(TimedExample::picture)
                .toList();
    }

    private static Diagram draw(StateMachine machine, Element.ModelRole side, Finding finding) {
        Set<Arc> arcs = new HashSet<>();
        Set<String> vertices = new HashSet<>();
        for (Turn turn : finding.example()) {
            taken(turn, side).forEach(transition -> arcs.add(FlatMachineChart.arc(transition)));
        }
        if (finding.element().side() == side) {
            if (finding.element() instanceof Element.OfState of) {
                vertices.add(FlatMachineChart.key(of.state()));
            } else if (finding.element() instanceof Element.OfTransition of) {
                arcs.add(FlatMachineChart.arc(of.transition()));
            }
        }
        return ChartDiagram.of(
                FlatMachineChart.of(
                        machine.withName(machine.name() + ": " + finding.rule().id())),
                vertex -> vertices.contains(vertex.key()) ? Tone.MARKED : Tone.PLAIN,
                arc -> arcs.contains(arc) ? Tone.MARKED : Tone.PLAIN);
    }

    private static List<Transition> taken(Turn turn, Element.ModelRole side) {
        if (side == Element.ModelRole.ORIGINAL) {
            return turn.decision().steps().stream().map(Step::transition).toList();
        }
        Transition transition = turn.decision().transition();
        return transition == null ? List.of() : List.of(transition);
    }
}
