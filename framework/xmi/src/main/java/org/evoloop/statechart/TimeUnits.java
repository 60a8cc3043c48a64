package org.evoloop.statechart;

import java.time.temporal.ChronoUnit;
import java.util.List;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statemachine.Event;

/**
 * Adds a unit to the time triggers of a chart that have none.
 *
 * @since 0.1
 */
public final class TimeUnits {
    private final ChronoUnit unit;

    private TimeUnits(ChronoUnit unit) {
        this.unit = unit;
    }

    /**
     * A copy of the chart in which every time trigger has a unit.
     *
     * @param unit milliseconds or seconds
     */
    public static Statechart add(Statechart chart, ChronoUnit unit) {
        TimeUnits units = new TimeUnits(unit);
        return new Statechart(
                chart.name(),
                chart.place(),
                units.regions(chart.regions()),
                units.names(chart.events()),
                chart.semantics());
    }

    private List<Region> regions(List<Region> regions) {
        return regions.stream()
                .map(region -> new Region(
                        region.name(),
                        region.place(),
                        region.vertices().stream().map(this::vertex).toList(),
                        arcs(region.arcs())))
                .toList();
    }

    private Vertex vertex(Vertex vertex) {
        return vertex instanceof ChartState state
                ? new ChartState(
                        state.key(),
                        state.name(),
                        state.place(),
                        state.entry(),
                        state.exit(),
                        state.doActivities(),
                        arcs(state.internal()),
                        state.deferred(),
                        regions(state.regions()),
                        state.connections(),
                        state.use())
                : vertex;
    }

    private List<Arc> arcs(List<Arc> arcs) {
        return arcs.stream()
                .map(arc -> new Arc(
                        arc.place(),
                        arc.source(),
                        arc.target(),
                        names(arc.triggers()),
                        arc.guard(),
                        arc.effects(),
                        arc.kind(),
                        names(arc.spontaneous()),
                        names(arc.urgent()),
                        arc.order()))
                .toList();
    }

    private List<String> names(List<String> names) {
        return names.stream().map(name -> Event.withTimeUnit(name, unit)).toList();
    }
}
