/**
 * State machines as pictures: what is to be drawn ({@link org.evoloop.models.diagram.Diagram}), where it goes (Eclipse
 * ELK's layered layout), and the SVG.
 *
 * <p>This room may use {@code statemachine} and {@code statechart}. It reads and writes no files.
 */
@NullMarked
package org.evoloop.models.diagram;

import org.jspecify.annotations.NullMarked;
