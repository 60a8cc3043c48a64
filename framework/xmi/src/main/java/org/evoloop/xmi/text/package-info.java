/**
 * State machines as text: state diagrams of Mermaid and PlantUML, in files of their own or in blocks of Markdown. A
 * {@link org.evoloop.xmi.text.TextFile} is split into blocks, one machine each; {@link org.evoloop.xmi.text.Statements}
 * reads a block line by line into a tree of states, which becomes a chart. Each line is used, known to have no effect on
 * behavior, or reported with line and column.
 *
 * <p>This package may use {@code org.evoloop.statechart}, {@code org.evoloop.statemachine} and {@code dialect}.
 */
@NullMarked
package org.evoloop.xmi.text;

import org.jspecify.annotations.NullMarked;
