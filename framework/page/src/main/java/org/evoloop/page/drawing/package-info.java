/**
 * Draws a machine as it runs, flat, as SVG: small enough for every converter, where {@code ./evoloop models show} draws
 * the model as its author drew it, with a layout library of many megabytes.
 *
 * <p>It uses only {@code org.evoloop.statemachine}.
 */
@NullMarked
package org.evoloop.page.drawing;

import org.jspecify.annotations.NullMarked;
