/**
 * Machines as plain text, as JSON, in Graphviz's dot and in PlantUML's language.
 *
 * <p>This package may use {@code chart}, {@code statechart} and {@code statemachine}. It does no I/O.
 */
@NullMarked
package org.evoloop.models.format;

import org.jspecify.annotations.NullMarked;
