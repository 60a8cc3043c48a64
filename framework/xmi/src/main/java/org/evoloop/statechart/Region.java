package org.evoloop.statechart;

import java.util.List;

/**
 * A region: vertices of which one is active at a time, and the transitions listed with them in the file. A transition
 * may connect vertices of any regions of its machine.
 *
 * <p>Threading: immutable.
 *
 * @param name may be empty
 * @since 0.1
 */
public record Region(String name, Place place, List<Vertex> vertices, List<Arc> arcs) {
    public Region {
        vertices = List.copyOf(vertices);
        arcs = List.copyOf(arcs);
    }
}
