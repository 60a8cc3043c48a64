package org.evoloop.models.checking;

import java.util.Optional;
import java.util.stream.Stream;
import org.evoloop.evolution.check.Element;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/** Where the parts of a flat machine stand in the drawing that it comes from, as well as names tell. */
public final class Drawing {
    private final String file;
    private final ChartIndex index;

    /** @param file for messages */
    public Drawing(String file, Statechart chart) {
        this.file = file;
        this.index = new ChartIndex(chart);
    }

    /** {@code robot.xml, line 12, id ek-39}, or the file alone if nothing in it has the name. */
    public String place(Element element) {
        String where = find(element).map(Place::toString).orElse("");
        return where.isEmpty() ? file : file + ", " + where;
    }

    private Optional<Place> find(Element element) {
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

    private Optional<ChartState> state(State flat) {
        return index.states().stream()
                .filter(state -> index.name(state.key()).equals(flat.name()))
                .findFirst()
                .or(() -> index.states().stream()
                        .filter(state -> flat.name().contains(state.name()))
                        .findFirst());
    }

    private Stream<Arc> triggered(String event) {
        return index.arcs().stream().filter(arc -> arc.triggers().contains(event));
    }

    /** The one that leaves the state or a state around it, the inner one first; else any of the event. */
    private Optional<Arc> transition(Transition flat) {
        String event = flat.event().name();
        for (String source = flat.source().name(); !source.isEmpty(); source = parentOf(source)) {
            String name = source;
            Optional<Arc> leaving = triggered(event)
                    .filter(arc -> index.name(arc.source()).equals(name))
                    .findFirst();
            if (leaving.isPresent()) {
                return leaving;
            }
        }
        return triggered(event).findFirst();
    }

    private String parentOf(String name) {
        return index.states().stream()
                .filter(state -> index.name(state.key()).equals(name))
                .findFirst()
                .map(state -> index.parent(state.key()))
                .orElse("");
    }
}
