/**
 * The checks of an evolution at design time: named rules about two state machines and every reachable pair of their
 * states, computed from the same decisions as at run time. {@link org.evoloop.check.Check} is the entry point.
 *
 * <p>This package may use {@code org.evoloop.evolution} and {@code org.evoloop.statemachine} only. It knows no files:
 * the code that reads models from files knows the place of an {@link org.evoloop.check.Element}.
 */
@NullMarked
package org.evoloop.check;

import org.jspecify.annotations.NullMarked;
