/**
 * Machines as text: for people, as JSON, in Graphviz's dot and in PlantUML's language.
 *
 * <p>This room may use {@code chart} and {@code statechart}. It is pure.
 */
@NullMarked
package org.evoloop.models.format;

import org.jspecify.annotations.NullMarked;
