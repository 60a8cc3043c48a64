/**
 * State machines as pictures: what to draw ({@link org.evoloop.models.diagram.Diagram}), its layout (Eclipse ELK's
 * layered algorithm), and the SVG.
 *
 * <p>This package may use {@code statemachine} and {@code statechart}. It reads and writes no files.
 */
@NullMarked
package org.evoloop.models.diagram;

import org.jspecify.annotations.NullMarked;
