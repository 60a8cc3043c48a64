/**
 * State machines as UML draws them: hierarchy, orthogonal regions, pseudostates, guards and behaviors, as unchecked
 * values. {@link org.evoloop.statechart.Flattening} finds the flat machine that accepts the same events. A chart that is
 * flat already becomes it directly. Otherwise, it connects a chart's vertices to a net, checks the rules, explores every
 * stable state one run-to-completion step at a time, merges states that differ only in irrelevant memory, and names the
 * result.
 *
 * <p>This package may use only {@code org.evoloop.statemachine}.
 */
@NullMarked
package org.evoloop.statechart;

import org.jspecify.annotations.NullMarked;
