/**
 * State machines as UML draws them: hierarchy, orthogonal regions, pseudostates, guards and behaviors, as values
 * without checks; and {@link org.evoloop.statechart.Flattening}, which finds the flat machine that accepts the same
 * events. On its way a chart becomes a net of nodes, the rules are checked, every state in which the machine can rest
 * is explored one run to completion at a time, states that only remember differently are merged, and what is found gets
 * names.
 *
 * <p>This room may use {@code org.evoloop.statemachine} alone.
 */
@NullMarked
package org.evoloop.statechart;

import org.jspecify.annotations.NullMarked;
