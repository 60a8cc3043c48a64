/**
 * Timing requirements of an evolution, written in words beside the models ({@link org.evoloop.check.timing.TimeRules}):
 * decided before it runs, for everything that can happen ({@link org.evoloop.check.timing.TimeCheck}), and watched
 * while it runs ({@link org.evoloop.check.timing.TimeWatch}) by the same monitors ({@link
 * org.evoloop.check.timing.TimeMonitor}). docs/time.md describes the language.
 *
 * <p>This package may use {@code temporal}, {@code core}, {@code evolution} and {@code statemachine}. It reads no
 * files.
 */
@NullMarked
package org.evoloop.check.timing;

import org.jspecify.annotations.NullMarked;
