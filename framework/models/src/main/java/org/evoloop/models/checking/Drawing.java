package org.evoloop.models.checking;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.evoloop.check.Element;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Flattening;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** Locates the elements of a flat machine in its drawing, as far as their names allow. */
public final class Drawing {
    private final String file;
    private final ChartIndex index;
    private final StateMachine machine;
    private final Map<List<String>, List<Vertex>> leaves = new HashMap<>();

    /**
     * Locates elements in {@code chart}.
     *
     * @param file for messages
     * @param flattening of the chart
     * @param machine the same flat machine, possibly with other names
     */
    public Drawing(String file, Statechart chart, Flattening flattening, StateMachine machine) {
        this.file = file;
        this.index = new ChartIndex(chart);
        this.machine = machine;
        flattening
                .leaves()
                .forEach((state, vertices) -> leaves.put(flattening.machine().paths(state), vertices));
    }

    /** Whether {@code element} was found in the drawing. */
    public boolean shows(Element element) {
        return find(element).isPresent();
    }

    /**
     * {@code robot.xml, line 12, id ek-39}, with the file that contains the element if that is imported; only the file if
     * the element is not found.
     */
    public String place(Element element) {
        Place where = find(element).orElse(Place.NONE);
        if (where.equals(Place.NONE)) {
            return file;
        }
        return where.file().isEmpty() ? file + ", " + where : where.toString();
    }

    /** Where {@code element} is, as far as that is known. */
    public Optional<Place> find(Element element) {
        if (element instanceof Element.OfState of) {
            return state(of.state()).map(Vertex::place);
        }
        if (element instanceof Element.OfTransition of) {
            return transition(of.transition()).map(Arc::place);
        }
        return element instanceof Element.OfEvent of
                ? triggered(of.event().name()).findFirst().map(Arc::place)
                : Optional.empty();
    }

    /** The drawn state; of several that are active, the first. */
    public Optional<Vertex> state(State flat) {
        return leaves(flat).stream().findFirst();
    }

    private List<Vertex> leaves(State flat) {
        return leaves.getOrDefault(machine.paths(flat), List.of());
    }

    private Stream<Arc> triggered(String event) {
        return index.arcs().stream().filter(arc -> arc.triggers().contains(event));
    }

    /**
     * The transition that leaves the state or an enclosing state, innermost first; else any transition with the event.
     */
    public Optional<Arc> transition(Transition flat) {
        String event = flat.event().name();
        for (Vertex leaf : leaves(flat.source())) {
            for (String key = leaf.key(); !key.isEmpty(); key = index.parentKey(key)) {
                String source = key;
                Optional<Arc> leaving = triggered(event)
                        .filter(arc -> arc.source().equals(source))
                        .findFirst();
                if (leaving.isPresent()) {
                    return leaving;
                }
            }
        }
        return triggered(event).findFirst();
    }
}
