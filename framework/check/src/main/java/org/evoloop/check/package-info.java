/**
 * The checks of an evolution at design time: named rules over two state machines and every pair of their states that
 * can be reached, found by the very decisions that run. {@link org.evoloop.check.Check} is the way in.
 *
 * <p>This package may use {@code org.evoloop.evolution} and {@code org.evoloop.statemachine} only. It knows no files:
 * who reads models from files knows where an {@link org.evoloop.check.Element} stands.
 */
@NullMarked
package org.evoloop.check;

import org.jspecify.annotations.NullMarked;
