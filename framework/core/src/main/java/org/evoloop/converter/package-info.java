/**
 * The event converter (paper, sections III to V): the loop wired with the decisions. To build a converter, extend
 * {@link org.evoloop.converter.EventMonitor}, {@link org.evoloop.converter.EventExecute} and {@link
 * org.evoloop.converter.StateKnowledge}, and put them together in a {@link
 * org.evoloop.converter.SystemEventConverter}.
 *
 * <p>This package may use {@code org.evoloop.loop}, {@code org.evoloop.evolution}, {@code org.evoloop.function} and
 * what those use.
 */
@NullMarked
package org.evoloop.converter;

import org.jspecify.annotations.NullMarked;
