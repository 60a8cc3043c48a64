package org.evoloop.models.studio;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.models.checking.Drawing;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Flattening;
import org.evoloop.statechart.Statechart;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.studio.Source;
import org.jspecify.annotations.Nullable;

/** A machine of a request as drawn, with the identifiers of its transitions. */
final class Shown {
    private final Source source;
    private final Statechart chart;
    private final ChartIndex index;
    private final Map<Arc, String> ids = new LinkedHashMap<>();
    private @Nullable Flattening flattening;

    private Shown(Source source, Statechart chart) {
        this.source = source;
        this.chart = chart;
        this.index = new ChartIndex(chart);
        Map<Integer, Integer> onLine = new HashMap<>();
        for (Arc arc : index.arcs()) {
            int line = arc.place().line();
            ids.computeIfAbsent(arc, first -> {
                int number = onLine.merge(line, 1, Integer::sum);
                return "t" + line + (number > 1 ? "-" + number : "");
            });
        }
    }

    /** @throws org.evoloop.studio.MistakeException if it cannot be read */
    static Shown of(Source source) {
        return new Shown(source, source.read(() -> source.machine().statechart()));
    }

    Source source() {
        return source;
    }

    Statechart chart() {
        return chart;
    }

    ChartIndex index() {
        return index;
    }

    /** The identifier of a transition, from its line. */
    String id(Arc arc) {
        return ids.getOrDefault(arc, "");
    }

    int elements() {
        return index.vertices().size() + ids.size();
    }

    private Flattening flattening() {
        Flattening known = flattening;
        if (known == null) {
            known = Flattening.of(chart);
            flattening = known;
        }
        return known;
    }

    /** The flat machine; empty if there is none. */
    Optional<StateMachine> flat() {
        return flattening().problems().isEmpty() ? Optional.of(flattening().machine()) : Optional.empty();
    }

    /**
     * The flat machine.
     *
     * @throws org.evoloop.studio.MistakeException if there is none
     */
    StateMachine require() {
        return flat().orElseGet(() -> source.read(() -> source.machine().toStateMachine()));
    }

    /** Where the elements of the flat machine are drawn. */
    Drawing drawing() {
        return new Drawing(source.path(), chart, flattening(), flattening().machine());
    }
}
